// SPDX-License-Identifier: BSD-3-Clause
// Levels agree on what each of them can represent: torque and drag, waves, stick-slip, drilling.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "drill_ahead.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/guides.h"
#include "drill_rig_sim/model/levels.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "test_scenes.h"

namespace test_sim_levels
{
using namespace drill_rig_sim;

namespace
{
constexpr double kFrame = 0.01;

Scene at_level(Scene scene, Level level, double free_length = 0.0)
{
  scene.numerics.level = level;
  scene.numerics.free_length = free_length;
  return scene;
}

/// What a rig shows over a while.
struct Course
{
  std::vector<double> hook_load, torque, wob, bit_speed;
};

Course watch(Simulator& rig, double settle, double seconds)
{
  Course out;
  for (long k = 0; k < std::lround(settle / kFrame); ++k) EXPECT_EQ(rig.frame(kFrame), FrameStatus::running) << rig.failure();
  for (long k = 0; k < std::lround(seconds / kFrame); ++k)
  {
    EXPECT_EQ(rig.frame(kFrame), FrameStatus::running) << rig.failure();
    const Truth& m = rig.truth();
    out.hook_load.push_back(m.hook_load_string);
    out.torque.push_back(m.torque);
    out.wob.push_back(m.wob);
    out.bit_speed.push_back(m.bit_speed);
  }
  return out;
}

double mean(const std::vector<double>& values)
{
  double sum = 0.0;
  for (double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double highest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

/// Built to 60 deg over 600 m and held.
Scene deviated()
{
  return scene_in(build_and_hold(200.0, 0.1 * degree, 60.0 * degree, 0.8, 1200.0), 1200.0, 1190.0, 0.25);
}

Course moving(const Scene& scene, double block_velocity, double speed)
{
  Simulator rig(scene);
  if (block_velocity != 0.0) rig.command(WinchSetpoint{block_velocity, false});
  if (speed != 0.0)
  {
    TopDriveSetpoint drive;
    drive.speed = speed;
    rig.command(drive);
  }
  return watch(rig, 20.0, 10.0);
}

const std::pair<Level, double> kGuidedLevels[] = {{Level::axial_torsional, 0.0}, {Level::hybrid, 200.0}, {Level::hybrid, 700.0}};
const std::pair<Level, double> kLevelsOfSteadyLoads[] = {
    {Level::rigid, 0.0}, {Level::axial_torsional, 0.0}, {Level::hybrid, 200.0}, {Level::hybrid, 700.0}};
}  // namespace

TEST(Levels, agreeOnTorqueAndDragOfTurningPipe)
{
  for (const double up : {0.0, 0.1, -0.1})
  {
    const Course reference = moving(deviated(), up, 60.0 * rpm);
    for (const auto& [level, free_length] : kLevelsOfSteadyLoads)
    {
      const Course run = moving(at_level(deviated(), level, free_length), up, 60.0 * rpm);
      EXPECT_NEAR(mean(run.hook_load), mean(reference.hook_load), 0.01 * mean(reference.hook_load))
          << up << " m/s, free " << free_length;
      EXPECT_NEAR(mean(run.torque), mean(reference.torque), 0.01 * mean(reference.torque)) << up << " m/s, free " << free_length;
    }
  }
}

TEST(Levels, agreeOnDragOfSlidingPipe)
{
  const double still = mean(moving(deviated(), 0.0, 0.0).hook_load);
  for (const double up : {0.1, -0.1})
  {
    const double drag = mean(moving(deviated(), up, 0.0).hook_load) - still;
    EXPECT_GT(std::abs(drag), 1e4);
    for (const auto& [level, free_length] : kLevelsOfSteadyLoads)
    {
      const double guided = mean(moving(at_level(deviated(), level, free_length), up, 0.0).hook_load) - still;
      EXPECT_NEAR(guided, drag, 0.035 * std::abs(drag)) << up << " m/s, free " << free_length;
    }
  }
}

TEST(Levels, agreeOnDrilling)
{
  const auto drilling = [](Level level, double free_length)
  {
    Scene scene = at_level(drilling_scene(), level, free_length);
    Simulator rig(scene);
    drill_ahead(rig, 90.0 * rpm, 0.03, 0.01);
    return watch(rig, 20.0, 10.0);
  };
  const Course reference = drilling(Level::beam3d, 0.0);
  for (const auto& [level, free_length] :
       {std::make_pair(Level::rigid, 0.0), std::make_pair(Level::axial_torsional, 0.0), std::make_pair(Level::hybrid, 40.0)})
  {
    const Course run = drilling(level, free_length);
    EXPECT_NEAR(mean(run.wob), mean(reference.wob), 0.01 * mean(reference.wob)) << free_length;
    EXPECT_NEAR(mean(run.torque), mean(reference.torque), 0.01 * mean(reference.torque)) << free_length;
  }
}

// The bit sticks and slips: it peaks at more than twice the top's speed.
TEST(Levels, agreeOnStickSlip)
{
  const auto sticking = [](Level level, double free_length)
  {
    Scene scene = vertical_scene(2000.0, 1999.99, 0.2);
    scene.string = {bit_part(0.2159), collar_part(10, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
    scene.numerics.element_length = 9.5;
    Simulator rig(at_level(scene, level, free_length));
    drill_ahead(rig, 40.0 * rpm, 0.03, 0.006);
    return watch(rig, 40.0, 20.0);
  };
  const Course reference = sticking(Level::beam3d, 0.0);
  EXPECT_GT(highest(reference.bit_speed), 80.0 * rpm);
  for (const auto& [level, free_length] : {std::make_pair(Level::axial_torsional, 0.0), std::make_pair(Level::hybrid, 150.0)})
  {
    const Course run = sticking(level, free_length);
    EXPECT_NEAR(highest(run.bit_speed), highest(reference.bit_speed), 0.01 * highest(reference.bit_speed)) << free_length;
    EXPECT_NEAR(highest(run.torque), highest(reference.torque), 0.01 * highest(reference.torque)) << free_length;
    EXPECT_NEAR(mean(run.torque), mean(reference.torque), 0.01 * mean(reference.torque)) << free_length;
  }
}

namespace
{
/// Velocities (axial) or spins at three places of 400 m of hanging pipe, 40 and 90 m below a boundary at 200 m and above it, as a
/// pulse passes them.
std::vector<double> pulse(Level level, bool axial)
{
  Scene scene = without_damping(vertical_scene(500.0, 400.0));
  scene.string = {bit_part(0.2), pipe_part(0, 10.0, plain_pipe_mass, pipe_outer)};
  scene.numerics.element_length = 2.0;
  RigAtRest rig = build_at_rest(at_level(scene, level, 200.0));
  for (int i = 0; i + 1 < rig.model->nodes(); ++i)
  {
    const double x = (rig.model->mesh().nodes[i].from_bit - 120.0) / 10.0, shape = std::exp(-0.5 * x * x);
    if (axial)
      rig.state.nodes[i].position.z() += 1e-4 * shape;
    else
      rig.state.nodes[i].orientation =
          rig.state.nodes[i].orientation * rotation_from_vector(Eigen::Vector3d(1e-3 * shape, 0.0, 0.0));
  }
  settle_guided(rig.state);
  Stepper stepper(rig.model, find_method(IntegratorKind::automatic));
  stepper.limits().tolerance = 1e-12;
  std::vector<double> out;
  while (rig.state.time < (axial ? 0.06 : 0.1))
  {
    EXPECT_TRUE(stepper.advance(rig.state, 2e-4, Setpoints()));
    for (const double place : {160.0, 190.0, 260.0})
    {
      int i = 0;
      while (rig.model->mesh().nodes[i].from_bit < place) ++i;
      const NodeRate& rate = rig.state.nodes[i].rate;
      out.push_back(axial ? rate.velocity.z() : rate.spin);
    }
  }
  return out;
}
}  // namespace

TEST(Levels, wavesPassTheBoundaryWithoutReflection)
{
  for (const bool axial : {true, false})
  {
    const std::vector<double> reference = pulse(Level::beam3d, axial), run = pulse(Level::hybrid, axial);
    ASSERT_EQ(run.size(), reference.size());
    double most = 0.0;
    for (std::size_t k = 0; k < run.size(); ++k) most = std::max(most, std::abs(run[k] - reference[k]));
    EXPECT_LT(most, 0.01 * highest(reference)) << (axial ? "axial" : "torsional");
  }
}

TEST(Levels, closeTheEnergyBalance)
{
  for (const auto& [level, free_length] : kGuidedLevels)
  {
    Simulator rig(at_level(deviated(), level, free_length));
    rig.balance_energy();
    TopDriveSetpoint drive;
    drive.speed = 60.0 * rpm;
    rig.command(drive);
    rig.command(WinchSetpoint{-0.1, false});
    watch(rig, 0.0, 10.0);
    EXPECT_LT(rig.energy().closure(), 1e-3) << free_length;
    EXPECT_LT(std::abs(rig.energy().numerical_share()), 0.01) << free_length;
  }
}

namespace
{
/// Of the elements, as the nodes of a rig lie.
std::vector<double> tensions(const RigAtRest& rig)
{
  Stage stage(*rig.model);
  Workspace work(*rig.model);
  begin_step(*rig.model, rig.state, 0.0, Setpoints(), stage);
  prepare_start(rig.state, stage);
  stage.structural_damping = 0.0;
  std::vector<double> u(6 * rig.model->nodes(), 0.0), residual(u);
  evaluate(*rig.model, rig.state, stage, u.data(), work, residual.data(), nullptr);
  find_string_forces(*rig.model, rig.state, stage, work);
  return work.result.forces.tension;
}
}  // namespace

// In the bend, where the line on the wall and the axis differ most.
TEST(Levels, aChangeKeepsTheTensionOfEveryElement)
{
  RigAtRest rig = build_at_rest(at_level(deviated(), Level::axial_torsional));
  Stepper stepper(rig.model, find_method(IntegratorKind::automatic));
  Setpoints setpoints;
  setpoints.winch = {-0.1, false};
  setpoints.top_drive.speed = 30.0 * rpm;
  for (int k = 0; k < 500; ++k) ASSERT_TRUE(stepper.advance(rig.state, kFrame, setpoints));
  const std::vector<unsigned char> guided(rig.state.nodes.size(), 1);
  std::vector<unsigned char> window = guided;
  for (std::size_t i = 60; i < 90; ++i) window[i] = 0;
  const double hook_load = stepper.find_forces(rig.state).hook_load;
  for (const std::vector<unsigned char>& wanted : {window, guided, window})
  {
    const std::vector<double> before = tensions(rig);
    ASSERT_TRUE(change_guided(*rig.model, wanted, stepper.find_forces(rig.state), rig.state));
    const std::vector<double> after = tensions(rig);
    for (std::size_t e = 0; e < before.size(); ++e) EXPECT_NEAR(after[e], before[e], 1e-3) << "element " << e;
    EXPECT_FALSE(change_guided(*rig.model, wanted, stepper.find_forces(rig.state), rig.state)) << "is as wanted";
    double most = 0.0;
    for (int k = 0; k < 300; ++k)
    {
      ASSERT_TRUE(stepper.advance(rig.state, kFrame, setpoints));
      most = std::max(most, std::abs(stepper.find_forces(rig.state).hook_load - hook_load));
    }
    EXPECT_LT(most, 0.01 * hook_load);
  }
}

// Pipe without collars stands on its bit in a vertical hole, and buckles.
TEST(Levels, hybridSetsFreeWhatWouldBuckleAndGuidesItAgain)
{
  const auto scene_of = [](Level level)
  {
    Scene scene = at_level(vertical_scene(300.0, 299.99, 0.2), level, 20.0);
    scene.numerics.element_length = 4.75;
    return scene;
  };
  Simulator reference(scene_of(Level::beam3d)), rig(scene_of(Level::hybrid));
  const auto move = [&](double velocity, double seconds)
  {
    for (Simulator* one : {&reference, &rig}) one->command(WinchSetpoint{velocity, false});
    double error = 0.0, free = 0.0;
    for (int k = 0; k < seconds / kFrame; ++k)
    {
      for (Simulator* one : {&reference, &rig}) EXPECT_EQ(one->frame(kFrame), FrameStatus::running) << one->failure();
      error = std::max(error, std::abs(rig.truth().hook_load_string - reference.truth().hook_load_string));
      free = std::max(free, static_cast<double>(rig.statistics().coordinates) / reference.statistics().coordinates);
    }
    EXPECT_LT(error, 0.03 * reference.truth().hook_load_string) << velocity << " m/s";
    return free;
  };
  const int at_start = rig.statistics().coordinates;
  EXPECT_LT(at_start, 0.5 * reference.statistics().coordinates);
  EXPECT_GT(move(-0.01, 5.0), 0.5);
  EXPECT_GT(rig.truth().wob, 2e4);
  move(0.01, 10.0);
  EXPECT_GT(rig.statistics().coordinates, at_start);
  move(0.0, 12.0);
  EXPECT_EQ(rig.statistics().coordinates, at_start) << "guided again when nothing presses it for ten seconds";
}

// Two joints an element where nothing pushes the pipe: half the nodes, the same loads.
TEST(Levels, agreeOnTorqueAndDragWithMergedJoints)
{
  const Course reference = moving(deviated(), 0.1, 60.0 * rpm);
  Scene scene = at_level(deviated(), Level::axial_torsional);
  scene.numerics.guided_element_length = 20.0;
  const Course run = moving(scene, 0.1, 60.0 * rpm);
  EXPECT_NEAR(mean(run.hook_load), mean(reference.hook_load), 0.01 * mean(reference.hook_load));
  EXPECT_NEAR(mean(run.torque), mean(reference.torque), 0.01 * mean(reference.torque));
  const Simulator joints(at_level(deviated(), Level::axial_torsional)), merged(scene);
  EXPECT_LT(merged.statistics().nodes, 0.7 * joints.statistics().nodes) << "two of a stand's three joints are one element";
}

// A string that turns and goes down; it is guided in two steps beside one whose level stays.
TEST(Levels, guideARunningRigWithoutABump)
{
  Simulator reference(deviated()), rig(deviated());
  rig.balance_energy();
  TopDriveSetpoint drive;
  drive.speed = 60.0 * rpm;
  for (Simulator* one : {&reference, &rig})
  {
    one->command(drive);
    one->command(WinchSetpoint{-0.05, false});
    watch(*one, 20.0, 0.0);
  }
  const std::pair<double, const char*> levels[] = {{200.0, "hybrid"}, {0.0, "axial_torsional"}};
  for (const auto& [free_length, name] : levels)
  {
    ASSERT_TRUE(rig.set_free_length(free_length));
    for (int k = 0; k < 1000; ++k)
    {
      for (Simulator* one : {&reference, &rig}) ASSERT_EQ(one->frame(kFrame), FrameStatus::running) << one->failure();
      const Truth &is = rig.truth(), &was = reference.truth();
      ASSERT_NEAR(is.hook_load_string, was.hook_load_string, 0.01 * was.hook_load_string)
          << name << " after " << k * kFrame << " s";
      ASSERT_NEAR(is.torque, was.torque, 0.01 * was.torque) << name << " after " << k * kFrame << " s";
      ASSERT_NEAR(is.bit_depth, was.bit_depth, 0.002) << name << " after " << k * kFrame << " s";
    }
    EXPECT_STREQ(rig.statistics().level, name);
  }
  EXPECT_LT(rig.energy().closure(), 1e-3);
}

TEST(Levels, doNotSetPipeFreeByHand)
{
  Simulator rig(at_level(deviated(), Level::rigid)), hybrid(at_level(deviated(), Level::hybrid, 200.0)), beams(deviated());
  EXPECT_FALSE(rig.set_free_length(100.0));
  EXPECT_FALSE(hybrid.set_free_length(201.0));
  EXPECT_TRUE(hybrid.set_free_length(100.0));
  EXPECT_FALSE(beams.set_free_length(-1.0));
  EXPECT_FALSE(beams.set_free_length(std::nan("")));
}

TEST(Levels, guidedPipeThatWouldBuckleWarns)
{
  Simulator rig(at_level(vertical_scene(300.0, 299.99, 0.2), Level::axial_torsional));
  rig.command(WinchSetpoint{-0.01, false});
  watch(rig, 5.0, 0.01);
  EXPECT_EQ(rig.statistics().accuracy.doubt, AccuracyDoubt::confined);
}

TEST(Levels, thatLeaveOutWhatTheSceneNeedsWarn)
{
  Scene scene = at_level(vertical_scene(300.0, 250.0), Level::axial_torsional);
  const auto told = [](const Scene& s)
  {
    Simulator rig(s);
    EXPECT_EQ(rig.frame(kFrame), FrameStatus::running);
    return text_of(rig.statistics().accuracy);
  };
  EXPECT_NE(told(scene).find("does not represent direction, contact, buckling ("), std::string::npos) << told(scene);
  scene.needs = need_hook_load | need_torque | need_direction;
  EXPECT_NE(told(scene).find("does not represent direction ("), std::string::npos) << told(scene);
  scene.needs = need_hook_load | need_torque;
  EXPECT_EQ(told(scene), "");
  scene.numerics.level = Level::rigid;
  EXPECT_NE(told(scene).find("does not represent waves of torque ("), std::string::npos) << told(scene);
  scene.needs = every_need;
  scene.numerics.level = Level::hybrid;
  EXPECT_EQ(told(scene), "");
}
}  // namespace test_sim_levels
