// What level auto comes to: one test a rule.
#include <gtest/gtest.h>

#include "drill_rig_sim/math/units.h"
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
