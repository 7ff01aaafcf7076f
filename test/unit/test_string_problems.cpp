// SPDX-License-Identifier: BSD-3-Clause
// The rules for a string: what each says and where its limit is.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "drill_rig_sim/string/mesh.h"
#include "drill_rig_sim/string/string_checks.h"
#include "steerable_scenes.h"

namespace test_string_problems
{
using namespace drill_rig_sim;

namespace
{
using Parts = std::vector<PartSpec>;

/// A part `length` long, as a scene file makes it.
PartSpec of_length(double length, PartSpec part)
{
  part.length = length;
  return part;
}

const PartSpec bit = bit_part(0.2159);  // 0.3 m
const PartSpec motor = motor_part();    // 8.3 m
const PartSpec collars = of_length(18.8, collar_part(2, 9.4));
const PartSpec fill = pipe_part(0, 9.5, tool_jointed_mass);

/// "key: text" of the one problem; how many there are if it is not one.
std::string said_of(const Parts& parts, double length = 320.0, double element_length = 9.5)
{
  const ProblemList problems = string_problems(parts, length, uniform_elements(element_length));
  return problems.size() == 1 ? problems[0].key + ": " + problems[0].text : std::to_string(problems.size()) + " problems";
}

PartSpec motor_bent_at(double from_bit)
{
  PartSpec part = motor;
  part.motor->bit_to_bend = from_bit;
  return part;
}
}  // namespace

TEST(StringRules, KindsStandInTheirPlaces)
{
  EXPECT_EQ("0 problems", said_of({bit, motor, mwd_part(), collars, fill}));
  EXPECT_EQ("string: the list is empty, needed: at least a bit and a pipe", said_of({}));
  EXPECT_EQ("string: there is nothing above the bit, needed: at least one pipe or collar", said_of({bit}));
  EXPECT_EQ("string[1].type: a second bit, allowed: one", said_of({bit, bit, fill}));
  EXPECT_EQ("string[2].type: a second mud motor, allowed: one", said_of({bit, motor, motor_bent_at(10.0), fill}));
  EXPECT_EQ("string[2].type: the mud motor is not next to the bit, allowed: directly above the bit",
            said_of({bit, collars, motor_bent_at(22.0), fill}));
  EXPECT_EQ("string[2].type: a second mwd, allowed: one", said_of({bit, mwd_part(), mwd_part(), fill}));
  EXPECT_EQ("string[1].joints: `fill` is not the string's last part, allowed: on the last part only",
            said_of({bit, fill, collars, fill}));
}

TEST(StringRules, PlacesInsideAPartLieInside)
{
  EXPECT_EQ("string[1].bit_to_bend: 0.3 m is outside the motor, allowed: between 0.3 and 8.6 m",
            said_of({bit, motor_bent_at(0.3), fill}));
  EXPECT_EQ("string[1].bit_to_bend: 8.7 m is outside the motor, allowed: between 0.3 and 8.6 m",
            said_of({bit, motor_bent_at(8.7), fill}));
  EXPECT_EQ("0 problems", said_of({bit, motor_bent_at(0.4), fill}));
  EXPECT_EQ("0 problems", said_of({bit, motor_bent_at(8.5), fill}));
  PartSpec mwd = mwd_part();
  mwd.mwd->sensor_offset = mwd.length;
  EXPECT_EQ("0 problems", said_of({bit, mwd, fill}));
  mwd.length = mwd.joint_length = 9.0;
  mwd.mwd->sensor_offset = 9.25;
  EXPECT_EQ("string[1].sensor_offset: 9.25 m is outside the part, allowed: 0 to 9 m", said_of({bit, mwd, fill}));
}

TEST(StringRules, ARotarySteerablePushesOrPoints)
{
  PartSpec tool = pointing_part();
  EXPECT_EQ("0 problems", said_of({bit, tool, fill}));
  EXPECT_EQ("0 problems", said_of({bit, pushing_part(), fill}));
  EXPECT_EQ("string[2].type: a second rotary_steerable, allowed: one",
            said_of({bit, pointing_part(), pointing_part(1.0 * degree, 4.0), fill}));
  tool.steerable->pad_force = 1e4;
  const std::string one_of_them = "string[1]: both or neither of `pad_force` and `tilt_deg` are given, needed: one of them";
  EXPECT_EQ(one_of_them, said_of({bit, tool, fill}));
  tool.steerable->pad_force = tool.steerable->tilt = 0.0;
  EXPECT_EQ(one_of_them, said_of({bit, tool, fill}));
  tool = pointing_part();
  tool.steerable->bit_to_pads = 0.8;
  EXPECT_EQ("string[1].bit_to_pads: is given, allowed with `pad_force`", said_of({bit, tool, fill}));
  tool = pushing_part();
  tool.steerable->bit_to_pivot = 0.8;
  EXPECT_EQ("string[1].bit_to_pivot: is given, allowed with `tilt_deg`", said_of({bit, tool, fill}));
}

TEST(StringRules, PadsAndPivotLieInsideTheTool)
{
  PartSpec tool = pointing_part();
  tool.steerable->bit_to_pivot = 3.0;
  EXPECT_EQ("string[1].bit_to_pivot: 3 m is outside the tool, allowed: between 0.3 and 3 m", said_of({bit, tool, fill}));
  tool.steerable->bit_to_pivot = 2.995;
  EXPECT_EQ("string[1].bit_to_pivot: an element of this part is 0.005 m long, allowed: 0.01 m or more",
            said_of({bit, tool, fill}));
  tool = pushing_part();
  tool.steerable->bit_to_pads = 0.0;
  EXPECT_EQ("string[1].bit_to_pads: 0 m is outside the tool, allowed: between 0.3 and 4.3 m", said_of({bit, tool, fill}));
}

TEST(StringRules, ASleeveIsInsideItsMotor)
{
  PartSpec motor = motor_bent_at(2.0);
  motor.motor->bit_to_sleeve = 50.0;
  EXPECT_EQ("0 problems", said_of({bit, motor, fill})) << "there is none";
  motor.motor->sleeve_diameter = 0.2;
  EXPECT_EQ("string[1].bit_to_sleeve: 50 m is outside the motor, allowed: between 0.3 and 8.6 m", said_of({bit, motor, fill}));
  motor.motor->bit_to_sleeve = 1.0;
  EXPECT_EQ("0 problems", said_of({bit, motor, fill}));
}

// Of a bit's friction the kinetic one may equal the static one; other laws do not have them.
TEST(StringRules, KineticFrictionDoesNotExceedStatic)
{
  PartSpec part = bit;
  part.bit->torque.model = BitTorqueModel::stribeck;
  part.bit->torque.static_friction = part.bit->torque.kinetic_friction = 0.5;
  EXPECT_EQ("0 problems", said_of({part, fill}));
  part.bit->torque.kinetic_friction = 0.75;
  EXPECT_EQ("string[0].torque.kinetic: 0.75 exceeds static, allowed: up to 0.5", said_of({part, fill}));
  part.bit->torque.model = BitTorqueModel::detournay;
  EXPECT_EQ("0 problems", said_of({part, fill}));
}

// Half a metre must be left to fill.
TEST(StringRules, ThePartsBelowTheFillLeaveRoomForIt)
{
  EXPECT_EQ("0 problems", said_of({bit, collars, fill}, 19.65));
  EXPECT_EQ(
      "string: the parts below `fill` are 19.1 m long, allowed: up to 0.5 m less than the 19.55 m from the bit to the top drive "
      "(bit_depth + block_height)",
      said_of({bit, collars, fill}, 19.55));
}

// 19.1 m of bit and two collars.
TEST(StringRules, AStringOfFixedLengthIsRefusedForWhatItLacks)
{
  const std::string from_bit = " from the bit to the top drive (bit_depth + block_height)";
  const std::string own =
      "string[1]: the last part has a fixed length, needed: `joints: fill`, because the string stretches under load";
  EXPECT_EQ("string: the string is 19.1 m long, needed: 20 m" + from_bit + "; or give the last part `joints: fill`",
            said_of({bit, collars}, 20.0));
  EXPECT_EQ("string: the string is 19.1 m long, needed: 9.6 m" + from_bit, said_of({bit, collars}, 9.6));
  for (const double length : {9.8, 19.1, 19.2}) EXPECT_EQ(own, said_of({bit, collars}, length)) << length;
}

// By hand: 300 m of pipe are 32 joints of 9.5 m, each in 1900 elements of 5 mm.
TEST(StringRules, NodesAreCountedBeforeTheyAreMade)
{
  EXPECT_EQ("numerics.element_length: 0.005 m gives about 60801 nodes, allowed: up to " + std::to_string(most_mesh_nodes),
            said_of({bit, fill}, 300.3, 0.005));
}

TEST(StringRules, TheBitsCentreLiesBelowTheNextNode)
{
  PartSpec flat = bit;
  flat.length = 0.02;
  PartSpec bent = motor_bent_at(0.115);
  EXPECT_EQ(
      "string[0].length: the next node is 0.115 m above the bit's face and the bit's centre 0.10795 m, needed: a longer bit, so "
      "that "
      "the centre lies 0.01 m or more below that node",
      said_of({flat, bent, fill}));
  bent = motor_bent_at(8.6 - 0.005);
  EXPECT_EQ("string[1].bit_to_bend: an element of this part is 0.005 m long, allowed: 0.01 m or more",
            said_of({bit, bent, fill}));
}

TEST(StringRules, SectionsThatAreGivenOutrightCanBe)
{
  const auto with = [](double axial, double bending, double torsional)
  {
    PartSpec part = fill;
    part.stiffness = {axial, bending, torsional};
    return said_of({bit, part});
  };
  const double most = 7e8 * pipe_outer * pipe_outer / 8.0;
  EXPECT_EQ("0 problems", with(7e8, most, most / 1.3));
  EXPECT_EQ("0 problems", with(7e8, 1e6, 1e6));
  EXPECT_EQ("0 problems", with(1e9, 1.49e6, 1e6));
  EXPECT_EQ("string[1]: axial_stiffness, bending_stiffness and torsional_stiffness belong together, needed: all three or none",
            with(7e8, 1e6, 0.0));
  EXPECT_EQ("string[1]: axial_stiffness, bending_stiffness and torsional_stiffness belong together, needed: all three or none",
            with(0.0, 0.0, 1e6));
  EXPECT_EQ(
      "string[1].bending_stiffness: 2e+07 N m2 is more than possible with axial_stiffness and outer_diameter, allowed: up to " +
          plain(most) + " N m2",
      with(7e8, 2e7, 1.5e7));
  EXPECT_EQ(
      "string[1].torsional_stiffness: 1.1e+06 N m2 does not match bending_stiffness (their ratio is 1 + Poisson's ratio), "
      "allowed: " +
          plain(1e6 / 1.49) + " to 1e+06 N m2",
      with(7e8, 1e6, 1.1e6));
  EXPECT_EQ(
      "string[1].torsional_stiffness: 600000 N m2 does not match bending_stiffness (their ratio is 1 + Poisson's ratio), "
      "allowed: " +
          plain(1e6 / 1.49) + " to 1e+06 N m2",
      with(7e8, 1e6, 6e5));
}

TEST(StringRules, InertiaAndLeverFitThePart)
{
  PartSpec part = fill;
  const double radius = 0.5 * part.pipe->tool_joint_diameter, most = part.linear_mass * radius * radius;
  part.polar_inertia = most;
  part.friction_radius = radius;
  EXPECT_EQ("0 problems", said_of({bit, part}));
  part.polar_inertia = 10.0;
  EXPECT_EQ("string[1].polar_inertia: 10 kg m2/m is more than possible with linear_mass and the diameters, allowed: up to " +
                plain(most) + " kg m2/m",
            said_of({bit, part}));
  part.polar_inertia = 0.0;
  part.friction_radius = 0.2;
  EXPECT_EQ("string[1].friction_radius: 0.2 m lies outside the part, allowed: up to half its widest diameter, " + metres(radius),
            said_of({bit, part}));
}
}  // namespace test_string_problems
