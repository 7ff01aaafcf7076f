#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's driller's readout: goes fast to just before the bit tags bottom, then shows the rig in real time, line by line."""
import argparse
import atexit
import math
import os
import signal
import sys
import threading
import time

import rospy
from drill_rig_sim.msg import Accuracy, RigTruth
from drill_rig_sim.recorder import Recorder
from drill_rig_sim.srv import SetSpeed
from std_srvs.srv import Trigger

GAP_FAST = 0.15  # bit above bottom where the fastest part ends and the weight is tared [m]
GAP_BEFORE_TAG = 0.03  # bit above bottom where the fast part ends [m]
FAST_SPEED = 40.0  # simulated seconds per wall second; faster, and a small scene is past the tag before it is seen
APPROACH_SPEED = 10.0  # the same between the two gaps
LONGEST_WAIT = 1800.0  # simulated seconds to wait for the bit to come near bottom


class Rig:
    """The last true state that the rig sent, and what was seen since mark(): a demo shows what no gauge sees."""

    def __init__(self, namespace):
        self.lock = threading.Lock()
        self.state = None
        self.errors = {}  # measured, of the simulation, by output [SI]
        self.heard = threading.Event()
        self.mark()
        self.set_speed = rospy.ServiceProxy(namespace + "/set_speed", SetSpeed)
        self.tare = rospy.ServiceProxy(namespace + "/tare", Trigger)
        rospy.Subscriber(namespace + "/truth/rig_state", RigTruth, self.take, queue_size=100)
        rospy.Subscriber(namespace + "/accuracy", Accuracy, self.take_errors, queue_size=1)

    def take(self, state):
        with self.lock:
            self.state = state
            if self.since is None:
                self.since = (state.header.stamp.to_sec(), time.monotonic(), state.hole_depth)
            if state.on_bottom and state.rop > 0:
                self.drilling.append((state.hook_load, state.torque, zeroed_weight(state), state.rop))
        self.heard.set()

    def take_errors(self, accuracy):
        self.errors = dict(zip(accuracy.outputs, accuracy.absolute)) if accuracy.measured else {}

    def mark(self):
        with self.lock:
            self.since = None
            self.drilling = []

    def elapsed(self):
        """Simulated seconds since mark(), the wall's, and the hole's depth then."""
        with self.lock:
            if self.since is None:
                return 0.0, 1e-9, self.state.hole_depth
            stamp, wall, depth = self.since
            return self.state.header.stamp.to_sec() - stamp, max(time.monotonic() - wall, 1e-9), depth


def zeroed_weight(state):
    """Surface WOB [N]; nan until it has been zeroed."""
    return state.surface_wob if state.tared else math.nan


def weight_text(weight, width=0):
    """In kN; a dash for nan."""
    return ("-" if math.isnan(weight) else "%.1f" % (weight / 1e3)).rjust(width)


def line(state, factor, errors):
    """`errors`: measured, by output [SI]; those that are not there are not shown."""
    def error(output, unit, digits):
        shown = errors.get(output, math.nan) / unit
        return "" if math.isnan(shown) else " ±%.*f" % (digits, max(shown, 10.0**-digits))
    return ("t %8.2f s  rtf %5.2f  hook %6.1f%s kN  torque %6.2f%s kN m  WOB %s%s kN  ROP %6.2f%s m/h  bit %8.3f m  %s" %
            (state.header.stamp.to_sec(), factor, state.hook_load / 1e3, error("hook_load", 1e3, 1), state.torque / 1e3, error("torque", 1e3, 2),
             weight_text(zeroed_weight(state), 6), error("wob", 1e3, 1) if state.tared else "", state.rop * 3600, error("rop", 1 / 3600, 2),
             state.bit_depth, "on bottom" if state.on_bottom else "off bottom"))


def show(text, last=False):
    if sys.stdout.isatty():
        print("\r" + text + "\x1b[K", end="\n" if last else "", flush=True)
    else:
        print(text, flush=True)


def alive(pid):
    if pid is None:
        return True
    try:
        os.kill(pid, 0)
        return True
    except OSError:
        return False


def ask(service, *arguments):
    answer = service(*arguments)
    if not answer.success:
        print("%s: %s" % (service.resolved_name, answer.message))


def within(gap, state):
    return state.on_bottom or state.hole_depth - state.bit_depth < gap


def go_near_bottom(rig, pid, every):
    """Fast-forwards to just before the bit tags bottom, with the weight on bit tared. False where the rig went away."""
    show("fast-forward to just before the bit tags bottom", last=True)
    for gap, speed in ((GAP_FAST, FAST_SPEED), (GAP_BEFORE_TAG, APPROACH_SPEED)):
        if not rig.state.on_bottom:
            ask(rig.tare)  # at rest first, then turning and circulating, which is the better zero
        rig.mark()
        ask(rig.set_speed, speed)
        if not watch(rig, pid, lambda state, simulated: within(gap, state) or simulated > LONGEST_WAIT, every):
            return False
    ask(rig.set_speed, 1.0)
    show("real time from here", last=True)
    return True


def wait_for(rig, pid, timeout):
    deadline = time.monotonic() + timeout
    while not rig.heard.wait(0.2):
        if not alive(pid) or time.monotonic() > deadline or rospy.is_shutdown():
            return False
    return True


def watch(rig, pid, until, every):
    """Shows a line each `every` wall seconds until `until(state, simulated)`. False where the rig went silent or away."""
    silent_since, stamp, next_line = time.monotonic(), None, 0.0
    while not rospy.is_shutdown():
        time.sleep(0.01)
        now = time.monotonic()
        state = rig.state
        if state.header.stamp != stamp:
            stamp, silent_since = state.header.stamp, now
        if not alive(pid) or now - silent_since > 20:
            return False
        simulated, wall, _ = rig.elapsed()
        if until(state, simulated):
            return True
        if now >= next_line:
            next_line = now + every
            show(line(state, simulated / wall, rig.errors))
    return False


def summary(rig):
    simulated, wall, depth = rig.elapsed()
    state = rig.state
    print("simulated %.2f s in %.2f s: real-time factor %.3f" % (simulated, wall, simulated / wall))
    print("hole depth %.3f m, of it %.3f m drilled in this time" % (state.hole_depth, state.hole_depth - depth))
    if rig.drilling:
        last = rig.drilling[len(rig.drilling) // 2:]
        means = [sum(column) / len(last) for column in zip(*last)]
        print("drilling, mean of the second half: hook load %.1f kN, torque %.2f kN m, WOB %s kN, ROP %.2f m/h" %
              (means[0] / 1e3, means[1] / 1e3, weight_text(means[2]), means[3] * 3600))
    else:
        print("the bit did not drill: hook load %.1f kN, torque %.2f kN m, WOB %s kN, ROP %.2f m/h" %
              (state.hook_load / 1e3, state.torque / 1e3, weight_text(zeroed_weight(state)), state.rop * 3600))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--duration", type=float, default=0.0, help="simulated seconds from just before the tag; 0: until Ctrl-C")
    parser.add_argument("--namespace", default="rig", help="of the rig")
    parser.add_argument("--record", metavar="FILE", help="time series of the whole run, as drill run --csv writes them")
    parser.add_argument("--watch", type=int, help="process id of the launcher; its end ends the readout")
    options = parser.parse_args()
    deadline = time.monotonic() + 60
    while not rospy.core.rosgraph.is_master_online():  # the launcher may still be starting it
        if time.monotonic() > deadline or not alive(options.watch):
            return 1
        time.sleep(0.2)
    rospy.init_node("readout", anonymous=True, disable_signals=True)

    rig = Rig("/" + options.namespace)
    if options.record:
        signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that the file ends with a whole line
        atexit.register(Recorder(options.record, "/" + options.namespace + "/").close)
    if not wait_for(rig, options.watch, 120):
        return 1
    every = 0.2 if sys.stdout.isatty() else 1.0
    if not within(GAP_BEFORE_TAG, rig.state) and not go_near_bottom(rig, options.watch, every):
        return 1
    rig.mark()
    if not watch(rig, options.watch, lambda state, simulated: 0 < options.duration <= simulated, every):
        return 1
    simulated, wall, _ = rig.elapsed()
    show(line(rig.state, simulated / wall, rig.errors), last=True)
    summary(rig)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (KeyboardInterrupt, rospy.ROSInterruptException):
        print()
        sys.exit(130)
