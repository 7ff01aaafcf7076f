// SPDX-License-Identifier: BSD-3-Clause
// A stuck pipe holds: in statics, with the default method and with the reference, by the springs that it is held with.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/forces/stuck_point.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "drill_rig_sim/solve/start.h"
#include "test_scenes.h"

namespace test_solve_stuck_point
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr int stuck = 3;  // the node

/// 60 m of pipe free of the wall.
Scene hanging(IntegratorKind integrator = IntegratorKind::automatic)
{
  Scene scene = vertical_scene(100.0, 60.0);
  scene.string[0].bit->diameter = 0.2;
  scene.numerics.structural_damping = 1e-3;  // swings die within seconds
  scene.mud.axial_damping = 100.0;
  scene.mud.torsional_damping = 1.0;
  scene.rig.hoisting.rail_friction = 0.0;  // the hook load is to be the string's
  scene.numerics.integrator = integrator;
  return scene;
}

/// Stiffness of the string from the top down to the stuck node and of the spring that holds it, in series [N/m].
double pull_stiffness(const Mesh& mesh)
{
  double compliance = 1.0 / stuck_point_stiffness;
  for (std::size_t e = stuck; e < mesh.elements.size(); ++e)
    compliance += mesh.elements[e].section.length / mesh.elements[e].section.axial;
  return 1.0 / compliance;
}

/// The same in torsion [N m/rad].
double twist_stiffness(const Mesh& mesh)
{
  double compliance = 1.0 / stuck_point_torsion;
  for (std::size_t e = stuck; e < mesh.elements.size(); ++e) compliance += 1.0 / mesh.elements[e].section.torsion;
  return 1.0 / compliance;
}

/// What holds a rig's stuck node, of the string and of the place.
struct Hold
{
  double lift, turn;      // of the node since the start [m], [rad]
  double force, torque;   // change of tension and torque over the node since the start [N], [N m]
  double top_force;       // change of the hook load [N]
  double rise;            // of the top [m]
  double rest_of_torque;  // below the node [N m]
};

Hold hold_of(const SimulatorState& now, const SimulatorState& start)
{
  const NodeState &node = now.mechanics.nodes[stuck], &before = start.mechanics.nodes[stuck];
  const auto jump = [](const std::vector<double>& along) { return along[stuck] - along[stuck - 1]; };
  return {node.position.z() - before.position.z(),
          node.spin_angle - before.spin_angle,
          jump(now.forces.tension) - jump(start.forces.tension),
          jump(now.forces.torque) - jump(start.forces.torque),
          now.forces.hook_load - start.forces.hook_load,
          now.mechanics.nodes.back().position.z() - start.mechanics.nodes.back().position.z(),
          now.forces.torque[stuck - 1]};
}

/// Pulls and turns a rig that is stuck, then holds still for some seconds.
Hold pulled(Simulator& rig)
{
  const auto start = rig.save();
  const double stuck_md = start->truth.bit_depth - build_at_rest(rig.scene()).model->mesh().nodes[stuck].from_bit;
  EXPECT_TRUE(rig.stick_pipe(stuck_md));
  EXPECT_EQ(rig.save()->mechanics.stuck_point.node, stuck);
  rig.command(WinchSetpoint{0.01, false});
  TopDriveSetpoint drive;
  drive.speed = 0.2;
  rig.command(drive);
  for (int k = 0; k < 200; ++k) EXPECT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
  rig.command(WinchSetpoint{0.0, true});
  drive.speed = 0.0;
  rig.command(drive);
  for (int k = 0; k < 400; ++k) EXPECT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
  return hold_of(*rig.save(), *start);
}
}  // namespace

// The top is raised by 2 cm, then turned by a quarter: the string above the node and the spring carry it, below nothing changes.
TEST(StuckPoint, carriesTheLoadInStatics)
{
  RigAtRest rig = build_at_rest(hanging());
  const Mesh& mesh = rig.model->mesh();
  State state = rig.state;
  state.stuck_point = {stuck, state.nodes[stuck].position, state.nodes[stuck].spin_angle};
  NodeState& top = state.nodes.back();
  top.position.z() += 0.02;
  top.orientation = rotation_from_vector(-0.5 * pi * Vector3d::UnitZ()) * top.orientation;  // clockwise
  const StaticOutcome held = solve_static(*rig.model, state, no_sliding);
  ASSERT_TRUE(held.converged);
  const double force = 0.02 * pull_stiffness(mesh), torque = 0.5 * pi * twist_stiffness(mesh);
  ASSERT_GT(force, 1e5);
  EXPECT_NEAR(held.top_force - rig.statics.top_force, force, 1e-4 * force);
  EXPECT_NEAR(held.top_torque, torque, 1e-4 * torque);
  EXPECT_NEAR(state.nodes[stuck].position.z() - rig.state.nodes[stuck].position.z(), force / stuck_point_stiffness,
              1e-4 * force / stuck_point_stiffness);
  for (const NodeState& node : state.nodes) EXPECT_EQ(node.spin_angle, 0.0) << "a start: turns are counted from here";
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const double change = held.forces.tension[e] - rig.statics.forces.tension[e];
    EXPECT_NEAR(change, e < stuck ? 0.0 : force, 1e-4 * force) << e;
    EXPECT_NEAR(held.forces.torque[e], e < stuck ? 0.0 : torque, 1e-4 * torque) << e;
  }
}

// Bounds: what 4 s leave of the swings.
TEST(StuckPoint, holdsWithTheDefaultMethodAndTheReferenceAlike)
{
  const Mesh mesh = build_at_rest(hanging()).model->mesh();
  std::vector<Hold> holds;
  for (const IntegratorKind integrator : {IntegratorKind::automatic, IntegratorKind::ida})
  {
    Simulator rig(hanging(integrator));
    const Hold hold = pulled(rig);
    ASSERT_GT(hold.force, 1e5);
    ASSERT_GT(hold.torque, 500.0);
    EXPECT_NEAR(hold.lift, hold.force / stuck_point_stiffness, 0.01 * hold.lift);
    EXPECT_NEAR(hold.turn, hold.torque / stuck_point_torsion, 0.01 * hold.turn);
    EXPECT_NEAR(hold.top_force, hold.rise * pull_stiffness(mesh), 0.01 * hold.top_force);
    EXPECT_NEAR(hold.rest_of_torque, 0.0, 0.01 * hold.torque);
    holds.push_back(hold);
    // let go, the pipe springs back up
    rig.free_pipe();
    const auto stretched = rig.save();
    for (int k = 0; k < 300; ++k) ASSERT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
    const Hold freed = hold_of(*rig.save(), *stretched);
    EXPECT_NEAR(freed.force, -hold.force, 0.05 * hold.force);
    EXPECT_NEAR(freed.torque, -hold.torque, 0.05 * hold.torque);
    EXPECT_GT(freed.lift, 5.0 * hold.lift);
  }
  EXPECT_NEAR(holds[1].force, holds[0].force, 0.005 * holds[0].force);
  EXPECT_NEAR(holds[1].torque, holds[0].torque, 0.005 * holds[0].torque);
  EXPECT_NEAR(holds[1].rise, holds[0].rise, 0.005 * holds[0].rise);
}

// A force that appears or vanishes is a jump: what IDA remembers of the motion before is void.
TEST(StuckPoint, makesTheReferenceStartAfresh)
{
  Simulator rig(hanging(IntegratorKind::ida));
  const auto starts_of_a_frame = [&rig]
  {
    const std::uint64_t before = rig.statistics().reference.ida.starts;
    EXPECT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
    return rig.statistics().reference.ida.starts - before;
  };
  EXPECT_EQ(starts_of_a_frame(), 1u);
  EXPECT_EQ(starts_of_a_frame(), 0u) << "goes on";
  ASSERT_TRUE(rig.stick_pipe(40.0));
  EXPECT_EQ(starts_of_a_frame(), 1u);
  EXPECT_EQ(starts_of_a_frame(), 0u);
  rig.free_pipe();
  EXPECT_EQ(starts_of_a_frame(), 1u);
  rig.command(PumpSetpoint{0.02});
  EXPECT_EQ(starts_of_a_frame(), 0u) << "the pump's ramp is smooth";
  rig.command(WinchSetpoint{0.01, false});
  EXPECT_EQ(starts_of_a_frame(), 1u) << "set points";
}

// Where the pipe is when it sticks is where it is held, however far it has turned and come up by then.
TEST(StuckPoint, holdsThePipeAsItIs)
{
  Simulator rig(hanging());
  TopDriveSetpoint drive;
  drive.speed = 1.0;
  rig.command(drive);
  rig.command(WinchSetpoint{0.1, false});
  for (int k = 0; k < 500; ++k) ASSERT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
  drive.speed = 0.0;
  rig.command(drive);
  rig.command(WinchSetpoint{0.0, true});
  for (int k = 0; k < 3000; ++k) ASSERT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
  const auto before = rig.save();
  ASSERT_NEAR(before->mechanics.nodes[stuck].spin_angle, 5.0, 0.5);
  const double md = before->truth.bit_depth - build_at_rest(rig.scene()).model->mesh().nodes[stuck].from_bit;
  ASSERT_TRUE(rig.stick_pipe(md));
  ASSERT_EQ(rig.save()->mechanics.stuck_point.node, stuck);
  for (int k = 0; k < 100; ++k) ASSERT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
  const Hold hold = hold_of(*rig.save(), *before);
  EXPECT_LT(std::abs(hold.torque), 1.0);
  EXPECT_LT(std::abs(hold.turn), 1e-3);
  EXPECT_LT(std::abs(hold.lift), 1e-3);
}
}  // namespace test_solve_stuck_point
