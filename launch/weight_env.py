#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A rig for a learner, as Gymnasium's environments are: hold 10 kN on bit by the block's speed. Run by itself it plays one episode by a fixed rule."""
import numpy
from drill_rig_sim.sim import Simulator


class WeightOnBit:
    """Observation: surface weight [N] and rate of penetration [m/s]. Action: speed of the block down, 0 to 0.015 [m/s], for a tenth of a second."""

    def __init__(self, scene="quick.yaml"):
        self.rig = Simulator(scene)

    def reset(self):
        self.rig.reset()
        self.rig.rotate(rpm=90)
        self.rig.winch(-0.01)
        self.rig.step(3.0)
        return self.seen(self.rig.tare()), {}

    def step(self, action):
        self.rig.winch(-min(max(action, 0.0), 0.015))
        state = self.rig.step(0.1)
        return self.seen(state), -abs(state.bit.wob - 10e3) / 10e3, state.truth.hole_depth > 100.2, state.t > 100.0, {}

    @staticmethod
    def seen(state):
        return numpy.array([state.surface_wob, state.rop])


def play(scene="quick.yaml"):
    """Rewards of an episode."""
    rig, speed, rewards, over = WeightOnBit(scene), 0.01, [], False
    (weight, _), _ = rig.reset()
    while not over:
        speed = min(max(speed + 5e-8 * (10e3 - weight), 0.0), 0.015)
        (weight, _), reward, done, cut, _ = rig.step(speed)
        rewards.append(reward)
        over = done or cut
    return rewards


if __name__ == "__main__":
    print("mean reward of the last half: %.3f" % numpy.mean(play()[-200:]))
