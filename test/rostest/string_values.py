#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is reported along the string and from downhole, against numbers worked out by hand for a string that hangs in a hole without
friction: lengths, places, weights, bending, contact; surveys and toolface; the frames of the parts; the picture's points."""
import math

from by_hand import GRAVITY, Well, add, angle_between, cross, distance, dot, length, quaternion, rotated, scene, xyz
from drill_rig_sim.msg import DrillstringState, MwdSurvey, MwdToolface, RigTruth
from geometry_msgs.msg import PoseStamped
from rig_test import Rig, flow, rospy, run, turn, unittest, winch
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

SCENE = scene("values.yaml")
MUD = SCENE["mud"]["density"]
STEEL, YOUNG = 7850.0, 206e9  # a scene's defaults [kg/m3], [Pa]
BIT, MOTOR, MWD, COLLAR, PIPE = SCENE["string"]
JOINTS_FROM = BIT["length"] + MOTOR["length"] + MWD["length"] + 2 * COLLAR["joint_length"]  # where the drill pipe begins [m]
HOLE = SCENE["well"]["sections"][0]["diameter"]
DEPTH = 260.0  # of the bit, 20 m off bottom
HELD = (155.0, 245.0)  # measured depths where the hole is straight at 30 deg
BUILT = (50.0, 130.0)  # and where it is built


def area(part):
    return math.pi / 4.0 * (part["outer_diameter"] ** 2 - part["inner_diameter"] ** 2)


def buoyed(part):
    """Weight in mud [N/m]."""
    return part["linear_mass"] * (1.0 - MUD / STEEL) * GRAVITY


def stiffness(part):
    return YOUNG * math.pi / 64.0 * (part["outer_diameter"] ** 4 - part["inner_diameter"] ** 4)


class StringValues(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rig = Rig()
        cls.well = Well(SCENE)
        cls.strings = cls.rig.collect("drillstring_state", DrillstringState)

    def setUp(self):
        self.rig.must(self.rig.reset_well("", DEPTH))

    def still(self):
        """The string at rest."""
        return self.strings.at(self.rig.advance(1).header.stamp)

    def turning(self, **commands):
        """The string after 10 s at a steady turn: what the start wound up has died away."""
        self.rig.advance(1000, **commands)
        return self.strings.at(self.rig.advance(1).header.stamp)

    @staticmethod
    def nodes(string, bounds):
        """Nodes of plain drill pipe between two measured depths, bit first."""
        return [i for i, md in enumerate(string.md) if bounds[0] < md < bounds[1] and string.from_bit[i] > JOINTS_FROM + 15.0]

    def test_every_array_has_an_entry_per_node(self):
        string = self.still()
        self.assertEqual("rig_floor", string.header.frame_id)
        lengths = {name: len(getattr(string, name)) for name in string.__slots__ if name != "header"}
        # to the bend, the rest of the motor, mwd, two collars, joints of 9.5 m up to the block, the last one cut
        joints = math.ceil((DEPTH + 20.0 - JOINTS_FROM) / PIPE["joint_length"])
        self.assertEqual({1 + 2 + 1 + 2 + joints}, set(lengths.values()), lengths)

    def test_places_from_the_bit(self):
        string = self.still()
        expected = [BIT["diameter"] / 2, MOTOR["bit_to_bend"], BIT["length"] + MOTOR["length"], BIT["length"] + MOTOR["length"] + MWD["length"]]
        expected += [expected[-1] + COLLAR["joint_length"], JOINTS_FROM]
        while len(expected) < len(string.from_bit) - 1:
            expected.append(expected[-1] + PIPE["joint_length"])
        for want, got in zip(expected, string.from_bit):
            self.assertAlmostEqual(want, got, delta=1e-9)
        # the string hangs from the block, longer by its stretch: 5 cm at most here
        self.assertAlmostEqual(DEPTH + 20.0, string.from_bit[-1], delta=0.05)
        for md, from_bit in zip(string.md, string.from_bit):
            self.assertAlmostEqual(DEPTH, md + from_bit, delta=0.05)

    def test_nodes_lie_in_the_hole(self):
        string = self.still()
        for md, position, from_bit in zip(string.md, string.position, string.from_bit):
            if md < 0.0:
                self.assertAlmostEqual(-md, position.z, delta=1e-6)
                continue
            place, along = self.well.at(md)
            away = add(xyz(position), place, -1.0)
            radius = BIT["diameter"] / 2 if from_bit < 0.2 else 0.0825 if from_bit < JOINTS_FROM - 1e-6 else 0.084
            self.assertLess(length(away), 0.5 * HOLE - radius + 3e-3)
            self.assertAlmostEqual(0.0, dot(away, along), delta=2e-3)
        self.assertAlmostEqual(20.0, string.position[-1].z, delta=1e-3)

    def test_tension_is_the_weight_below_along_the_hole(self):
        string = self.still()
        held, above = self.nodes(string, HELD), self.nodes(string, (10.0, 38.0))
        for nodes, inclination in ((held, math.radians(30.0)), (above, 0.0)):
            span = string.from_bit[nodes[-1]] - string.from_bit[nodes[0]]
            gain = string.tension[nodes[-1]] - string.tension[nodes[0]]
            self.assertAlmostEqual(buoyed(PIPE) * span * math.cos(inclination), gain, delta=2e-3 * gain)
        # in the middle of the hold section: all that hangs below
        i = held[len(held) // 2]
        below = (BIT["mass"] * (1.0 - MUD / STEEL) * GRAVITY + buoyed(MOTOR) * MOTOR["length"] + buoyed(MWD) * MWD["length"] +
                 buoyed(COLLAR) * 2 * COLLAR["joint_length"] + buoyed(PIPE) * (string.from_bit[i] - JOINTS_FROM)) * math.cos(math.radians(30.0))
        self.assertAlmostEqual(below, string.tension[i], delta=0.01 * below)

    def test_true_axial_force_is_less_by_the_pressure_on_the_steel(self):
        string = self.still()
        for i in range(len(string.md)):
            if abs(string.from_bit[i] - JOINTS_FROM) < 1e-6 or string.from_bit[i] < BIT["diameter"]:
                continue  # where sections meet; the bit
            part = PIPE if string.from_bit[i] > JOINTS_FROM else MOTOR if string.from_bit[i] < BIT["length"] + MOTOR["length"] - 1e-6 else COLLAR
            pressure = MUD * GRAVITY * max(0.0, -string.position[i].z)
            self.assertAlmostEqual(string.tension[i] - pressure * area(part), string.true_axial_force[i], delta=1.0)
        self.assertLess(string.true_axial_force[2], -3e4, "at the bottom the mud compresses the steel")

    def test_pipe_lies_on_the_low_side_with_its_weight_across_the_hole(self):
        string = self.still()
        nodes = self.nodes(string, (170.0, 225.0))  # below where the string crosses over, above the collars
        self.assertGreaterEqual(len(nodes), 4)
        for i in nodes:
            self.assertGreater(string.contact_force[i], 0.0)
            self.assertAlmostEqual(math.pi, abs(string.contact_side[i]), delta=0.05)
        weight = buoyed(PIPE) * math.sin(math.radians(30.0)) * PIPE["joint_length"] * len(nodes)
        self.assertAlmostEqual(weight, sum(string.contact_force[i] for i in nodes), delta=0.05 * weight)
        high = [i for i in self.nodes(string, BUILT) if string.contact_force[i] > 0.0]
        for i in high[2:-2]:  # tension pulls it to the high side of the build
            self.assertAlmostEqual(0.0, string.contact_side[i], delta=0.1)
        self.assertGreaterEqual(len(high), 5)

    def test_bending_is_the_holes_in_the_build(self):
        string = self.still()
        moment = stiffness(PIPE) * math.radians(30.0) / 100.0
        nodes = self.nodes(string, BUILT)
        self.assertGreaterEqual(len(nodes), 7)
        for i in nodes[1:-1]:
            # the wall bends the pipe at its joints alone. Between them tension straightens it (Lubinski: x / tanh x at the joints), and its
            # weight hangs through, as a clamped beam's in tension
            x = 0.5 * PIPE["joint_length"] * math.sqrt(string.tension[i] / stiffness(PIPE))
            inclination = math.radians(30.0) * (string.md[i] - 40.0) / 100.0
            expected = moment * x / math.tanh(x)
            expected -= buoyed(PIPE) * math.sin(inclination) * PIPE["joint_length"] ** 2 / 4.0 * (x / math.tanh(x) - 1.0) / x**2
            self.assertAlmostEqual(expected, string.bending_moment[i], delta=0.04 * expected)
        for i in self.nodes(string, (160.0, 220.0))[1:-1]:  # straight: the weight between joints alone, a clamped beam's w L^2 / 12
            expected = buoyed(PIPE) * math.sin(math.radians(30.0)) * PIPE["joint_length"] ** 2 / 12.0
            self.assertAlmostEqual(expected, string.bending_moment[i], delta=0.05 * expected)
        self.assertAlmostEqual(0.0, string.bending_moment[0], delta=1e-6)  # a free end

    def test_spin_and_torque_are_the_drives(self):
        at_rest = self.still()
        self.assertLess(max(map(abs, at_rest.spin_speed)), 1e-3)
        for torque in at_rest.torque[2:]:  # nothing takes it up on the way: what holds the bend at its toolface
            self.assertAlmostEqual(at_rest.torque[-1], torque, delta=0.05)
        truth = self.rig.collect("truth/rig_state", RigTruth)
        self.addCleanup(truth.subscriber.unregister)
        string = self.turning(top_drive=turn(3.0))
        state = truth.at(string.header.stamp)
        for speed in string.spin_speed:
            self.assertAlmostEqual(3.0, speed, delta=0.15)
        self.assertAlmostEqual(state.torque, string.torque[-1], delta=60.0)
        self.rig.must(self.rig.reset_well("", DEPTH))
        string = self.strings.at(self.rig.advance(5, top_drive=turn(3.0)).header.stamp)  # the drive speeds up: it winds the string
        # before an echo comes back the string is a wave's resistance: sqrt(G J times spin inertia per metre) times the speed
        outer, inner = PIPE["outer_diameter"], PIPE["inner_diameter"]
        resistance = math.sqrt(YOUNG / 2.6 * math.pi / 32.0 * (outer**4 - inner**4) * PIPE["linear_mass"] / 8.0 * (outer**2 + inner**2))
        wound = string.torque[-1] - at_rest.torque[-1]
        self.assertAlmostEqual(resistance * string.spin_speed[-1], wound, delta=0.1 * wound)
        self.assertGreater(string.spin_speed[-1], 10.0 * abs(string.spin_speed[0]))

    def test_parts_have_their_frames_at_their_place_in_the_string(self):
        frames, poses = self.rig.collect("/tf", TFMessage), self.rig.collect("bit/pose", PoseStamped)
        for topic in (frames, poses):
            self.addCleanup(topic.subscriber.unregister)
        stamp = self.rig.advance(1).header.stamp
        pose = poses.at(stamp).pose
        message = frames.wait_until(lambda m: m and m[-1].transforms[0].header.stamp >= stamp)[-1]
        parts = {t.child_frame_id: t.transform for t in message.transforms}
        bottom = {"bit": 0.0, "motor": BIT["length"], "mwd": BIT["length"] + MOTOR["length"]}
        bottom["collar"] = bottom["mwd"] + MWD["length"]
        for number in range(0, 26, 5):
            bottom["pipe_%d" % number] = JOINTS_FROM + number * PIPE["joint_length"]
        self.assertEqual(set(bottom) | {"traveling_block", "top_drive"}, set(parts))
        for name, from_bit in bottom.items():
            place, along = self.well.at(max(0.0, DEPTH - from_bit))
            place = add(place, (0.0, 0.0, max(0.0, from_bit - DEPTH)))
            self.assertLess(distance(xyz(parts[name].translation), place), 0.5 * HOLE - 0.0635 + 0.05, name)
            self.assertLess(abs(dot(add(xyz(parts[name].translation), place, -1.0), along)), 0.05, name)
            self.assertLess(angle_between(rotated(quaternion(parts[name].rotation), (1.0, 0.0, 0.0)), along), math.radians(2.0), name)
        self.assertLess(distance(xyz(parts["bit"].translation), xyz(pose.position)), 2e-3)
        self.assertLess(distance(quaternion(parts["bit"].rotation), quaternion(pose.orientation)), 1e-9)

    def test_the_picture_is_the_strings_offset_exaggerated(self):
        pictures = self.rig.collect("markers", MarkerArray)
        self.addCleanup(pictures.subscriber.unregister)
        whole = pictures.wait_until(lambda m: any(len(x.markers) == 6 for x in m))  # a newcomer gets the well too
        well = {m.ns: m for m in next(x for x in whole if len(x.markers) == 6).markers}
        self.assertEqual(len(SCENE["well"]["stations"]), len(well["stations"].points))
        for (md, _, _), point in zip(SCENE["well"]["stations"], well["stations"].points):
            if md <= SCENE["well"]["hole_depth"]:
                self.assertLess(distance(self.well.at(md)[0], xyz(point)), 1e-3)
        self.assertEqual(0, len(well["wellbore"].points) % 72)  # twelve sides of two triangles
        self.assertGreaterEqual(len(well["wellbore"].points), 72 * 5)
        deepest = min(p.z for p in well["wellbore"].points)
        bottom, along = self.well.at(280.0)
        self.assertAlmostEqual(bottom[2] - 20.0 * 0.5 * HOLE * length(cross(along, (0.0, 0.0, 1.0))), deepest, delta=0.1)
        string = self.still()
        drawn = next(m for x in pictures.wait_until(lambda m: m[-1].markers[0].header.stamp >= string.header.stamp) for m in x.markers
                     if m.ns == "string" and m.header.stamp == string.header.stamp)
        self.assertEqual(len(string.md), len(drawn.points))
        for md, position, point in zip(string.md, string.position, drawn.points):
            place = self.well.at(md)[0] if md > 0.0 else (0.0, 0.0, -md)
            self.assertLess(distance(add(place, add(xyz(position), place, -1.0), 20.0), xyz(point)), 0.05)
        self.assertEqual(len(drawn.points), len(drawn.colors))

    def from_downhole(self, seconds):
        """The surveys and toolfaces of the next frames, one at a time, with a steady flow."""
        surveys, toolfaces = self.rig.collect("downhole/mwd", MwdSurvey), self.rig.collect("downhole/toolface", MwdToolface)
        for topic in (surveys, toolfaces):
            self.addCleanup(topic.subscriber.unregister)
            topic.quiet()
        self.start = self.rig.advance(1, mud_pump=flow(0.02)).header.stamp
        self.rig.advance(round(100 * seconds))
        return surveys, toolfaces

    def test_surveys_are_the_holes_at_the_sensor(self):
        surveys, _ = self.from_downhole(12.0)
        taken = surveys.wait(3)
        sensor = DEPTH - (BIT["length"] + MOTOR["length"] + MWD["sensor_offset"])
        for number, survey in enumerate(taken):
            self.assertAlmostEqual(5.0 * number, (survey.header.stamp - self.start).to_sec(), delta=0.01 * number + 1e-6)  # rounded up to frames
            self.assertAlmostEqual(sensor, survey.md, delta=0.01)
            self.assertAlmostEqual(math.radians(30.0), survey.inclination, delta=math.radians(0.3))
            self.assertAlmostEqual(math.radians(60.0), survey.azimuth, delta=math.radians(0.6))
            self.assertEqual("rig_floor", survey.header.frame_id)
        self.assertEqual(3, len(taken))
        self.assertEqual(3, len({s.inclination for s in taken}), "noise makes each another")

    def test_toolface_is_the_bends_and_turns_with_the_string(self):
        _, toolfaces = self.from_downhole(5.0)
        first = toolfaces.wait(3)
        for number, message in enumerate(first):
            self.assertAlmostEqual(2.0 * number, (message.header.stamp - self.start).to_sec(), delta=0.01 * number + 1e-6)
            self.assertAlmostEqual(math.radians(40.0), message.toolface, delta=math.radians(1.0))
            self.assertEqual(MwdToolface.GRAVITY, message.reference)
        before = self.rig.advance(300, top_drive=turn(0.2))
        after = self.rig.advance(600, top_drive=turn(0.0))
        turned = after.top_drive_angle
        self.assertGreater(turned, 0.4)
        self.assertLess(abs(before.top_drive_angle - turned), 0.2)
        last = toolfaces.wait_until(lambda m: (after.header.stamp - m[-1].header.stamp).to_sec() < 2.6)[-1]
        self.assertAlmostEqual(math.radians(40.0) + turned, last.toolface, delta=math.radians(2.0))

    def test_near_vertical_the_toolface_is_from_north(self):
        self.rig.must(self.rig.reset_well("", 55.0))  # the sensor hangs above the build
        _, toolfaces = self.from_downhole(1.0)
        self.assertEqual(MwdToolface.MAGNETIC, toolfaces.wait(1)[0].reference)

    def test_without_flow_there_is_no_telemetry_and_lifting_shows_in_the_survey(self):
        surveys, _ = self.from_downhole(2.0)
        first = surveys.wait(1)[0]
        self.rig.advance(100, winch=winch(0.3), mud_pump=flow(0.0))
        state = self.rig.advance(700, winch=winch(0.0, True))
        self.rig.advance(200, mud_pump=flow(0.02))
        second = surveys.wait(2)[1]
        self.assertEqual(2, len(surveys.messages))
        self.assertEqual(state.header.stamp + rospy.Duration(0, 10000000), second.header.stamp, "as soon as it flows again")
        self.assertAlmostEqual(-(state.block_height - 20.0), second.md - first.md, delta=0.01)
        self.assertLess(second.md, first.md - 0.1)


if __name__ == "__main__":
    run(StringValues)
