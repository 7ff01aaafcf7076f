// SPDX-License-Identifier: BSD-3-Clause
// What the truth says of bit, hole, pressures and limits, worked out by hand from the state that it was taken from.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "drill_ahead.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "test_scenes.h"

namespace test_sim_truth
{
using namespace drill_rig_sim;
using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
constexpr double frame = 0.01;          // [s]
constexpr double displacement = 0.024;  // of the motor [m3/rev]

/// A bent motor 20 deg from the vertical, towards 1 rad from north, at a toolface.
Scene slanted_motor(double toolface, double step = 0.01)
{
  Scene scene = slanted_scene(199.98, 0.2);
  scene.string.insert(scene.string.begin() + 1, motor_part());
  scene.start.toolface = toolface;
  scene.numerics.step = step;
  return scene;
}

void play_for(Simulator& rig, double seconds)
{
  const double length = rig.scene().numerics.step;
  for (int k = 0; k < std::lround(seconds / length); ++k) ASSERT_EQ(rig.frame(length), FrameStatus::running) << rig.failure();
}

Matrix3d axes_of(const NodeState& node)
{
  return node.orientation.toRotationMatrix();
}

/// Clockwise looking along `axis` from `zero` to `direction`, both seen across it.
double clockwise(const Vector3d& axis, const Vector3d& zero, const Vector3d& direction)
{
  const Vector3d up = (zero - axis * axis.dot(zero)).normalized(), right = axis.cross(up);
  return std::atan2(direction.dot(right), direction.dot(up));
}

/// The first moment at which a flag of the truth is up within `seconds`; infinity: never.
double first_time(Simulator& rig, bool TrueSignals::*flag, double seconds)
{
  for (int k = 0; k < std::lround(seconds / frame); ++k)
  {
    EXPECT_EQ(rig.frame(frame), FrameStatus::running) << rig.failure();
    if (rig.truth().*flag) return rig.truth().time;
  }
  return std::numeric_limits<double>::infinity();
}
}  // namespace

// The bit's node is the centre of its ball, its face half a diameter further along its axis.
TEST(Truth, ofTheBitIsThatOfItsFace)
{
  Simulator rig(slanted_motor(0.5));
  drill_ahead(rig, 60.0 * rpm, 0.03, 0.01);
  for (int k = 0; k < 40; ++k)
  {
    play_for(rig, 0.1);
    const State state = rig.save()->mechanics;
    const NodeState& bit = state.nodes.front();
    const Vector3d axis = axes_of(bit).col(0);
    const Truth& t = rig.truth();
    ASSERT_LT((t.bit_position - (bit.position + 0.5 * 0.2159 * axis)).norm(), 1e-12);
    ASSERT_LT((t.bit_velocity - (bit.rate.velocity + bit.rate.tilt.cross(0.5 * 0.2159 * axis))).norm(), 1e-12);
    ASSERT_NEAR(t.bit_speed, bit.rate.spin + state.bit.motor_speed, 1e-12);
    ASSERT_LT((t.bit_angular_velocity - (bit.rate.tilt + t.bit_speed * axis)).norm(), 1e-12);
    const Matrix3d turned = AngleAxisd(state.bit.turned, axis).toRotationMatrix() * axes_of(bit);
    ASSERT_LT((t.bit_orientation.toRotationMatrix() - turned).norm(), 1e-9);
    const Vector3d down(std::sin(slant) * std::sin(slant_azimuth), std::sin(slant) * std::cos(slant_azimuth), -std::cos(slant));
    ASSERT_NEAR(t.bit_depth, down.dot(t.bit_position), 1e-4) << "along the hole";
  }
  EXPECT_GT(rig.save()->mechanics.bit.turned, 6.0) << "the motor has turned, by more than once around";
  EXPECT_GT(rig.truth().wob, 1e3);
  EXPECT_NEAR(rig.truth().bit_inclination, slant, 0.5 * degree);
  EXPECT_NEAR(rig.truth().bit_azimuth, slant_azimuth, 2.0 * degree);
}

// Velocity and angular velocity are the rates of position and orientation: differences over steps of half a millisecond, means of
// both ends.
TEST(Truth, ratesOfTheBitAreTheRatesOfItsPose)
{
  Scene scene = slanted_motor(0.5, 0.0005);
  scene.rig.mud_pump.flow_ramp = 1e3;
  scene.mud.bulk_modulus = 1e11;
  Simulator rig(scene);
  drill_ahead(rig, 60.0 * rpm, 0.03, 0.01);
  play_for(rig, 1.0);
  for (int k = 0; k < 40; ++k)
  {
    const Truth before = rig.truth();
    play_for(rig, 0.0005);
    const Truth& t = rig.truth();
    const Vector3d velocity = (t.bit_position - before.bit_position) / 0.0005,
                   mean = 0.5 * (t.bit_velocity + before.bit_velocity);
    ASSERT_LT((velocity - mean).norm(), 0.01 * mean.norm() + 1e-5) << k;
    const AngleAxisd turn(t.bit_orientation * before.bit_orientation.conjugate());
    const Vector3d spin = turn.angle() / 0.0005 * turn.axis(),
                   mean_spin = 0.5 * (t.bit_angular_velocity + before.bit_angular_velocity);
    ASSERT_LT((spin - mean_spin).norm(), 0.01 * mean_spin.norm()) << k;
  }
  EXPECT_GT(rig.truth().bit_angular_velocity.norm(), 10.0);
}

// Whatever way the bend points, the bit is turned from the motor's axis above the bend, clockwise from the high side, from north
// where the hole is vertical. Some of it is the string's own bending: 0.1 rad.
TEST(Truth, bendPointsWhereTheBitIsTurned)
{
  for (const double toolface : {0.0, 0.7, 2.5, -1.2})
    for (const bool vertical : {false, true})
    {
      Scene scene = vertical ? motor_drilling_scene(10.0) : slanted_motor(toolface);
      scene.start.toolface = toolface;
      Simulator rig(scene);
      const std::vector<NodeState> nodes = rig.save()->mechanics.nodes;
      const Vector3d below = axes_of(nodes[0]).col(0), above = axes_of(nodes[2]).col(0);
      const double seen = clockwise(above, vertical ? Vector3d::UnitY() : Vector3d::UnitZ(), below - above);
      EXPECT_NEAR(std::remainder(seen - toolface, 2.0 * pi), 0.0, 0.1) << toolface << (vertical ? ", vertical" : ", slanted");
      EXPECT_NEAR(rig.truth().bend_toolface, toolface, 1e-5);
      EXPECT_GT((below - above).norm(), 0.5 * degree);
    }
  EXPECT_EQ(Simulator(drilling_scene()).truth().bend_toolface, 0.0) << "no bend";
}

// The string turns clockwise by a quarter: so does the bend.
TEST(Truth, bendTurnsWithTheString)
{
  Scene scene = slanted_motor(0.3);
  scene.start.bit_depth = 150.0;
  scene.well.sections[0].friction = 0.0;
  Simulator rig(scene);
  TopDriveSetpoint drive;
  drive.speed = 0.25 * pi;
  rig.command(drive);
  play_for(rig, 2.0);
  drive.speed = 0.0;
  rig.command(drive);
  play_for(rig, 10.0);
  const double turned = rig.truth().top_drive_angle;
  EXPECT_NEAR(turned, 0.5 * pi, 0.1);
  EXPECT_NEAR(rig.truth().bend_toolface, 0.3 + turned, 0.1);
}

// Losses 3e9 flow^2, and over the motor what its torque needs, friction of the bit's gauge included: 2 pi T/V.
TEST(Truth, pressuresAreThoseOfFlowAndTorque)
{
  Scene scene = motor_drilling_scene(0.02);
  scene.rig.mud_pump.pressure_coefficient = 3e9;
  scene.rig.mud_pump.flow_ramp = 1e3;
  scene.mud.bulk_modulus = 1e11;
  Simulator rig(scene);
  play_for(rig, 0.1);
  EXPECT_EQ(rig.truth().stand_pipe_pressure, 0.0);
  drill_ahead(rig, 60.0 * rpm, 0.03, 0.01);
  play_for(rig, 0.1);
  const auto over = [&rig] { return 2.0 * pi * rig.save()->forces.motor_torque / displacement; };
  EXPECT_EQ(rig.truth().bit_torque, 0.0) << "off bottom";
  EXPECT_NEAR(rig.truth().stand_pipe_pressure, 3e9 * 0.03 * 0.03 + over(), 0.1 * over() + 1e4);
  EXPECT_NEAR(rig.truth().differential_pressure, over(), 1e-6);
  EXPECT_EQ(rig.truth().flow, 0.03);
  play_for(rig, 8.0);
  ASSERT_GT(rig.truth().bit_torque, 100.0);
  const double over_motor = over();
  EXPECT_GE(over_motor, 2.0 * pi * rig.truth().bit_torque / displacement);
  EXPECT_NEAR(rig.truth().differential_pressure, over_motor, 1e-6);
  EXPECT_NEAR(rig.truth().stand_pipe_pressure, 3e9 * 0.03 * 0.03 + over_motor, 0.1 * over_motor) << "the mud is a step behind";
}

// The second zero takes the first one's place; on bottom there is none.
TEST(Truth, tareTakesTheLoadInTheMean)
{
  Simulator rig(motor_drilling_scene(0.5));
  EXPECT_EQ(rig.truth().surface_wob, 0.0);
  EXPECT_FALSE(rig.truth().tared);
  ASSERT_TRUE(rig.tare());
  EXPECT_TRUE(rig.truth().tared);
  const double first = rig.truth().hook_load + rig.truth().surface_wob;
  EXPECT_EQ(rig.truth().surface_wob, 0.0) << "nothing moves yet";
  rig.command(WinchSetpoint{0.2, false});
  play_for(rig, 0.3);
  ASSERT_GT(std::abs(rig.truth().hook_load - first), 100.0);
  EXPECT_NEAR(rig.truth().surface_wob, first - rig.truth().hook_load, 1e-6);
  ASSERT_TRUE(rig.tare());
  const double second = rig.truth().hook_load + rig.truth().surface_wob;
  EXPECT_GT(std::abs(second - first), 100.0);
  play_for(rig, 0.1);
  EXPECT_NEAR(rig.truth().surface_wob, second - rig.truth().hook_load, 1e-6);
  drill_ahead(rig, 60.0 * rpm, 0.03, 0.1);
  while (!rig.truth().on_bottom) play_for(rig, frame);
  play_for(rig, 1.0);
  EXPECT_FALSE(rig.tare());
  EXPECT_NEAR(rig.truth().surface_wob, second - rig.truth().hook_load, 1e-6) << "the old zero stays";
}

// One limit at a time holds the winch back: its ramp, the lowest and the highest height, the hook load.
TEST(Truth, winchIsLimitedByEachOfItsLimits)
{
  Scene scene = drilling_scene(40.0);
  scene.rig.hoisting.max_acceleration = 0.4;
  scene.rig.hoisting.lowest_block_height = 19.0;
  scene.rig.hoisting.highest_block_height = 21.0;
  {
    Simulator rig(scene);
    play_for(rig, 0.5);
    EXPECT_FALSE(rig.truth().winch_limited);
    rig.command(WinchSetpoint{0.1, false});
    play_for(rig, 0.24);
    EXPECT_TRUE(rig.truth().winch_limited) << "ramps for 0.1/0.4 s";
    play_for(rig, 0.03);
    EXPECT_FALSE(rig.truth().winch_limited);
    rig.command(WinchSetpoint{0.0, true});
    play_for(rig, 0.1);
    EXPECT_TRUE(rig.truth().winch_limited) << "and down again";
    EXPECT_TRUE(rig.truth().brake_set);
  }
  for (const double way : {0.1, -0.1})
  {
    Simulator rig(scene);
    rig.command(WinchSetpoint{way, false});
    play_for(rig, 0.3);
    // a metre: v^2/(2 a) = 0.0125 m in 0.25 s to run up, 0.975 m in 9.75 s, and the brake begins at the last 0.0125 m
    EXPECT_NEAR(first_time(rig, &RigSignals::winch_limited, 12.0), 10.0, 0.1) << way;
    play_for(rig, 5.0);
    EXPECT_TRUE(rig.truth().winch_limited);
    EXPECT_NEAR(rig.truth().block_height, way > 0.0 ? 21.0 : 19.0, 0.02) << "but for swings on the line";
  }
  scene.rig.hoisting.max_hook_load = 300e3;
  Simulator rig(scene);
  ASSERT_TRUE(rig.stick_pipe(40.0));
  rig.command(WinchSetpoint{0.05, false});
  play_for(rig, 0.3);
  const double time = first_time(rig, &RigSignals::winch_limited, 5.0);
  EXPECT_LT(time, 5.0);
  EXPECT_NEAR(rig.truth().hook_load, 300e3, 20e3);
  play_for(rig, 2.0);
  EXPECT_LT(rig.truth().hook_load, 330e3) << "raises no more";
}

// A drive that has not the torque for its ramp is limited, a motor whose torque reaches its stall's is stalled.
TEST(Truth, driveAndMotorTellTheirLimits)
{
  Simulator rig(drilling_scene(5.0));
  TopDriveSetpoint drive;
  drive.speed = 5.0;
  drive.torque_limit = 3e3;  // for 2500 kg m2, 1 kN m of it for the gearbox: 0.8 rad/s2 at most
  rig.command(drive);
  play_for(rig, 1.0);
  EXPECT_TRUE(rig.truth().top_drive_limited);
  EXPECT_NEAR(rig.truth().top_drive_speed, 0.8, 0.08);
  play_for(rig, 30.0);
  EXPECT_FALSE(rig.truth().top_drive_limited);

  Scene scene = motor_drilling_scene(0.01);
  scene.string[1].motor->stall_torque = 200.0;
  scene.rig.mud_pump.flow_ramp = 1e3;
  scene.mud.bulk_modulus = 1e11;
  Simulator weak(scene);
  drill_ahead(weak, 20.0 * rpm, 0.02, 0.012);
  play_for(weak, 0.5);
  EXPECT_FALSE(weak.truth().motor_stalled);
  EXPECT_LT(first_time(weak, &TrueSignals::motor_stalled, 10.0), 10.0);
  EXPECT_GE(weak.save()->forces.motor_torque, 200.0);
  play_for(weak, 0.5);
  EXPECT_NEAR(weak.truth().bit_speed, weak.save()->mechanics.nodes[0].rate.spin + weak.save()->mechanics.bit.motor_speed, 1e-9);
  EXPECT_LT(weak.save()->mechanics.bit.motor_speed, 0.2 * 2.0 * pi * 0.02 / displacement) << "the string alone turns the bit";
  double turned = 0.0;  // by the bit, in a second [rad]
  for (int k = 0; k < 100; ++k)
  {
    play_for(weak, 0.01);
    turned += 0.01 * weak.truth().bit_speed;
  }
  EXPECT_GT(turned, -0.05) << "and drags the rotor round backwards, at most as fast as it turns itself down there";
}
}  // namespace test_sim_truth
