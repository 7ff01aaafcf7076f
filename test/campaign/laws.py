# SPDX-License-Identifier: BSD-3-Clause
"""Controllers of the campaigns' tests: what they do wrong is their parameter."""
import ctypes
import os
import signal
import sys
import time

from drill_rig_sim.law import Commands


class Law:
    """Turns the string, slowly while there is a file `slow`. `fault`: what else it does after a tenth of a second."""
    period, listens = 0.1, False

    def __init__(self, rpm=60.0, fault="", slow=""):
        self.rpm, self.fault, self.slow, self.steps, self.done = rpm, fault, slow, 0, False

    def step(self, readings):
        self.steps += 1
        if self.slow and os.path.exists(self.slow):
            time.sleep(0.3)
        if self.steps > 1 and self.fault:
            getattr(self, self.fault)()
        return Commands(top_drive={"mode": "SPEED", "speed": self.rpm * 0.10472})

    @staticmethod
    def error():
        raise KeyError("no such gauge")

    @staticmethod
    def sleep():
        time.sleep(1e6)

    @staticmethod
    def spin():
        while True:
            pass

    @staticmethod
    def hoard():
        kept = []
        while True:
            kept.append(bytearray(10**7))

    @staticmethod
    def crash():
        ctypes.string_at(0)

    @staticmethod
    def leave():
        sys.exit("no more of this")

    @staticmethod
    def vanish():
        os._exit(5)  # pylint: disable=protected-access

    @staticmethod
    def kill():
        os.kill(os.getpid(), signal.SIGKILL)

    @staticmethod
    def kill_worker():
        os.kill(os.getppid(), signal.SIGKILL)

    @staticmethod
    def chat():
        print("this is no answer")


def broken(played):
    return 1.0 / len(played.t[:0])


def wordy(_):
    return "well"


def turned(played):
    """Of the string's top [rad]."""
    return float((played.truth("top_drive_speed") * 0.1).sum())
