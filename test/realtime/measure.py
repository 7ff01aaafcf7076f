# SPDX-License-Identifier: BSD-3-Clause
"""One node in real time: what its diagnostics and the system say of it; and the same commands in lockstep."""
import time

import rospy
from diagnostic_msgs.msg import DiagnosticArray
from drill_rig_sim.msg import RigTruth
from drill_rig_sim.srv import StepSimulation
from processes import Hog, Listener, Node, stolen, stop, wait_for
from std_srvs.srv import Trigger


class Diagnostics:
    """The node's numbers as they come, once a wall second."""

    def __init__(self, node):
        self.name = node.namespace[1:] + '/rig_simulator:'
        self.all = []
        self.subscriber = rospy.Subscriber('/diagnostics', DiagnosticArray, self.take)

    def take(self, message):
        values = {pair.key: pair.value for status in message.status for pair in status.values if status.name.startswith(self.name)}
        if values:
            values['slow'] = any('slower than the requested speed' in status.message for status in message.status)
            self.all.append(values)

    def next(self):
        """The first that comes from now on."""
        before = len(self.all)
        return wait_for(lambda: self.all[before:], 'diagnostics')[0]

    def end(self):
        self.subscriber.unregister()


def started(args, **more):
    """A node that runs."""
    node = Node(args.program, dict({'scene': args.scene, 'rate': args.rate, 'play_program': 'true'}, **more))

    def runs():
        if node.process.poll() is not None:
            raise RuntimeError('the node has ended: ' + node.said())
        return node.namespace + '/pause' in [name for name, _ in rospy.get_master().getSystemState()[2][2]]
    wait_for(runs, 'the node')
    return node


def numbers(message):
    """Every number of a message, those inside it too, but for how it was sent."""
    values = {}
    for name in message.__slots__:
        value = getattr(message, name)
        if name in ('header', 'run_state'):
            continue
        if hasattr(value, '__slots__') and hasattr(value, '_type'):
            values.update({name + '.' + key: inner for key, inner in numbers(value).items()})
        else:
            values[name] = str(value)
    return values


def paused_state(node):
    """(stamp [ns], truth) of the rig, which stands from then on."""
    states = []
    subscriber = rospy.Subscriber(node.namespace + '/truth/rig_state', RigTruth, states.append)
    wait_for(lambda: states, 'truth/rig_state')
    rospy.ServiceProxy(node.namespace + '/pause', Trigger)()
    last = wait_for(lambda: [m for m in states if m.run_state == RigTruth.PAUSED], 'a paused state')[-1]
    subscriber.unregister()
    return last.header.stamp.to_nsec(), numbers(last)


def lockstep_state(args, stamp):
    """The truth at this stamp [ns] where nothing but the number of frames matters."""
    node = started(args, clock='lockstep')
    subscriber, states = None, []
    try:
        step = rospy.ServiceProxy(node.namespace + '/step', StepSimulation)
        frames = round(1e-9 * stamp * args.rate) - 1  # the first stamp is the start
        while frames > 1:
            part = min(frames - 1, 50000)
            step(frames=part)
            frames -= part
        subscriber = rospy.Subscriber(node.namespace + '/truth/rig_state', RigTruth, states.append)
        wait_for(lambda: subscriber.get_num_connections() > 0, 'truth/rig_state')
        time.sleep(0.5)  # the publisher may take the connection up later
        step(frames=1)
        return numbers(wait_for(lambda: [m for m in states if m.header.stamp.to_nsec() == stamp], 'the state in lockstep')[-1])
    finally:
        if subscriber:
            subscriber.unregister()
        stop(node.process)


def watch(args, node, diagnostics):
    """[(phase, its first and last diagnostics, all between)]: one phase, or quiet, under the hog, quiet again."""
    phases = ('quiet', 'hog', 'after') if args.hog else ('quiet',)
    watched = []
    for phase in phases:
        hog = Hog() if phase == 'hog' else None
        try:
            first, seen = diagnostics.next(), len(diagnostics.all)
            time.sleep(60.0 * args.minutes / len(phases))
            watched.append((phase, first, diagnostics.next(), diagnostics.all[seen:]))
        finally:
            if hog:
                hog.end()
        if node.process.poll() is not None:
            raise RuntimeError('the node has ended: ' + node.said())
    return watched


def measured(args, name, parameters):
    """All that is known of a node with these parameters in real time."""
    node = started(args, **parameters)
    listener = Listener(args.listener, node, round(1e9 / args.rate))
    diagnostics = Diagnostics(node)
    try:
        before, cpu, kept = diagnostics.next(), node.cpu(), stolen()
        watched = watch(args, node, diagnostics)
        after, spent = diagnostics.next(), node.cpu()
        result = {'name': name, 'last': after, 'phases': watched, 'frames': int(after['frames']) - int(before['frames'])}
        result['stolen'] = stolen() - kept
        result['cpu'] = {kind: spent[kind] - cpu.get(kind, 0.0) for kind in spent}
        if args.hog:
            result['stamp'], result['truth'] = paused_state(node)
    finally:
        diagnostics.end()
        topics = listener.end()
        stop(node.process)
    result['topics'] = topics
    return result
