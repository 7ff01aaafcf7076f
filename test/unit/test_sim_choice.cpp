// SPDX-License-Identifier: BSD-3-Clause
// What level auto comes to: one test a rule.
#include <gtest/gtest.h>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/choice.h"
#include "drill_rig_sim/sim/simulator.h"
#include "test_scenes.h"

namespace test_sim_choice
{
using namespace drill_rig_sim;

namespace
{
Scene hanging(double tolerance, unsigned needs = every_need)
{
  Scene scene = vertical_scene(400.0, 390.0);
  scene.numerics.level = Level::automatic;
  scene.numerics.step = step_by_level;
  scene.numerics.tolerance = tolerance;
  scene.needs = needs;
  return scene;
}

Scene lying(double tolerance, unsigned needs = every_need)
{
  Scene scene = slanted_scene(199.9, 0.6);
  scene.numerics.level = Level::automatic;
  scene.numerics.tolerance = tolerance;
  scene.needs = needs;
  return scene;
}

Scene with_motor(Scene scene)
{
  scene.string[1].motor.emplace();
  return scene;
}

constexpr unsigned along = need_hook_load | need_wob | need_rop;
}  // namespace

TEST(Choice, alongAndAboutTheHoleAloneWhereLittleIsNeeded)
{
  EXPECT_EQ(choose(hanging(0.05, along | need_torque | need_bit_speed)).level, Level::axial_torsional);
  EXPECT_EQ(choose(hanging(0.05, along | need_direction)).level, Level::hybrid);
  EXPECT_EQ(choose(with_motor(hanging(0.05, along))).level, Level::hybrid);
  EXPECT_EQ(choose(lying(0.05, along)).level, Level::hybrid) << "what is stiff bears on a hole that bends";
}

TEST(Choice, bendingNearTheBitAloneInAHoleThatHangsTheString)
{
  EXPECT_EQ(choose(hanging(0.002)).level, Level::hybrid);
  EXPECT_EQ(choose(with_motor(hanging(0.01))).level, Level::beam3d);
  Scene spiral = hanging(0.01);  // never beyond 3 deg, and bends by 4.5 deg/30 m
  spiral.well.survey = {{0.0, 0.0, 0.0}, {200.0, 2.0 * degree, 0.0}, {226.7, 2.0 * degree, pi}, {400.0, 2.0 * degree, pi}};
  EXPECT_EQ(choose(spiral).level, Level::beam3d);
}

namespace
{
/// A hole that never inclines by more than `crooked` [rad], and turns to and fro by `turn` [rad] between stations of 60 m.
Scene wobbling(double crooked, double turn, double depth, double friction = 0.24)
{
  Scene scene = vertical_scene(depth, depth - 10.0, friction);
  scene.numerics = hanging(0.02).numerics;
  scene.string.insert(scene.string.begin() + 1, collar_part(9, 9.4));
  scene.well.survey = {{0.0, 0.0, 0.0}};
  for (int k = 1; 60.0 * k <= depth; ++k) scene.well.survey.push_back({60.0 * k, crooked, k % 2 == 0 ? 0.0 : turn});
  return scene;
}
}  // namespace

// Free pipe cuts the corners that guided pipe is pulled around: 1.34 kN m of torque at 2100 m where hybrid found 1.70.
TEST(Choice, bendingEverywhereWhereAVerticalHoleIsCrooked)
{
  for (const double crooked : {1.0, 2.0, 3.0})
    for (const double depth : {1200.0, 2100.0, 3600.0})
      EXPECT_EQ(choose(wobbling(crooked * degree, 15.0 * degree, depth)).level, Level::beam3d)
          << crooked << " deg, " << depth << " m";
  EXPECT_EQ(choose(wobbling(0.1 * degree, 15.0 * degree, 600.0)).level, Level::hybrid);
  EXPECT_EQ(choose(wobbling(2.9 * degree, 15.0 * degree, 2100.0, 0.0)).level, Level::hybrid) << "nothing rubs";
}

// mu r T dtheta: 0.2 * 0.084 m * the weight in mud below each of two bends of 2 deg, down at 1000 m and back at 1100 m.
TEST(Choice, torqueOfBendsIsTheSoftStrings)
{
  Scene scene = vertical_scene(2000.0, 2000.0, 0.2);
  scene.well.survey = {{0.0, 0.0, 0.0},    {990.0, 0.0, 0.0}, {1000.0, 2.0 * degree, 0.0}, {1100.0, 2.0 * degree, 0.0},
                       {1110.0, 0.0, 0.0}, {2000.0, 0.0, 0.0}};
  const double weight = standard_gravity * tool_jointed_mass * (1.0 - scene.mud.density / steel_density);
  EXPECT_NEAR(torque_of_bends(scene, 2000.0), 0.2 * 0.084 * weight * (895.0 + 1005.0) * 2.0 * degree, 2.0);
}

TEST(Choice, bendingEverywhereWhereTheHoleTurnsAgainAndAgain)
{
  Scene spiral = hanging(0.05);
  spiral.well.survey = {{0.0, 0.0, 0.0}};
  for (int turn = 1; turn <= 12; ++turn) spiral.well.survey.push_back({30.0 * turn, 3.5 * degree, 0.5 * pi * turn});
  EXPECT_EQ(choose(spiral).level, Level::hybrid) << "0.06 and eleven times 0.086 rad";
  for (SurveyStation& station : spiral.well.survey) station.inclination *= 4.0;
  EXPECT_EQ(choose(spiral).level, Level::beam3d) << "0.24 and eleven times 0.34 rad";
  spiral.start.bit_depth = 200.0;
  EXPECT_EQ(choose(spiral).level, Level::hybrid) << "five of them are below the bit";
}

TEST(Choice, bendingNearTheBitAloneWhereTorqueIsNotNeeded)
{
  EXPECT_EQ(choose(lying(0.02, along)).level, Level::hybrid);
  EXPECT_EQ(choose(lying(0.02, along | need_torque)).level, Level::beam3d);
  EXPECT_EQ(choose(lying(0.01, along)).level, Level::beam3d);
}

TEST(Choice, shorterElementsTheNarrowerTheTolerance)
{
  EXPECT_EQ(choose(lying(0.02)).pushed_element_length, 0.0);
  EXPECT_EQ(choose(lying(0.01)).pushed_element_length, 2.4);
  EXPECT_EQ(choose(lying(0.002)).pushed_element_length, 1.2);
  Scene given = lying(0.002);
  given.numerics.pushed_element_length = 3.0;
  EXPECT_EQ(choose(given).pushed_element_length, 3.0);
}

TEST(Choice, joinsGuidedJointsWithinAWideTolerance)
{
  Scene scene = hanging(0.05);
  scene.numerics.element_length = 0.0;
  EXPECT_EQ(with_choice(scene).numerics.guided_element_length, 20.0);
  scene.numerics.tolerance = 0.04;
  EXPECT_EQ(choose(scene).guided_element_length, 0.0);
  scene.numerics.tolerance = 0.05;
  scene.numerics.element_length = 4.0;
  EXPECT_EQ(choose(scene).guided_element_length, 0.0) << "given by hand, as it is here:";
  scene.numerics.guided_element_length = 9.5;
  EXPECT_EQ(choose(scene).guided_element_length, 9.5);
}

TEST(Choice, isMadeInTheScenesKeysWithStepsOfVariableLength)
{
  const Scene chosen = with_choice(hanging(0.01));
  EXPECT_EQ(chosen.numerics.level, Level::hybrid);
  EXPECT_EQ(chosen.numerics.step, 0.0);
}

TEST(Choice, leavesWhatIsGivenByHand)
{
  Scene level = hanging(0.01);
  level.numerics.level = Level::beam3d;
  EXPECT_EQ(with_choice(level).numerics.level, Level::beam3d);
  EXPECT_EQ(with_choice(level).numerics.step, default_step);
  level.numerics.step = 0.0;
  EXPECT_EQ(with_choice(level).numerics.step, 0.0);
  Scene step = hanging(0.01);
  step.numerics.step = 0.004;
  EXPECT_EQ(with_choice(step).numerics.level, Level::hybrid);
  EXPECT_EQ(with_choice(step).numerics.step, 0.004);
}

TEST(Choice, ofWhatTheIntegratorCan)
{
  Scene scene = hanging(0.01);
  scene.numerics.integrator = IntegratorKind::trbdf2;
  EXPECT_EQ(with_choice(scene).numerics.level, Level::hybrid);
  EXPECT_EQ(with_choice(scene).numerics.step, default_step);
  scene.numerics.integrator = IntegratorKind::ida;
  EXPECT_EQ(with_choice(scene).numerics.level, Level::beam3d);
  EXPECT_EQ(with_choice(scene).numerics.step, default_step);
}

TEST(Choice, isToldByTheSimulator)
{
  const Simulator automatic(hanging(0.01));
  EXPECT_NE(automatic.choice().find("hangs"), std::string::npos) << automatic.choice();
  const Simulator by_hand(vertical_scene(400.0, 390.0));
  EXPECT_TRUE(by_hand.choice().empty());
}
}  // namespace test_sim_choice
