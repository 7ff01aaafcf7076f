// SPDX-License-Identifier: BSD-3-Clause
// A rotary steerable tool: where its pads push, how the hole turns, and who may command it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/instruments/downlink.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/run.h"
#include "drill_rig_sim/well/directions.h"
#include "playing.h"
#include "steerable_scenes.h"

namespace test_sim_steering
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double pad_force = 15e3;  // [N]

Scene steerable_scene(const Scene& scene)
{
  return with_tool(scene, pushing_part(pad_force));
}

/// On bottom of a hole at 20 deg, 10 kN on the bit at 60 rpm: 6 mm/s.
Scene drilling_at_a_slant()
{
  Scene scene = steerable_scene(slanted_scene(200.0, 0.2));
  scene.formation[0].drillability = 1e-7;
  scene.start.weight_on_bit = 10e3;
  return scene;
}

/// Change of inclination and, on the circle, of azimuth by two metres of new hole at a toolface [rad].
Eigen::Vector2d turned(double toolface, double ratio)
{
  Simulator rig(drilling_at_a_slant());
  const double inclination = rig.truth().bit_inclination, azimuth = rig.truth().bit_azimuth, depth = rig.truth().hole_depth;
  TopDriveSetpoint drive;
  drive.speed = 60.0 * rpm;
  rig.command(drive);
  EXPECT_EQ(rig.command(SteeringSetpoint{toolface, ratio}).outcome, CommandResult::Outcome::accepted);
  WeightFeed feed;
  rig.command(PumpSetpoint{0.02});
  for (int k = 0; k < 60000 && rig.truth().hole_depth < depth + 2.0; ++k)
  {
    rig.command(WinchSetpoint{feed.velocity(rig.truth().wob, 10e3, 1e6, 0.05, frame), false});
    if (rig.frame(frame) == FrameStatus::failed) ADD_FAILURE() << rig.failure();
    if (*rig.failure()) break;
  }
  EXPECT_GE(rig.truth().hole_depth, depth + 2.0);
  const double turn = std::remainder(rig.truth().bit_azimuth - azimuth, 2.0 * pi);
  return {rig.truth().bit_inclination - inclination, std::sin(slant) * turn};
}
}  // namespace

TEST(Steering, pushesToItsToolface)
{
  // at rest off bottom in a vertical hole: from north, clockwise looking down
  for (const double toolface : {0.0, 90.0 * degree, 200.0 * degree})
  {
    Simulator rig(steerable_scene(vertical_scene(100.0, 95.0)));
    rig.command(SteeringSetpoint{toolface, 1.0});
    play(rig, 5.0);
    StringProfile profile;
    rig.profile(profile);
    const auto pads = std::min_element(profile.from_bit.begin(), profile.from_bit.end(),
                                       [](double a, double b) { return std::abs(a - 0.9) < std::abs(b - 0.9); });
    const Vector3d place = profile.position[static_cast<std::size_t>(pads - profile.from_bit.begin())];
    EXPECT_NEAR(std::remainder(std::atan2(place.x(), place.y()) - toolface, 2.0 * pi), 0.0, 3.0 * degree);
    EXPECT_GT(std::hypot(place.x(), place.y()), 1e-4);
    EXPECT_TRUE(rig.truth().setpoints.magnetic_steering);
  }
}

TEST(Steering, itsForceIsAsItsRatioSays)
{
  const auto pushed = [](double ratio)
  {
    Scene scene = steerable_scene(vertical_scene(100.0, 95.0));
    Simulator rig(scene);
    rig.command(SteeringSetpoint{0.0, ratio});
    play(rig, 5.0);
    StringProfile profile;
    rig.profile(profile);
    double sum = 0.0;  // of the walls' forces, against the pads' [N]
    for (const double force : profile.contact_force) sum += force;
    return sum;
  };
  // on the wall at gauge and blades: what the pads push is what walls and, by the weight of the string that leans, the pipe above
  // carry
  const double whole = pushed(1.0), half = pushed(0.5);
  EXPECT_NEAR(whole, pad_force, 0.15 * pad_force);
  EXPECT_NEAR(whole - half, 0.5 * pad_force, 0.1 * pad_force);
}

TEST(Steering, theHoleTurnsWhereItPushes)
{
  const Eigen::Vector2d neutral = turned(0.0, 0.0), build = turned(0.0, 1.0), drop = turned(pi, 1.0),
                        right = turned(0.5 * pi, 1.0);
  EXPECT_GT(build[0] - neutral[0], 0.05 * degree);
  EXPECT_LT(drop[0] - neutral[0], -0.05 * degree);
  EXPECT_GT(right[1] - neutral[1], 0.05 * degree);
  EXPECT_NEAR(build[0] - neutral[0], neutral[0] - drop[0], 0.2 * (build[0] - drop[0]));
  EXPECT_NEAR(right[1] - neutral[1], build[0] - neutral[0], 0.3 * (build[0] - neutral[0]));
}

TEST(Steering, isRefusedWithoutATool)
{
  Simulator rig(drilling_scene());
  EXPECT_NE(nullptr, rig.locked(SteeringSetpoint()));
  EXPECT_EQ(rig.command(SteeringSetpoint{1.0, 1.0}).outcome, CommandResult::Outcome::refused);
  EXPECT_EQ(rig.setpoints().steering.ratio, 0.0);
}

TEST(Steering, isClampedAndRefused)
{
  Simulator rig(steerable_scene(vertical_scene(100.0, 95.0)));
  EXPECT_EQ(rig.command(SteeringSetpoint{1.0, 1.5}).outcome, CommandResult::Outcome::clamped);
  EXPECT_EQ(rig.setpoints().steering.ratio, 1.0);
  EXPECT_EQ(rig.command(SteeringSetpoint{NAN, 0.5}).outcome, CommandResult::Outcome::refused);
  EXPECT_EQ(rig.setpoints().steering.toolface, 1.0);
}

TEST(Steering, itsEnergyIsBooked)
{
  Scene scene = steerable_scene(vertical_scene(100.0, 95.0));
  scene.numerics.step = 1e-4;  // the tool goes to the wall in milliseconds
  Simulator rig(scene);
  rig.balance_energy();
  rig.command(SteeringSetpoint{0.3, 1.0});
  play(rig, 0.5);
  EXPECT_GT(rig.energy().steering, 0.0);
  EXPECT_LT(rig.energy().closure(), 0.005);
}

TEST(Steering, theFrictionOfItsPadsIsBooked)
{
  const auto rubbed = [](double ratio)
  {
    Scene scene = steerable_scene(vertical_scene(100.0, 95.0, 0.25));
    scene.numerics.step = 1e-3;
    Simulator rig(scene);
    TopDriveSetpoint drive;
    drive.speed = 60.0 * rpm;
    rig.command(drive);
    rig.command(SteeringSetpoint{0.3, ratio});
    play(rig, 6.0);
    rig.balance_energy();
    play(rig, 2.0);
    EXPECT_LT(rig.energy().closure(), 0.005);
    return rig.energy().wall_friction;
  };
  // pads, and gauge and blades on the other side, each on the wall with what its lever makes of the force
  const double of_pads = 0.25 * pad_force * 0.5 * 0.2159 * 60.0 * rpm * 2.0;
  EXPECT_NEAR(rubbed(1.0) - rubbed(0.0), 2.0 * of_pads, 0.2 * of_pads);
}

TEST(Steering, obeysADownlink)
{
  Scene scene = steerable_scene(vertical_scene(100.0, 95.0));
  scene.string[1].steerable->downlink_bit_time = 6.0;
  Simulator rig(scene);
  const SteeringSetpoint command{135.0 * degree, 0.8};
  rig.command(PumpSetpoint{0.03});
  play(rig, 30.0);
  for (int i = 0; i < DownlinkReceiver::bits; ++i)
  {
    rig.command(PumpSetpoint{DownlinkReceiver::is_low(command, i) ? 0.021 : 0.03});
    play(rig, 6.0);
  }
  rig.command(PumpSetpoint{0.03});
  play(rig, 6.0);
  EXPECT_NEAR(rig.setpoints().steering.toolface, command.toolface, 1e-12);
  EXPECT_NEAR(rig.setpoints().steering.ratio, 0.8, 1e-12);
}
}  // namespace test_sim_steering
