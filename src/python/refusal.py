# SPDX-License-Identifier: BSD-3-Clause
"""Why an input is refused: one line that any terminal and log can show, whatever the input holds."""
LONGEST = 700  # characters; the end of a longer text is left out


class Refusal(Exception):
    """What is wrong with an input and what is allowed, in one line. Signs that cannot be printed are escaped."""

    def __init__(self, text):
        text = "".join(sign if sign.isprintable() else repr(sign)[1:-1] for sign in text)
        super().__init__(text if len(text) <= LONGEST else text[:LONGEST - 3] + "...")
