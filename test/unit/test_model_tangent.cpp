// SPDX-License-Identifier: BSD-3-Clause
// The tangent of the whole model against finite differences of its residual, in every situation that has terms of its own.
#include <gtest/gtest.h>

#include <random>

#include "tangent_check.h"

namespace test_model_tangent
{
using namespace drill_rig_sim;

namespace
{
/// While the string of an inclined hole is lowered and turned.
void expect_exact_sliding_and_turning(const Scene& scene)
{
  Rig rig(scene);
  rig.setpoints.winch = {-0.1, false};
  rig.setpoints.top_drive.speed = 20.0 * rpm;
  rig.run(6.0);
  EXPECT_GT(rig.contacts(), 4);
  expect_exact(rig);
}

/// The bit's gauge clear of the hole: centred without clearance it stands on the contact's switch.
Scene drilling_clear()
{
  Scene scene = drilling_scene(0.002);
  scene.string[0].bit->diameter = 0.21;
  return scene;
}

/// Pipe without tool joints: it touches between the nodes too.
Scene plain(Scene scene)
{
  scene.string[1].pipe->tool_joint_diameter = 0.0;
  return scene;
}

/// Built evenly all the way.
Scene built()
{
  return scene_in(build_and_hold(0.0, 0.1 * degree, 40.0 * degree, 2.0, 400.0), 400.0, 300.0, 0.3);
}
}  // namespace

TEST(ModelTangent, hangingFreeAndTurning)
{
  Scene scene = vertical_scene(100.0, 60.0);
  scene.string[0].bit->diameter = 0.21;
  Rig rig(scene);
  rig.setpoints.top_drive.speed = 60.0 * rpm;
  rig.run(2.0);
  EXPECT_EQ(rig.contacts(), 0);
  expect_exact(rig);
}

TEST(ModelTangent, inEveryModeOfTheTopDrive)
{
  Scene scene = vertical_scene(100.0, 60.0);
  scene.string[0].bit->diameter = 0.21;
  for (const TopDriveMode mode :
       {TopDriveMode::torque, TopDriveMode::angle, TopDriveMode::soft_torque, TopDriveMode::z_torque, TopDriveMode::oscillate})
  {
    SCOPED_TRACE(static_cast<int>(mode));
    Rig rig(scene);
    TopDriveSetpoint& drive = rig.setpoints.top_drive;
    drive.mode = mode;
    drive.speed = 20.0 * rpm;
    drive.torque = 2e3;
    drive.angle = 20.0;
    drive.amplitude_right = 1.0;
    rig.run(2.0);
    expect_exact(rig);
  }
}

TEST(ModelTangent, inContactAndSticking)
{
  Rig rig(slanted_scene(60.0, 0.5));
  rig.run(3.0);
  EXPECT_GT(rig.contacts(), 4);
  double slip = 0.0;
  for (const NodeState& node : rig.rest.state.nodes) slip = std::max(slip, node.rate.velocity.norm());
  EXPECT_LT(slip, 1e-3) << "is at rest";
  expect_exact(rig);
}

TEST(ModelTangent, inContactAndSlidingDown)
{
  Rig rig(slanted_scene(60.0, 0.3));
  rig.setpoints.winch = {-0.2, false};
  rig.run(3.0);
  EXPECT_GT(rig.contacts(), 4);
  expect_exact(rig);
}

TEST(ModelTangent, inContactSlidingAndTurningWithStribeckFriction)
{
  Scene scene = slanted_scene(60.0, 0.3);
  scene.contact.static_ratio = 1.3;
  scene.contact.stribeck_speed = 0.3;
  expect_exact_sliding_and_turning(scene);
}

TEST(ModelTangent, inSectionsWithFrictionOfTheirOwn)
{
  Scene scene = slanted_scene(60.0, 0.3);
  HoleSection upper = scene.well.sections[0];
  upper.to = 30.0;
  upper.friction = 0.2;
  upper.static_ratio = 1.5;
  upper.stribeck_speed = 0.2;
  scene.well.sections.insert(scene.well.sections.begin(), upper);
  scene.well.sections[1].stribeck_speed = 0.4;
  expect_exact_sliding_and_turning(scene);
}

TEST(ModelTangent, inACurvedHole)
{
  Rig rig(built());
  rig.setpoints.winch = {-0.2, false};
  rig.setpoints.top_drive.speed = 60.0 * rpm;
  rig.run(3.0);
  EXPECT_GT(rig.contacts(), 10);
  expect_exact(rig);
}

TEST(ModelTangent, inContactBetweenTheNodes)
{
  Scene scene = plain(slanted_scene(60.0, 0.3));
  scene.contact.static_ratio = 1.3;
  scene.contact.stribeck_speed = 0.3;
  Rig rig(scene);
  rig.run(3.0);
  EXPECT_GE(rig.spans(), 4);
  expect_exact(rig);
  rig.setpoints.winch = {-0.1, false};
  rig.setpoints.top_drive.speed = 20.0 * rpm;
  rig.run(3.0);
  EXPECT_GE(rig.spans(), 4);
  expect_exact(rig);
}

TEST(ModelTangent, drillingOnBottom)
{
  for (const BitTorqueModel model : {BitTorqueModel::stribeck, BitTorqueModel::detournay})
  {
    Scene scene = drilling_clear();
    scene.string[0].bit->torque.model = model;
    scene.formation[0].weight_exponent = 1.3;
    scene.formation[0].drillability = 3e-9;
    Rig rig(scene);
    rig.setpoints.top_drive.speed = 90.0 * rpm;
    rig.run(1.0);
    rig.setpoints.winch = {-0.012, false};
    rig.run(7.0);  // drills less than the bit is high: the hole about it stays wider than the gauge
    EXPECT_GT(rig.stepper.find_forces(rig.rest.state).wob, 1000.0);
    expect_exact(rig);
  }
}

// Weight and torque follow the spin too: the rock ahead of a blade is not level while the string still swings.
TEST(ModelTangent, cuttingBladeByBlade)
{
  Scene scene = drilling_clear();
  scene.string[0].bit->torque.model = BitTorqueModel::regenerative;
  scene.string[0].bit->torque.wear_weight = 1000.0;
  scene.formation[0].threshold = 1000.0;
  Rig rig(scene);
  rig.setpoints.top_drive.speed = 90.0 * rpm;
  rig.run(1.0);
  rig.setpoints.winch = {-0.012, false};
  rig.run(2.0);
  for (int k = 0; k < 5; ++k)
  {
    rig.run(0.1);
    EXPECT_GT(rig.stepper.find_forces(rig.rest.state).wob, 1000.0);
    const CutGround& ground = rig.rest.state.ground;
    EXPECT_GT(ground_ahead(ground, scene.string[0].bit->torque.blades, ground.front + 0.01).slope, 1e-4)
        << "climbs to the blade ahead";
    expect_exact(rig, 1e-6);  // the cut is linear in its depth
  }
}

TEST(ModelTangent, bitStuckInTheRock)
{
  Rig rig(drilling_clear());
  rig.setpoints.winch = {-0.012, false};
  rig.run(5.0);
  EXPECT_GT(rig.stepper.find_forces(rig.rest.state).wob, 1000.0);
  expect_exact(rig);
}

TEST(ModelTangent, motorTurningBehindABentHousing)
{
  Rig rig(motor_drilling_scene(0.002));
  rig.setpoints.top_drive.speed = 50.0 * rpm;
  rig.rest.state.flow = 0.03;
  rig.run(1.0);
  rig.setpoints.winch = {-0.012, false};
  rig.run(6.0);
  EXPECT_GT(rig.rest.state.bit.motor_speed, 1.0);
  EXPECT_GT(rig.contacts(), 0);
  expect_exact(rig);
  rig.rest.state.hydraulics.stand_pipe_pressure = 3e7;
  rig.rest.state.hydraulics.annulus_pressure = 2e6;
  expect_exact(rig);
}

TEST(ModelTangent, slips)
{
  Rig rig(slanted_scene(60.0, 0.3));
  rest_in_slips(rig, rig.rest.model->top() - 3);
  expect_exact(rig);
}

TEST(ModelTangent, stuckPoint)
{
  Rig rig(slanted_scene(60.0, 0.3));
  rig.run(1.0);
  pull_at_stuck_point(rig, 3);
  expect_exact(rig);
}

// Packed cuttings slip, those beside pipe that rests hold; both of pipe that is lowered and turned.
TEST(ModelTangent, dragsAtAPlace)
{
  for (const double amount : {2e4, 1e6})
  {
    Rig rig(slanted_scene(60.0, 0.3));
    rig.run(1.0);
    rig.rest.state.faults.pack_off.amount = amount;
    rig.rest.state.faults.pack_off.md = 30.0;
    rig.rest.state.faults.sticking.amount = 1e7;
    rig.rest.state.faults.sticking.md = 45.0;
    rig.run(2.0);
    rig.setpoints.winch = {-0.1, false};
    rig.setpoints.top_drive.speed = 30.0 * rpm;
    rig.run(1.5);
    EXPECT_GT(rig.rest.state.faults.pack_off.bristle.norm(), 0.0);
    expect_exact(rig);
  }
}

TEST(ModelTangent, statics)
{
  for (const SlidingMotion mode : {no_sliding, sliding_up, sliding_around})
  {
    RigAtRest rig = build_at_rest(plain(built()));
    Problem problem(rig, evaluate_static);
    begin_static(problem.model, problem.start, mode, 0.0, problem.stage);
    const VectorXd u = VectorXd::Zero(6 * rig.model->nodes());
    EXPECT_LT(worst_column(problem, u, tangent_difference, 1), 1e-6) << "both of the top's coordinates are held here";
  }
}

// A motion given outright meets the same forces as the same motion through a stage, but for the rig's on the top node.
TEST(ModelTangent, aMotionGivenOutrightMeetsTheSameForces)
{
  Rig rig(slanted_scene(60.0, 0.3));
  rig.setpoints.winch = {-0.2, false};
  rig.run(3.0);
  Problem problem(rig.rest, evaluate);
  const State& state = rig.rest.state;
  begin_step(problem.model, state, tangent_step, rig.setpoints, problem.stage);
  prepare_start(state, problem.stage);
  const int n = problem.model.nodes();
  VectorXd by_stage(6 * n), outright(6 * n), contact(6 * n);
  problem.at(VectorXd::Zero(6 * n), by_stage, nullptr);
  GivenMotion motion;
  for (int i = 0; i < n; ++i)
  {
    const NodeState& node = state.nodes[i];
    motion.nodes.push_back(
        {node.position, node.orientation, Vector6d::Zero(), in_step_axes(node.rate, x_axis(node.orientation))});
  }
  motion.bit = motion.nodes.front();
  evaluate_motion(problem.model, state, problem.stage, motion, problem.work, outright.data(), contact.data(), nullptr, nullptr);
  outright += contact;
  const double scale = outright.head(6 * (n - 1)).cwiseAbs().maxCoeff();
  EXPECT_GT(scale, 100.0);
  // what a stage adds: the gyroscopic moment of tilting while turning, 1e-4 N m here
  EXPECT_LT((by_stage - outright).head(6 * (n - 1)).cwiseAbs().maxCoeff(), 1e-3);
}

// Within a step the tilt is small, and the tangent's error with it: the axis of spin leans by the tilt, so that the column of
// spin gets that share of the bending stiffness, 4 E I/(G J) = 4 (1 + nu) = 5.2 times the torsional one.
TEST(ModelTangent, errorGrowsNoFasterThanTheTiltOfTheStep)
{
  Rig rig(drilling_clear());
  rig.run(0.1);
  VectorXd u = increments_without_tilt(rig);
  std::mt19937 random(1);
  std::normal_distribution<double> g;
  const double tilt = 1e-4;
  for (int i = 0; i + 1 < rig.rest.model->nodes(); ++i)
  {
    const Vector3d n = x_axis(rig.rest.state.nodes[i].orientation);
    const Vector3d v(g(random), g(random), g(random));
    u.segment<3>(6 * i + 3) += tilt * (v - n * n.dot(v)).normalized();
  }
  Problem problem = next_step(rig);
  EXPECT_LT(worst_column(problem, u, tangent_difference), 5.2 * tilt);
}
}  // namespace test_model_tangent
