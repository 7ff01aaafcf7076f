// A companion goes through what its leader goes through, and changes nothing of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/accuracy/finer.h"
#include "in_slips.h"
#include "sim_numbers.h"

namespace test_sim_companion
{
using namespace drill_rig_sim;

namespace
{
/// Bit for bit.
void expect_same(const Truth& a, const Truth& b, const char* what)
{
  EXPECT_EQ(numbers_of(a), numbers_of(b)) << what;
}

/// Turns, is zeroed, tags and drills; the hole packs off and is free again.
void drill(Simulator& rig)
{
  turn_and_feed(rig, 0.0);
  play_on(rig, 3.0);
  ASSERT_TRUE(rig.tare());
  turn_and_feed(rig, 0.01);
  play_on(rig, 3.0);
  ASSERT_EQ(rig.inject({FaultKind::pack_off, 50.0, 5e3, Gauge::hook_load}), nullptr);
  play_on(rig, 1.0);
  rig.clear(FaultKind::pack_off, Gauge::hook_load);
  play_on(rig, 1.0);
}

}  // namespace

TEST(Companion, ofTheSameNumericsIsItsLeaderToTheBit)
{
  for (const double step : {0.01, 0.0})
  {
    Scene scene = drilling_scene(0.05);
    scene.numerics.step = step;
    Simulator rig(scene, 3), alone(scene, 3);
    rig.add_companion(rig.scene().numerics);
    drill(rig);
    drill(alone);
    EXPECT_STREQ(rig.companion_failure(0), "");
    expect_same(rig.truth(), rig.companion_truth(0), "companion");
    expect_same(rig.truth(), alone.truth(), "without one");
    EXPECT_GT(rig.truth().wob, 0.0);
    EXPECT_EQ(rig.readings().hook_load, alone.readings().hook_load) << "noise included";
  }
}

TEST(Companion, goesThroughConnections)
{
  Simulator rig(slips_scene(Level::beam3d));
  rig.add_companion(rig.scene().numerics);
  rig.add_companion(finer(rig.scene(), 2.0));
  lay_into_slips(rig);
  connect(rig, 2, false);
  take_from_slips(rig);
  play_on(rig, 2.0);
  expect_same(rig.truth(), rig.companion_truth(0), "same numerics");
  EXPECT_STREQ(rig.companion_failure(1), "");
  EXPECT_EQ(rig.companion_truth(1).stand_count, rig.truth().stand_count);
  EXPECT_EQ(rig.companion_truth(1).in_slips, rig.truth().in_slips);
  EXPECT_NEAR(rig.companion_truth(1).hook_load, rig.truth().hook_load, 0.01 * rig.truth().hook_load);
}

TEST(Companion, comesBackWithItsLeader)
{
  Scene scene = drilling_scene(0.05);
  scene.numerics.step = 0.0;
  Simulator rig(scene);
  rig.add_companion(finer(rig.scene(), 1.5));
  turn_and_feed(rig, 0.02);
  play_on(rig, 4.0);
  const auto saved = rig.save();
  play_on(rig, 2.0);
  const Truth leader = rig.truth(), companion = rig.companion_truth(0);
  ASSERT_TRUE(rig.restore(*saved));
  turn_and_feed(rig, 0.02);
  play_on(rig, 2.0);
  expect_same(rig.truth(), leader, "leader");
  expect_same(rig.companion_truth(0), companion, "companion");
  EXPECT_NE(companion.hook_load, leader.hook_load);
}

TEST(Companion, measuresTheErrorThatWarnsOnAsTheRigItselfRuns)
{
  Scene scene = drilling_scene(0.3);
  scene.numerics.tolerance = 5e-3;
  Simulator alone(scene);
  scene.numerics.companion = CompanionKind::finer;
  Simulator rig(scene);
  turn_and_feed(rig, 0.1);
  turn_and_feed(alone, 0.1);
  double largest = 0.0;
  bool warned = false;
  play_on(rig, 4.0, [&](const Simulator& now)
          {
            largest = std::max(largest, now.measured_error(Output::wob));
            const bool told = now.statistics().accuracy.doubt == AccuracyDoubt::measured;
            EXPECT_TRUE(!told || (now.truth().accuracy_warning && now.readings().accuracy_warning));
            warned = warned || told;
          });
  play_on(alone, 4.0);
  EXPECT_EQ(rig.companions(), 1);
  EXPECT_EQ(rig.truth().hook_load, alone.truth().hook_load);
  EXPECT_GT(largest, scene.numerics.tolerance) << "a bit that comes down at 0.1 m/s";
  EXPECT_TRUE(warned);
  EXPECT_TRUE(std::isnan(alone.measured_error(Output::wob)));
  const auto saved = rig.save();
  const double error = rig.measured_error(Output::wob);
  play_on(rig, 1.0);
  ASSERT_TRUE(rig.restore(*saved));
  EXPECT_EQ(rig.measured_error(Output::wob), error);
}

TEST(Companion, isBuiltBeforeTheFirstFrame)
{
  Simulator rig(drilling_scene());
  play_on(rig, 0.01);
  EXPECT_THROW(rig.add_companion(rig.scene().numerics), std::runtime_error);
}

TEST(Finer, hasElementsAndStepsThatAreSoManyTimesShorter)
{
  Scene scene = drilling_scene();
  const Simulator usual(scene);
  scene.numerics = finer(scene, 2.0);
  const Simulator fine(scene);
  EXPECT_NEAR(fine.statistics().nodes, 2 * usual.statistics().nodes, 6);
}
}  // namespace test_sim_companion
