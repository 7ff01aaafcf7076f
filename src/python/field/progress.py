# SPDX-License-Identifier: BSD-3-Clause
"""How long a command that takes minutes has taken and will take."""
import time

EVERY = 10.0  # [s]


class Pace:
    """What is left to do, by the time that what is done has taken."""

    def __init__(self):
        self.began = self.printed = time.monotonic()

    def due(self, done, whole):
        """Every ten seconds "20 s, about 60 s left", otherwise "": `done` of a `whole`, in any unit."""
        now = time.monotonic()
        if now - self.printed <= EVERY or done <= 0.0:
            return ""
        self.printed = now
        return "%.0f s, about %.0f s left" % (now - self.began, (now - self.began) * max(whole - done, 0.0) / done)
