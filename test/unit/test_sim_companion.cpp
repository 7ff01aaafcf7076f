// SPDX-License-Identifier: BSD-3-Clause
// A companion goes through what its leader goes through, and changes nothing of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "drill_rig_sim/accuracy/refined.h"
#include "drill_rig_sim/sim/finer_pair.h"
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

// It would begin at the scene's start.
TEST(Companion, isRefusedAfterARestore)
{
  const Scene scene = drilling_scene(0.05);
  Simulator other(scene, 3), rig(scene, 3);
  drill(other);
  ASSERT_TRUE(rig.restore(*other.save()));
  EXPECT_THROW(rig.add_companion(rig.scene().numerics), std::runtime_error);
}

TEST(Companion, getsSetPointsAfterTheSameDeadTimes)
{
  Scene scene = drilling_scene(0.05);
  scene.rig.plc_latency = 0.3;
  scene.rig.hoisting.latency = 0.2;
  Simulator rig(scene, 3);
  rig.add_companion(rig.scene().numerics);
  drill(rig);
  EXPECT_EQ(rig.truth().setpoints.winch.block_velocity, -0.01);
  EXPECT_TRUE(rig.companion_truth(0).setpoints == rig.truth().setpoints);
  expect_same(rig.truth(), rig.companion_truth(0), "companion");
}

TEST(Companion, goesThroughConnections)
{
  Simulator rig(slips_scene(Level::beam3d));
  rig.add_companion(rig.scene().numerics);
  rig.add_companion(refined(rig.scene().numerics, 2.0));
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
  rig.add_companion(refined(rig.scene().numerics, 1.5));
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
  play_on(rig, 4.0,
          [&](const Simulator& now)
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

TEST(Companion, isTheSameInAThreadOfItsOwn)
{
  for (const CompanionKind kind : {CompanionKind::coarser, CompanionKind::finer})
  {
    Scene scene = slips_scene(Level::beam3d);
    scene.numerics.companion = kind;
    scene.numerics.step = 0.0;
    Simulator in_turn(scene), beside(scene);
    beside.set_companion_pace(CompanionPace::own_thread);
    std::vector<Outputs> errors[2];
    std::shared_ptr<const SimulatorState> saved[2];
    Simulator* const rigs[] = {&in_turn, &beside};
    for (int i = 0; i < 2; ++i)
    {
      const auto note = [&](const Simulator& now) { errors[i].push_back(now.statistics().errors); };
      lay_into_slips(*rigs[i]);
      connect(*rigs[i], 2, false);
      take_from_slips(*rigs[i]);
      play_on(*rigs[i], 1.0, note);
      saved[i] = rigs[i]->save();
      play_on(*rigs[i], 1.003, note);
    }
    EXPECT_EQ(errors[0], errors[1]);
    EXPECT_STREQ(in_turn.statistics().not_measured, "");
    EXPECT_GT(errors[0].back()[0], 0.0);
    expect_same(in_turn.truth(), beside.truth(), "run");
    expect_same(in_turn.companion_truth(0), beside.companion_truth(0), "companion");
    // one goes on from the other's snapshot
    ASSERT_TRUE(in_turn.restore(*saved[1]));
    play_on(in_turn, 1.003);
    EXPECT_EQ(errors[1].back(), in_turn.statistics().errors);
    expect_same(in_turn.companion_truth(0), beside.companion_truth(0), "companion after a restore");
  }
}

// A gauge with a filter of 5 s does not show the waves that a coarser model blurs; noise is the same in both, and no error.
TEST(Companion, readingsHideWhatTheInstrumentsFilter)
{
  double largest[2] = {};
  for (const Judge judge : {Judge::truth, Judge::readings})
  {
    Scene scene = drilling_scene(0.3);
    scene.numerics.companion = CompanionKind::finer;
    scene.numerics.judge = judge;
    scene.instruments.torque.filter_time = 5.0;
    scene.instruments.torque.noise = 200.0;
    Simulator rig(scene, 3);
    turn_and_feed(rig, 0.05);
    double& most = largest[static_cast<int>(judge)];
    play_on(rig, 10.0, [&](const Simulator& now) { most = std::max(most, now.measured_absolute_error(Output::torque)); });
  }
  EXPECT_GT(largest[1], 0.0);
  EXPECT_LT(largest[1], 0.5 * largest[0]);
}

TEST(Companion, isGivenUpInRealTimeWhereItIsTooSlow)
{
  Scene scene = drilling_scene(0.3);
  scene.numerics.companion = CompanionKind::finer;
  Simulator rig(scene), alone(scene);
  rig.set_companion_pace(CompanionPace::own_thread_unwaited);
  for (Simulator* s : {&rig, &alone})
  {
    turn_and_feed(*s, 0.02);
    play_on(*s, 30.0);  // without waiting for the clock: the run is faster than its companion
  }
  EXPECT_EQ(rig.statistics().not_measured,
            std::string("the companion was too slow for real time: no processor core was free for it"));
  EXPECT_FALSE(rig.statistics().error_is_measured);
  EXPECT_TRUE(std::isnan(rig.measured_error(Output::wob)));
  EXPECT_FALSE(rig.truth().accuracy_warning);
  EXPECT_EQ(rig.truth().hook_load, alone.truth().hook_load);
  EXPECT_TRUE(alone.statistics().error_is_measured);
}

TEST(Companion, isThereWhereTheProgramChoosesTheLevel)
{
  Scene scene = drilling_scene();
  EXPECT_EQ(Simulator(scene).companions(), 0);
  EXPECT_STREQ(Simulator(scene).statistics().not_measured, "numerics.level is set by hand and numerics.companion is not");
  scene.numerics.level = Level::automatic;
  EXPECT_EQ(Simulator(scene).companions(), 1);
  EXPECT_STREQ(Simulator(scene).statistics().not_measured, "");
  scene.numerics.companion = CompanionKind::none;
  EXPECT_EQ(Simulator(scene).companions(), 0);
  EXPECT_STREQ(Simulator(scene).statistics().not_measured, "numerics.companion is none");
}

TEST(Companion, isTheFinerModelThatARunIsVerifiedBy)
{
  Scene scene = drilling_scene();
  scene.numerics.companion = CompanionKind::finer;
  Simulator as_fine(scene), finer_still(scene);
  const FinerPair pair(as_fine, 2.0), other(finer_still, 3.0);
  EXPECT_EQ(as_fine.companions(), 2);
  EXPECT_EQ(pair.finer(), 0);
  EXPECT_EQ(finer_still.companions(), 3);
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
  scene.numerics = refined(scene.numerics, 2.0);
  const Simulator fine(scene);
  EXPECT_NEAR(fine.statistics().nodes, 2 * usual.statistics().nodes, 6);
}
}  // namespace test_sim_companion
