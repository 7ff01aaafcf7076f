"""A law in a few lines: goes down, takes the zero of the weight off bottom, then feeds so that a weight stays on the bit."""
from drill_rig_sim.law import RPM, Commands


class FirstLaw:
    period, done = 0.1, False                    # between steps [s]; true: it has ended

    def __init__(self, weight, rpm=90.0):        # the parameters [N]
        self.weight, self.rpm, self.feed, self.seen = weight, rpm, 0.01, []

    def step(self, readings):
        if 10.0 <= readings.t < 20.0:            # on the way down, when nothing rings any more
            self.seen.append(readings.hook_load)
        elif self.seen:
            on_bit = sum(self.seen) / len(self.seen) - readings.hook_load
            self.feed = min(max(self.feed + 5e-8 * (self.weight - on_bit), 0.0), 0.02)
        return Commands(block_velocity=-self.feed, top_drive={"mode": "SPEED", "speed": self.rpm * RPM}, flow=0.02)
