// SPDX-License-Identifier: BSD-3-Clause
// The way between the rig's state, the reference's unknowns and the stages that energy is counted from; and when the reference
// starts afresh.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/reference/ida_integrator.h"
#include "drill_rig_sim/solve/start.h"
#include "plucked_rig.h"

namespace test_reference_rig
{
using namespace drill_rig_sim;
using Eigen::Map;
using Eigen::Vector3d;

namespace
{
constexpr double step = 0.01, begun = 40.0;  // [s]
constexpr double turned = 0.3, way = 0.02;   // by the motor and into the rock when the interval begins [rad], [m]

/// A motor off bottom, and the reference's interval, begun when motor and rock have gone some way already.
struct Interval
{
  RigAtRest rig;
  Stage stage;
  Workspace work;
  RigDae dae;
  std::vector<double> y, rate;
  int nodes;

  Interval() : rig(build_at_rest(scene())), stage(*rig.model), work(*rig.model), dae(started()), nodes(rig.model->nodes())
  {
    begin_step(*rig.model, rig.state, step, Setpoints(), stage);
    y = dae.initial(rig.state);
    further()[1] = turned;
    further()[4] = way;
    EXPECT_TRUE(dae.begin(begun, rig.state, Setpoints(), y));
    rate.assign(y.size(), 0.0);
  }
  static Scene scene()
  {
    Scene scene = motor_drilling_scene(5.0);
    scene.string[1].motor->bend = 0.0;
    scene.rig.top_drive.brake_torque = 0.0;  // the speed loop holds it
    return scene;
  }
  RigDae started()
  {
    rig.state.bit.motor_speed = 7.0;
    rig.state.bit.mean_speed = 12.0;
    rig.state.drive.speed = 2.0;
    rig.state.drive.angle = 50.0;
    rig.state.time = begun;
    for (NodeState& node : rig.state.nodes) node.rate.spin = 2.0;
    rig.state.nodes[1].rate.velocity = Vector3d(0.1, 0.2, 0.3);
    return RigDae(*rig.model, stage, work, rig.state, Formulation::stabilised_index_2, 1e-6);
  }
  double* further() { return y.data() + dae.further_at(); }
  /// Node i's six numbers of place, or of rates.
  double* place(int body) { return y.data() + 12 * body; }
  double* rates(int body) { return y.data() + 12 * body + 6; }
  /// Node 1, the rotor and the bit are elsewhere than where the interval began.
  void displace()
  {
    Map<Vector3d>(place(1)) += Vector3d(1e-3, 2e-3, 3e-3);
    Map<Vector3d>(place(1) + 3) += 0.05 * x_axis(rig.state.nodes[1].orientation);
    Map<Vector3d>(place(nodes + 1) + 3) += 0.07 * -Vector3d::UnitZ();
    further()[0] = 9.0;
    further()[1] += 0.08;
    further()[4] -= 1e-4;
  }
};

/// Starts of IDA in this number of steps.
std::uint64_t starts_in(IdaIntegrator& ida, State& state, const Setpoints& setpoints, int steps)
{
  const std::uint64_t before = ida.reference()->ida.starts;
  for (int k = 0; k < steps; ++k) EXPECT_TRUE(ida.advance(state, step, setpoints)) << ida.failure();
  return ida.reference()->ida.starts - before;
}
}  // namespace

TEST(ReferenceRig, beginsWithTheMotionOfTheState)
{
  Interval d;
  d.dae.read(d.y.data());
  const NodeState& node = d.rig.state.nodes[1];
  EXPECT_EQ(d.dae.motion(1).velocity, node.rate.velocity);
  EXPECT_EQ(d.dae.motion(1).position, node.position);
  EXPECT_LT((d.dae.motion(1).angular_velocity - 2.0 * x_axis(node.orientation)).norm(), 1e-12);
  EXPECT_EQ(d.further()[0], 7.0);
  EXPECT_EQ(d.further()[5], 12.0);
  const int rotor = d.nodes + 1, stator = d.nodes + 2, block = d.nodes + 3;
  const Vector3d shaft = d.rig.state.nodes.back().position;
  EXPECT_LT((d.dae.motion(rotor).angular_velocity + 2.0 * Vector3d::UnitZ()).norm(), 1e-9) << "clockwise looking down";
  EXPECT_EQ(d.dae.motion(stator).angular_velocity.norm() + d.dae.motion(block).angular_velocity.norm(), 0.0);
  EXPECT_EQ(d.dae.motion(rotor).position, shaft);
  EXPECT_EQ(d.dae.motion(stator).position, shaft + Vector3d(0.0, 0.0, 1.0));
  EXPECT_EQ(d.dae.motion(block).position, shaft + Vector3d(0.0, 0.0, 4.0));
}

// Forces and moments that unit accelerations take: the bit leaves the lowest node what the mesh has lumped there, the block is in
// three parts.
TEST(ReferenceRig, bodiesShareTheInertiaOfNodeAndBlock)
{
  Interval d;
  const auto takes = [&d](int body, int k)
  {
    std::vector<double> rate(d.y.size(), 0.0), still(d.y.size()), moved(d.y.size());
    d.dae.residual(begun, d.y.data(), rate.data(), still.data());
    const std::size_t at = 12 * static_cast<std::size_t>(body) + 6 + static_cast<std::size_t>(k);
    rate[at] = 1.0;
    d.dae.residual(begun, d.y.data(), rate.data(), moved.data());
    return moved[at] - still[at];
  };
  constexpr int along = 2, tilt = 3, spin = 5;  // of a vertical string
  const Scene& scene = d.rig.model->scene();
  const Mesh& mesh = d.rig.model->mesh();
  const int bit = d.nodes, rotor = d.nodes + 1, stator = d.nodes + 2, block = d.nodes + 3;
  const double of_bit = 0.4 * mesh.bit_mass * mesh.bit_radius * mesh.bit_radius;  // a ball
  EXPECT_NEAR(takes(bit, along), mesh.bit_mass, 1e-6);
  EXPECT_NEAR(takes(0, along), mesh.nodes[0].mass - mesh.bit_mass, 1e-6);
  for (const int k : {tilt, spin}) EXPECT_NEAR(takes(bit, k), of_bit, 1e-6);
  EXPECT_NEAR(takes(0, tilt), mesh.nodes[0].tilt_inertia - of_bit, 1e-6);
  EXPECT_NEAR(takes(0, spin), mesh.nodes[0].spin_inertia - of_bit, 1e-6);
  EXPECT_NEAR(takes(1, tilt), mesh.nodes[1].tilt_inertia, 1e-6);
  EXPECT_NEAR(takes(1, spin), mesh.nodes[1].spin_inertia, 1e-6);
  const double mass = scene.rig.hoisting.block_mass;
  EXPECT_NEAR(takes(rotor, along), 0.2 * mass, 1e-6);
  EXPECT_NEAR(takes(stator, along), 0.4 * mass, 1e-6);
  EXPECT_NEAR(takes(block, along), 0.4 * mass, 1e-6);
  EXPECT_NEAR(takes(rotor, spin), scene.rig.top_drive.inertia, 1e-6);
}

// What the error of one tolerance is: a hundredth of it in places, relative in rates; multipliers are left out.
TEST(ReferenceRig, hasATolerancePerUnknown)
{
  Interval d;
  Map<Vector3d>(d.rates(1)) = Vector3d(3.0, 0.0, 4.0);
  Map<Vector3d>(d.rates(1) + 3) = Vector3d(0.0, 12.0, 5.0);
  std::vector<double> tolerance(d.y.size(), 0.0);
  d.dae.tolerances(d.y.data(), tolerance.data());
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(tolerance[12 + k], 1e-8, 1e-18);
  for (int k = 6; k < 9; ++k) EXPECT_NEAR(tolerance[12 + k], 6e-6, 1e-15);
  for (int k = 9; k < 12; ++k) EXPECT_NEAR(tolerance[12 + k], 14e-6, 1e-15);
  const double* further = tolerance.data() + d.dae.further_at();
  EXPECT_NEAR(further[0], 8e-6, 1e-15);
  for (int k = 1; k < 5; ++k) EXPECT_NEAR(further[k], 1e-8, 1e-18);
  EXPECT_NEAR(further[5], 13e-6, 1e-15);
  const std::vector<bool> differential = d.dae.differential();
  ASSERT_EQ(differential.size(), d.y.size());
  EXPECT_EQ(d.dae.multipliers_at(), 12 * (d.nodes + 4) + 6);
  EXPECT_EQ(d.y.size(), static_cast<std::size_t>(d.dae.multipliers_at() + 2 * d.dae.constraint_count()));
  EXPECT_EQ(d.dae.constraint_count(), 6 + 5 + 5 + 5 + 6);
  for (int k = 0; k < static_cast<int>(d.y.size()); ++k)
  {
    EXPECT_EQ(differential[k], k < d.dae.multipliers_at()) << k;
    EXPECT_EQ(tolerance[k] < 1e9, differential[k]) << k;
  }
}

// A stage within the interval: ways and turns count from where the interval began, rates and accelerations are the unknowns' own.
TEST(ReferenceRig, aStageHasTheMotionSinceTheIntervalBegan)
{
  Interval d;
  d.displace();
  const Vector3d n = x_axis(d.rig.state.nodes[1].orientation);
  Map<Vector3d>(d.rates(1)) = Vector3d(0.4, 0.5, 0.6);
  Map<Vector3d>(d.rates(1) + 3) = Vector3d(0.0, 0.0, -3.0);
  const int rotor = d.nodes + 1;
  Map<Vector3d>(d.rates(rotor) + 3) = Vector3d(0.0, 0.0, -2.5);
  for (int k = 0; k < 6; ++k) d.rate[12 + 6 + k] = 1.0 + k;
  d.rate[12 * rotor + 11] = -30.0;

  Stage stage(*d.rig.model);
  Setpoints setpoints;
  setpoints.winch = {-0.2, false};
  begin_step(*d.rig.model, d.rig.state, 0.0, setpoints, stage);
  std::vector<double> u(6 * static_cast<std::size_t>(d.nodes), 9.0);
  d.dae.fill_stage(begun + 0.006, d.y.data(), d.rate.data(), stage, u.data());
  Vector6d expected;
  expected << 1e-3, 2e-3, 3e-3, 0.05 * n;
  EXPECT_LT((Map<const Vector6d>(u.data() + 6) - expected).norm(), 1e-9);
  EXPECT_LT(Map<const Vector6d>(u.data()).norm(), 1e-12) << "stayed";
  expected << 0.4, 0.5, 0.6, 0.0, 0.0, -3.0;
  EXPECT_EQ(stage.rate[1], expected);
  expected << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0;
  EXPECT_EQ(stage.acceleration[1], expected);
  EXPECT_NEAR(stage.time, 0.006, 1e-12);
  EXPECT_NEAR(stage.hoist.winch_speed, -0.003, 1e-12) << "0.5 m/s2 for 6 ms";
  EXPECT_EQ(stage.bit.motor_speed, 9.0);
  EXPECT_NEAR(stage.bit.motor_turn, 0.08, 1e-12);
  EXPECT_EQ(stage.bit.mean_speed, 12.0);
  EXPECT_NEAR(stage.bit.drilling_speed, 12.0, 1e-12) << "the mean's, not the 11 of now";
  EXPECT_TRUE(stage.bit.bottom_known);
  EXPECT_EQ(stage.bit.rock_time, 0.0);
  EXPECT_LT((stage.bit.bottom_increment + 1e-4 * Vector3d::UnitZ()).norm(), 1e-12);

  // the stage's own rotor is where IDA has it
  Workspace work(*d.rig.model);
  update(*d.rig.model, d.rig.state, stage, u.data(), work);
  EXPECT_NEAR(work.result.drive_increment, 0.07, 1e-8);
  EXPECT_NEAR(work.result.drive.speed, 2.5, 1e-12);
  EXPECT_NEAR(stage.drive.da_du * 0.07 + stage.drive.acceleration_0, 30.0, 1e-4) << "of numbers as large as 1e9";
}

TEST(ReferenceRig, anIntervalsEndIsTheStates)
{
  Interval d;
  const Vector3d n = x_axis(d.rig.state.nodes[1].orientation);
  const Vector3d across = n.unitOrthogonal();
  d.displace();
  Map<Vector3d>(d.rates(1) + 3) = 3.0 * n + 0.2 * across;
  const int rotor = d.nodes + 1;
  Map<Vector3d>(d.rates(rotor) + 3) = Vector3d(0.0, 0.0, -1.5);
  State state = d.rig.state;
  const double depth = state.well.bottom_position().z();
  const double twist = state.drive.meter_twist;
  std::vector<double> start = d.dae.initial(d.rig.state);
  start[d.dae.further_at() + 1] = turned;
  start[d.dae.further_at() + 4] = way;
  d.dae.begin(begun, state, Setpoints(), start);
  d.dae.finish(begun + step, d.y, state);

  const NodeState &node = state.nodes[1], &before = d.rig.state.nodes[1];
  EXPECT_LT((node.position - before.position - Vector3d(1e-3, 2e-3, 3e-3)).norm(), 1e-12);
  EXPECT_NEAR(node.rate.spin, 3.0, 1e-12);
  EXPECT_LT((node.rate.tilt - 0.2 * across).norm(), 1e-12);
  EXPECT_NEAR(node.spin_angle, 0.05, 1e-12);
  EXPECT_LT(node.orientation.angularDistance(rotation_from_vector(0.05 * n) * before.orientation), 1e-9);
  EXPECT_NEAR(state.drive.angle, 50.07, 1e-12);
  EXPECT_NEAR(state.drive.speed, 1.5, 1e-12);
  EXPECT_NEAR(state.drive.meter_twist, twist + 0.07, 1e-12);
  EXPECT_NEAR(state.time, begun + step, 1e-12);
  EXPECT_EQ(state.bit.motor_speed, 9.0);
  EXPECT_NEAR(state.bit.turned, 0.08, 1e-12);
  EXPECT_LT((state.bit.rock_velocity + 0.01 * Vector3d::UnitZ()).norm(), 1e-9);
  EXPECT_NEAR(state.well.bottom_position().z(), depth - 1e-4, 1e-9);
  const TopDriveSpec& drive = d.rig.model->scene().rig.top_drive;
  const RigForces& forces = d.work.result.forces;
  EXPECT_NEAR(forces.meter_torque, drive.meter_stiffness * (twist + 0.07), 1e-6);
  const double motor = -drive.proportional_gain * 1.5 + drive.integral_gain * (d.rig.state.drive.integral - 0.07);
  EXPECT_NEAR(forces.drive_torque, motor, 1e-6);
  EXPECT_NEAR(forces.hook_load, d.rig.statics.top_force + standard_gravity * d.rig.model->scene().rig.hoisting.block_mass, 1.0);
}

// The motor's lag and the rock's recession are further unknowns: s' = f.
TEST(ReferenceRig, theMotorFollowsItsSteadySpeed)
{
  Interval d;
  d.rig.state.flow = 0.03;
  std::vector<double> f(d.y.size());
  d.further()[0] = 4.0;
  d.dae.residual(begun + 0.001, d.y.data(), d.rate.data(), f.data());
  const double* s = f.data() + d.dae.further_at();
  EXPECT_NEAR(-s[0], (2.0 * pi * 0.03 / 0.024 - 4.0) / mud_motor_lag, 1e-9);
  EXPECT_NEAR(-s[1], 4.0, 1e-12);
  for (int k = 2; k < 5; ++k) EXPECT_EQ(s[k], 0.0) << "off bottom";
  EXPECT_NEAR(-s[5], (2.0 + 4.0 - 12.0) / 0.4, 1e-9) << "of string and motor";
}

// Every set point is one that a rig may jump by.
TEST(ReferenceIntegrator, startsAfreshAtEachChangeOfASetPoint)
{
  RigAtRest rig = plucked();
  IdaIntegrator ida(rig.model);
  Setpoints now;
  EXPECT_EQ(starts_in(ida, rig.state, now, 1), 1u);
  EXPECT_EQ(starts_in(ida, rig.state, now, 3), 0u);
  const auto expect_start = [&](const char* what)
  {
    EXPECT_EQ(starts_in(ida, rig.state, now, 1), 1u) << what;
    EXPECT_EQ(starts_in(ida, rig.state, now, 1), 0u) << what;
  };
  now.winch.block_velocity = 1e-4;
  expect_start("block velocity");
  now.winch.brake = false;
  expect_start("brake");
  now.top_drive.speed = 0.1;
  expect_start("speed");
  now.top_drive.torque = 1.0;
  expect_start("torque");
  now.top_drive.angle = 1.0;
  expect_start("angle");
  now.top_drive.torque_limit = 1e4;
  expect_start("torque limit");
  now.top_drive.mode = TopDriveMode::torque;
  expect_start("mode");
  rig.state.flow = 0.01;
  expect_start("flow");
}

// What it counts goes on over a restart, which drops IDA.
TEST(ReferenceIntegrator, countsOverAllItsStarts)
{
  RigAtRest rig = plucked();
  IdaIntegrator ida(rig.model);
  starts_in(ida, rig.state, Setpoints(), 5);
  const IdaStatistics first = ida.reference()->ida;
  ida.restart();
  EXPECT_EQ(starts_in(ida, rig.state, Setpoints(), 5), 1u);
  const IdaStatistics& all = ida.reference()->ida;
  EXPECT_GT(all.steps, first.steps + 5);
  EXPECT_GT(all.newton_iterations, first.newton_iterations + 5);
  EXPECT_EQ(all.starts, 2u);
  EXPECT_EQ(ida.counters().steps, all.steps);
  EXPECT_EQ(ida.counters().newton_iterations, all.newton_iterations);
  EXPECT_EQ(ida.work().solves, all.newton_iterations);
  EXPECT_EQ(ida.counters().convergence_failures, all.error_test_failures + all.newton_failures);
  EXPECT_NEAR(rig.state.time, 0.1, 1e-12);
  const ReferenceReport& report = *ida.reference();
  EXPECT_GT(report.drift, 0.0);
  EXPECT_LT(report.drift, 1e-7);
  EXPECT_GT(report.rate_drift, 0.0);
  EXPECT_LT(report.rate_drift, 1e-5);
}

// A thousand steps of IDA are the most it takes in one: it reports this, and the state is the one before.
TEST(ReferenceIntegrator, saysThatOneStepIsTooMuchWork)
{
  RigAtRest rig = plucked();
  IdaIntegrator ida(rig.model);
  ASSERT_TRUE(ida.advance(rig.state, step, Setpoints()));
  EXPECT_EQ(std::string(ida.failure()).find("more steps of its own"), std::string::npos);
  const State before = rig.state;
  EXPECT_FALSE(ida.advance(rig.state, 30.0, Setpoints()));
  EXPECT_NE(std::string(ida.failure()).find("more steps of its own"), std::string::npos);
  EXPECT_EQ(rig.state.time, before.time);
  EXPECT_EQ(rig.state.nodes[0].position, before.nodes[0].position);
  EXPECT_EQ(starts_in(ida, rig.state, Setpoints(), 1), 1u) << "from the state again";
  EXPECT_EQ(std::string(ida.failure()).find("more steps of its own"), std::string::npos);
}
}  // namespace test_reference_rig
