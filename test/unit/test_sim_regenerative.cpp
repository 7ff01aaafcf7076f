// SPDX-License-Identifier: BSD-3-Clause
// Drilling with the regenerative law: on the average it is the mean law, and what it adds is the shaking about that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/sim/simulator.h"
#include "drill_ahead.h"
#include "test_scenes.h"

namespace test_sim_regenerative
{
using namespace drill_rig_sim;

namespace
{
constexpr double kFrame = 0.01, kSpeed = 90.0 * rpm, kFeed = 0.01, kThreshold = 3e3;  // [s], [rad/s], [m/s], [N]

/// One blade in soft rock under a string that damps: steady. More blades make the rock stiffer, and shake.
Scene cutting(int blades)
{
  Scene scene = drilling_scene(0.005, 0.0);
  BitTorqueSpec& torque = scene.string[0].bit->torque;
  torque.model = BitTorqueModel::regenerative;
  torque.blades = blades;
  torque.wear_weight = kThreshold;
  scene.formation[0].threshold = kThreshold;
  scene.numerics.structural_damping = 2e-3;
  return scene;
}

Scene with_mean_law(Scene scene)
{
  scene.string[0].bit->torque.model = BitTorqueModel::detournay;
  return scene;
}

void go_on(Simulator& rig, double seconds)
{
  for (int k = 0; k < std::lround(seconds / kFrame); ++k) ASSERT_EQ(rig.frame(kFrame), FrameStatus::running) << rig.failure();
}
}  // namespace

TEST(Regenerative, aSteadyCutHasTheMeanLawsWeightTorqueAndRate)
{
  Scene scene = cutting(1);
  scene.numerics.structural_damping = 0.01;
  scene.rig.hoisting.line_damping = 0.1;
  const double speed = 180.0 * rpm, feed = 0.004;  // [rad/s], [m/s]
  Simulator rig(scene);
  drill_ahead(rig, speed, 0.02, feed);
  go_on(rig, 40.0);
  const Truth& m = rig.truth();
  const double cutters = feed / (scene.formation[0].drillability * m.bit_speed);
  EXPECT_NEAR(m.bit_speed, speed, 1e-4 * speed);
  EXPECT_NEAR(m.wob, kThreshold + cutters, 1e-3 * cutters);
  const double a = 0.5 * scene.string[0].bit->diameter;
  EXPECT_NEAR(m.bit_torque, a * cutters / (2.0 * cutter_inclination) + 0.5 * 0.6 * a * kThreshold, 1e-3 * m.bit_torque);
  EXPECT_NEAR(m.rop, feed, 1e-3 * feed);
  const double depth = m.hole_depth;
  go_on(rig, 10.0);
  EXPECT_NEAR(rig.truth().hole_depth - depth, 10.0 * feed, 1e-3 * 10.0 * feed);
}

// Beyond its onset the bit bounces: weight comes and goes, at times there is none, and still the winch sets the rate. The balance
// holds in the midst of it; what the bit does on the rock is the rock's.
TEST(Regenerative, shakesBeyondItsOnset)
{
  Simulator rig(cutting(8));
  drill_ahead(rig, kSpeed, 0.02, kFeed);
  go_on(rig, 30.0);
  rig.balance_energy();
  double least = 1e9, most = 0.0, sum = 0.0;
  const double depth = rig.truth().hole_depth;
  for (int k = 0; k < 1000; ++k)
  {
    ASSERT_EQ(rig.frame(kFrame), FrameStatus::running) << rig.failure();
    const double wob = rig.truth().wob;
    least = std::min(least, wob), most = std::max(most, wob), sum += 1e-3 * wob;
  }
  EXPECT_EQ(least, 0.0) << "loses contact";
  EXPECT_GT(most, 2.0 * sum);
  EXPECT_NEAR(rig.truth().hole_depth - depth, 10.0 * kFeed, 0.03 * 10.0 * kFeed);
  const EnergyAccounts& e = rig.energy();
  EXPECT_GT(e.rock_torque, 100.0) << "of which the blades on the waves give some back to the string as thrust";
  EXPECT_GT(e.broken_rock(), 0.0);
  EXPECT_EQ(e.last.bottom, 0.0);
  EXPECT_LT(e.closure(), 5e-3);
}

// A bit that stands cuts nothing, and carries what it is given.
TEST(Regenerative, aBitThatStandsDrillsNothing)
{
  Simulator rig(cutting(5));
  drill_ahead(rig, 0.0, 0.0, 1e-3);
  go_on(rig, 15.0);
  EXPECT_GT(rig.truth().wob, 5e3);
  EXPECT_NEAR(rig.truth().hole_depth, 100.0, 1e-4);
  EXPECT_EQ(rig.truth().rop, 0.0);
}

// Direction is the drilling equation's: the law says how fast, not where to.
TEST(Regenerative, drillsWhereTheMeanLawDoes)
{
  const auto drop = [](Scene scene)
  {
    scene.well.survey = build_and_hold(20.0, 0.5 * degree, slant, slant_azimuth, 100.0);
    scene.string[0].bit->side_cutting = 0.3;
    Simulator rig(scene);
    drill_ahead(rig, kSpeed, 0.02, 0.02);
    go_on(rig, 25.0);
    return rig.truth().bit_inclination - slant;
  };
  const double mean = drop(with_mean_law(cutting(1)));
  EXPECT_LT(mean, -0.2 * degree);
  EXPECT_NEAR(drop(cutting(1)), mean, 0.05 * std::abs(mean));
}

// The reference has the same law: bristles, cut and string by IDA.
TEST(Regenerative, theReferenceDrillsTheSame)
{
  const auto run = [](IntegratorKind kind)
  {
    Scene scene = cutting(3);
    scene.numerics.integrator = kind;
    scene.numerics.step = kind == IntegratorKind::ida ? 1e-3 : 5e-4;
    Simulator rig(scene);
    drill_ahead(rig, kSpeed, 0.02, kFeed);
    go_on(rig, 2.5);
    return rig.truth();
  };
  const Truth ida = run(IntegratorKind::ida), fixed = run(IntegratorKind::automatic);
  EXPECT_GT(fixed.wob, 3e3);
  EXPECT_NEAR(ida.wob / fixed.wob, 1.0, 0.01);
  EXPECT_NEAR(ida.bit_torque / fixed.bit_torque, 1.0, 0.01);
  EXPECT_NEAR(ida.bit_speed / fixed.bit_speed, 1.0, 0.01);
  EXPECT_NEAR(ida.hole_depth, fixed.hole_depth, 1e-4);
}
}  // namespace test_sim_regenerative
