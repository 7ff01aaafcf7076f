# SPDX-License-Identifier: BSD-3-Clause
"""Why an input is refused: one line that any terminal and log can show, whatever the input holds."""
import contextlib

LONGEST = 700  # characters; the end of a longer text is left out


class Refusal(Exception):
    """What is wrong with an input and what is allowed, in one line. Signs that cannot be printed are escaped."""

    def __init__(self, text):
        text = "".join(sign if sign.isprintable() else repr(sign)[1:-1] for sign in text)
        super().__init__(text if len(text) <= LONGEST else text[:LONGEST - 3] + "...")


@contextlib.contextmanager
def after(remarks):
    """What is raised inside comes after the lines that `remarks()` returns then: what was noticed of an input that is refused."""
    try:
        yield
    except Exception as error:
        error.remarks = [*remarks(), *getattr(error, "remarks", ())]
        raise


def refusal_lines(command, error):
    """Lines of a command on an error: remarks that came before it and are not in its text, then the error."""
    before = [line for line in dict.fromkeys(getattr(error, "remarks", ())) if line.partition(": ")[2] not in str(error)]
    return "\n".join("%s: %s" % (command, line) for line in [*before, error])
