#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Python module drill_rig_sim.rig against a stand-in of the node: which requests it makes, and when. The real one: test/rostest/rig_module.test"""
import copy
import unittest
from unittest import mock

import rospy
from drill_rig_sim import rig
from drill_rig_sim.srv import StepSimulationRequest, StepSimulationResponse

RATE = 250.0


class StandIn:
    """Answers `step` by moving a stamp, and every other service with what the test says; keeps what it was asked."""

    def __init__(self):
        self.time, self.requests, self.others, self.refusal = 1.0, [], [], ""

    def proxy(self, name, kind, persistent=False):
        if name == "/well/step":
            assert persistent
            return mock.Mock(call=self.step)

        def other(**fields):
            self.others.append((name, fields))
            return kind._response_class(success=not self.refusal, message=self.refusal)
        return other

    def step(self, request):
        self.requests.append(request)
        self.time += 0.0 if self.refusal else request.frames / RATE
        answer = StepSimulationResponse(success=not self.refusal, message=self.refusal)
        answer.state.header.stamp = rospy.Time.from_sec(self.time)
        answer.state.hook_load, answer.truth.hook_load, answer.truth.on_bottom = 1e5, 1.1e5, self.time > 1.55
        answer.bit.wob = self.time
        return answer


class AgainstAStandIn(unittest.TestCase):
    def setUp(self):
        self.node = StandIn()
        for target, stand_in in (("rospy.ServiceProxy", self.node.proxy), ("rospy.wait_for_service", mock.Mock()),
                                 ("drill_rig_sim.rig.frames_per_second", lambda service: RATE)):
            patch = mock.patch(target, stand_in)
            patch.start()
            self.addCleanup(patch.stop)
        self.rig = rig.Rig("well")

    def test_it_begins_with_a_look(self):
        self.assertEqual([StepSimulationRequest()], self.node.requests)
        self.assertEqual(1.0, self.rig.state.t)

    def test_a_set_point_is_sent_once_with_the_next_frames(self):
        self.rig.winch(-0.1)
        self.rig.winch(-0.2)  # in its place
        self.rig.rotate(rpm=60)
        self.rig.tare()
        self.assertEqual([], self.node.requests[-1].winch)  # a look
        self.rig.step(0.1)
        sent = self.node.requests[-1]
        self.assertEqual(25, sent.frames)
        self.assertEqual([-0.2], [c.block_velocity for c in sent.winch])
        self.assertAlmostEqual(6.283185307, sent.top_drive[0].speed, places=9)
        self.rig.step()
        self.assertEqual(StepSimulationRequest(frames=1), self.node.requests[-1])

    def test_a_rebuilt_rig_forgets_set_points(self):
        self.rig.pump(0.03)
        self.rig.reset(scene="quick.yaml", bit_depth=90.0)
        self.assertEqual([("/well/reset_well", {"scene": "quick.yaml", "bit_depth": 90.0})], self.node.others)
        self.rig.step()
        self.assertEqual([], self.node.requests[-1].mud_pump)

    def test_frames_are_all_stepped_through(self):
        self.assertEqual([10, 10, 5], [self.node.requests[-1].frames for _ in self.rig.frames(0.1, every=10)])
        self.assertEqual(26, round((self.rig.step().t - 1.0) * RATE))

    def test_conditions_end_the_stepping(self):
        state = self.rig.step_until(lambda s: s.truth.on_bottom, timeout=10.0, every=25)
        self.assertAlmostEqual(1.6, state.t, places=9)
        with self.assertRaisesRegex(rig.TimedOut, "not within 0.2 s, at t = 1.8 s"):
            self.rig.step_until(lambda s: False, timeout=0.2)

    def test_a_refusal_is_raised_with_its_reason(self):
        self.node.refusal = "the bit is on bottom"
        for call in (self.rig.step, self.rig.tare, lambda: self.rig.save("a"), lambda: self.rig.fault("STUCK_PIPE", depth=3.0)):
            with self.assertRaisesRegex(rig.Refused, "^the bit is on bottom$"):
                call()
        self.assertEqual(1.0, self.rig.state.t)

    def test_a_node_that_ends_is_one_clear_error(self):
        ends = (rospy.ServiceException("transport error completing service call"), rospy.exceptions.TransportTerminated("unable to receive"),
                BrokenPipeError("Broken pipe"))
        self.rig.step(0.1)
        for end in ends:
            self.node.step = mock.Mock(side_effect=end)
            with mock.patch.object(self.rig, "_step", mock.Mock(call=self.node.step)):
                with self.assertRaisesRegex(rig.Lost, r"^/well/step: the node does not answer after t = 1\.1 s \(.*\); start it again and make a new Rig$") as raised:
                    self.rig.step()
            self.assertIsNone(raised.exception.__cause__)
        with mock.patch("rospy.ServiceProxy", side_effect=ends[0]), self.assertRaisesRegex(rig.Lost, "^/well/tare: "):
            self.rig.tare()

    def test_faults_go_by_their_names(self):
        self.rig.fault("STUCK_PIPE", depth=3.0)
        self.rig.clear_fault("SENSOR_BIAS", target="hook_load")
        self.assertEqual([{"fault": 0, "clear": False, "depth": 3.0}, {"fault": 2, "clear": True, "target": "hook_load"}], [fields for _, fields in self.node.others])

    def test_a_state_shows_readings_and_keeps_the_truth_apart(self):
        state = self.rig.step()
        self.assertEqual((1e5, 1.1e5), (state.hook_load, state.truth.hook_load))
        for name in rig.UNSENSED:
            self.assertIn(name, dir(state.truth))
            with self.assertRaisesRegex(AttributeError, "truth." + name):
                getattr(state, name)
        with self.assertRaises(AttributeError):
            state.weight_on_bit  # pylint: disable=pointless-statement
        self.assertEqual(state.t, copy.deepcopy(state).t)
        self.assertEqual([1.004, 1.008], [round(x, 9) for x in rig.series([state, self.rig.step()], "bit.wob")])


class BeforeTheMaster(unittest.TestCase):
    """A test that is started together with the rig, and has no node."""

    def test_it_waits_for_the_master(self):
        answers = mock.Mock(side_effect=[rospy.ROSInitException("time is not initialized"), None])
        with mock.patch("rospy.wait_for_service", answers):
            rig.wait_for_service("/rig/step", 60.0)
        self.assertEqual(2, answers.call_count)

    def test_it_gives_up_in_time(self):
        with mock.patch.dict("os.environ", ROS_MASTER_URI="http://localhost:9"), self.assertRaisesRegex(rospy.ROSException, "^no ROS master at http://localhost:9"):
            rig.wait_for_service("/rig/step", 0.5)


if __name__ == "__main__":
    unittest.main()
