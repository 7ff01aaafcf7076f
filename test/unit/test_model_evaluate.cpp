// SPDX-License-Identifier: BSD-3-Clause
// What a stage and a workspace carry over from one evaluation to the next, and where forces look for what is around them.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/energy.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/solve/methods/method.h"
#include "drill_rig_sim/solve/stepper.h"
#include "lone_bit.h"

namespace test_model_evaluate
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
std::vector<double> no_increment(const Model& model)
{
  return std::vector<double>(6 * static_cast<std::size_t>(model.nodes()), 0.0);
}

/// Depth drilled in this number of seconds in a vertical hole whose bottom lies at 100 m.
double drilled(const std::vector<FormationLayer>& layers)
{
  Scene scene = drilling_scene(0.001);
  scene.formation = layers;
  Simulator rig(scene);
  rig.command(WinchSetpoint{-0.01, false});
  TopDriveSetpoint drive;
  drive.speed = 10.0;
  rig.command(drive);
  for (int k = 0; k < 500; ++k) EXPECT_EQ(rig.frame(0.01), FrameStatus::running);
  return rig.truth().hole_depth - 100.0;
}
}  // namespace

// The same stage and workspace serve a moving rig and then its equilibrium: nothing of the motion is left.
TEST(Evaluate, aRestingRigHasNothingOfTheMotionBefore)
{
  const RigAtRest rig = build_at_rest(drilling_scene());
  State state = rig.state;
  state.nodes[0].rate.spin = 5.0;
  Stage stage(*rig.model);
  Workspace work(*rig.model);
  const std::vector<double> still = no_increment(*rig.model);
  std::vector<double> residual(still);
  begin_step(*rig.model, state, 0.01, Setpoints(), stage);
  prepare_implicit_euler(state, 0.01, stage);
  for (Vector6d& a : stage.acceleration) a.setOnes();
  std::vector<double> turning = still;
  turning[3] = 0.01;
  turning[4] = turning[5] = 0.01;
  evaluate(*rig.model, state, stage, turning.data(), work, residual.data(), nullptr);
  ASSERT_NE(0.0, work.result.forces.bit_speed);

  begin_static(*rig.model, rig.state, no_sliding, 0.0, stage);
  for (const Vector6d& a : stage.acceleration) EXPECT_EQ(0.0, a.norm());
  evaluate(*rig.model, rig.state, stage, still.data(), work, residual.data(), nullptr);
  EXPECT_EQ(0.0, work.result.forces.bit_speed);
}

// Accelerations are found from a stage that has none of its own, and from the state's rates whatever the unknowns are.
TEST(Evaluate, aStartHasNothingOfTheStageBefore)
{
  RigAtRest rig = build_at_rest(drilling_scene());
  const Vector3d n = x_axis(rig.state.nodes[1].orientation), across = n.unitOrthogonal();
  rig.state.nodes[1].rate = {Vector3d(0.1, 0.2, 0.3), 0.4 * across, 5.0};
  Stage stage(*rig.model);
  begin_step(*rig.model, rig.state, 0.01, Setpoints(), stage);
  prepare_implicit_euler(rig.state, 0.01, stage);
  for (Vector6d& a : stage.acceleration) a.setOnes();
  prepare_start(rig.state, stage);
  EXPECT_EQ(stage.dv_du, 0.0);
  EXPECT_EQ(stage.da_du, 0.0);
  for (const Vector6d& a : stage.acceleration) EXPECT_EQ(a.norm(), 0.0);
  Vector6d rate;
  rate << 0.1, 0.2, 0.3, 0.4 * across + 5.0 * n;
  EXPECT_LT((stage.rate[1] - rate).norm(), 1e-12);
}

// Mud is below the rig floor: what hangs above it is damped by none.
TEST(Evaluate, noSqueezeFilmAboveTheFloor)
{
  RigAtRest rig = lone_bit(weightless(lone_bit_scene()), [](MeshNode& bit, BeamSection&) { bit.squeeze_film_damping = 2400.0; });
  for (const double height : {-1.0, -0.1, 0.1, 0.9})
  {
    rig.state.nodes[0].position.z() = height;
    rig.state.nodes[0].rate.velocity = Vector3d(0.05, 0.0, 0.0);
    Stage stage(*rig.model);
    Workspace work(*rig.model);
    begin_step(*rig.model, rig.state, 0.0, Setpoints(), stage);
    prepare_start(rig.state, stage);
    EnergySample sample;
    sample_energy(*rig.model, rig.state, stage, no_increment(*rig.model).data(), work, sample);
    const double across = sample.force[static_cast<std::size_t>(NodeForce::squeeze_film)][0];
    EXPECT_NEAR(across, height < 0.0 ? 2400.0 * 0.05 : 0.0, 1e-6) << height;
  }
}

// Rock is that of the bottom's own depth.
TEST(Evaluate, theBitDrillsTheLayerItStandsOn)
{
  const FormationLayer soft{50.0, 1e-6, 1.0, 0.5, 0.0, 0.0, 0.0, 0.0}, hard{1e4, 1e-8, 1.0, 0.5, 0.0, 0.0, 0.0, 0.0};
  FormationLayer all_soft = soft;
  all_soft.to_tvd = 1e4;
  const double in_hard = drilled({hard});
  EXPECT_GT(in_hard, 1e-4);
  EXPECT_EQ(in_hard, drilled({soft, hard}));
  EXPECT_GT(drilled({all_soft}), 2.0 * in_hard);
}

// The speed that drills follows the bit's with the lag, w (1 - exp(-t/lag)) after a bit that stood begins to turn; a bit that
// stops drills nothing, whatever the mean is.
TEST(Evaluate, theSpeedThatDrillsIsTheMean)
{
  Scene scene = drilling_scene(2.0);
  scene.string[0].bit->speed_lag = 0.3;
  scene.rig.top_drive.gearbox_friction = 0.0;
  RigAtRest rig = build_at_rest(scene);
  for (NodeState& node : rig.state.nodes) node.rate.spin = 8.0;
  rig.state.drive.speed = 8.0;
  Setpoints turning;
  turning.top_drive.speed = 8.0;
  Stepper stepper(rig.model, find_method(IntegratorKind::automatic));
  for (int k = 0; k < 60; ++k) ASSERT_TRUE(stepper.advance(rig.state, 0.01, turning));
  EXPECT_NEAR(rig.state.bit.mean_speed, 8.0 * (1.0 - std::exp(-2.0)), 0.02);
  Stage stage(*rig.model);
  begin_step(*rig.model, rig.state, 0.01, turning, stage);
  EXPECT_EQ(stage.bit.drilling_speed, rig.state.bit.mean_speed);
  rig.state.nodes[0].rate.spin = 0.1;
  begin_step(*rig.model, rig.state, 0.01, turning, stage);
  EXPECT_DOUBLE_EQ(stage.bit.drilling_speed, 0.5);
  rig.state.nodes[0].rate.spin = -3.0;
  begin_step(*rig.model, rig.state, 0.01, turning, stage);
  EXPECT_EQ(stage.bit.drilling_speed, 0.0);
}

// Rock breaks under weight alone: a bit that leans on the wall off bottom drills no hole beside it.
TEST(Evaluate, withoutWeightNoRockBreaks)
{
  const RigAtRest rig = build_at_rest(drilling_scene());
  RigForces forces;
  forces.rock_force = Vector3d(2e4, 0.0, -2e4);
  EXPECT_EQ(rock_velocity(*rig.model, rig.state, forces, 10.0, -Vector3d::UnitZ()).norm(), 0.0);
  forces.wob = 2e4;
  EXPECT_LT(rock_velocity(*rig.model, rig.state, forces, 10.0, -Vector3d::UnitZ()).z(), -1e-5);
}

// Mesh nodes of different parts have walls of different stiffness.
TEST(Evaluate, eachNodesWallHasTheLawOfItsMesh)
{
  RigAtRest rig = lone_bit(lone_bit_scene(), [](MeshNode& bit, BeamSection&) { bit.contact = {7e8, 1.5, 0.0}; });
  EXPECT_EQ(rig.model->contact(0).law.stiffness, 7e8);
  EXPECT_EQ(rig.model->contact(1).law.stiffness, rig.model->mesh().nodes[1].contact.stiffness);
  rig.state.nodes[0].position.x() = 0.5 * 0.2159 - rig.model->mesh().nodes[0].contact_radius + 1e-3;
  Stage stage(*rig.model);
  Workspace work(*rig.model);
  begin_step(*rig.model, rig.state, 0.0, Setpoints(), stage);
  prepare_start(rig.state, stage);
  std::vector<double> residual(no_increment(*rig.model));
  evaluate(*rig.model, rig.state, stage, no_increment(*rig.model).data(), work, residual.data(), nullptr);
  const double force = 7e8 * std::pow(1e-3, 1.5);  // [N]
  EXPECT_NEAR(work.result.forces.contact[0], force, 1e-3 * force);
}
}  // namespace test_model_evaluate
