// SPDX-License-Identifier: BSD-3-Clause
// The gauge pads of a bit: two circles on the wall, one gauge length apart, that resist a tilt of the bit.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/sim/profile.h"
#include "lone_bit.h"
#include "one_step.h"

namespace test_model_gauge_length
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double step = 0.01, radius = 0.5 * 0.2159, length = 0.15, clearance = 4e-4;  // [s], of bit and hole [m]

/// A bit in the hole that it has cut, its axis tilted towards the east about its centre.
struct TiltedBit
{
  RigAtRest rig;
  Workspace work;

  explicit TiltedBit(double tilt, double friction = 0.0) : rig(build_at_rest(scene(friction))), work(*rig.model)
  {
    NodeState &lower = rig.state.nodes[0], &upper = rig.state.nodes[1];
    upper.position = lower.position + length * Vector3d(-std::sin(tilt), 0.0, std::cos(tilt));
    const Eigen::Quaterniond turn = rotation_from_vector(Vector3d(0.0, -tilt, 0.0));
    for (NodeState* node : {&lower, &upper}) node->orientation = turn * node->orientation;
  }
  static Scene scene(double friction)
  {
    Scene scene = lone_bit_scene();
    scene.well.sections[0].friction = friction;
    scene.string = {bit_part(2.0 * radius), pipe_part(0, 4.0, plain_pipe_mass, pipe_outer)};
    scene.string[0].bit->gauge_length = length;
    scene.string[0].bit->gauge_clearance = clearance;
    return scene;
  }
  const RigForces& forces()
  {
    evaluate_one_step(rig, step, {}, work);
    return work.result.forces;
  }
  double stiffness() const { return rig.model->mesh().nodes[0].contact.stiffness; }
};
}  // namespace

// M = L cos(t) k (L sin(t) - c)^1.5: nothing within the free play, and back towards the hole's axis beyond it.
TEST(GaugeLength, resistsATiltBeyondItsPlay)
{
  for (const double tilt : {0.0, 0.5 * clearance / length, 0.99 * clearance / length})
    EXPECT_LT(TiltedBit(tilt).forces().bit_moment.norm(), 1e-3) << tilt;
  for (const double share : {1.5, 2.0, 5.0, 10.0})
  {
    const double tilt = share * clearance / length;
    TiltedBit bit(tilt);
    const double force = bit.stiffness() * std::pow(length * std::sin(tilt) - clearance, 1.5);
    const RigForces& f = bit.forces();
    EXPECT_NEAR(f.contact[1], force, 1e-6 * force) << tilt;
    EXPECT_NEAR(f.bit_moment.y(), length * std::cos(tilt) * force, 1e-6 * length * force) << "against a tilt about - y";
    EXPECT_NEAR(f.bit_force.x(), force, 1e-6 * force);
    EXPECT_NEAR(f.rock_force.norm(), 0.0, 0.01) << "the pads cut nothing";
  }
}

TEST(GaugeLength, itsPadsTurnWithTheMotorAndLoadIt)
{
  constexpr double friction = 0.3, motor = 30.0;
  TiltedBit bit(5.0 * clearance / length, friction);
  bit.rig.state.bit.motor_speed = motor;
  const RigForces& f = bit.forces();
  ASSERT_GT(f.contact[1], 100.0);
  EXPECT_NEAR(f.motor_torque, friction * (radius - clearance) * f.contact[1], 0.01 * f.motor_torque);
}

// Of wall, film and motor at the pads' upper end, by fourth-order central differences; at no tilt of the step, where the tangent
// is exact.
TEST(GaugeLength, tangentIsThatOfTheResidual)
{
  TiltedBit bit(5.0 * clearance / length, 0.3);
  bit.rig.state.bit.motor_speed = 30.0;
  bit.rig.state.nodes[1].rate.velocity = Vector3d(0.01, 0.02, -0.1);
  bit.rig.state.nodes[1].rate.spin = 3.0;
  const Model& model = *bit.rig.model;
  Stage stage(model);
  begin_step(model, bit.rig.state, step, Setpoints(), stage);
  prepare_implicit_euler(bit.rig.state, step, stage);
  const std::size_t size = 6 * static_cast<std::size_t>(model.nodes());
  std::vector<double> u(size, 0.0), residual(size);
  BlockTridiagonal tangent;
  tangent.resize(model.nodes());
  evaluate(model, bit.rig.state, stage, u.data(), bit.work, residual.data(), &tangent);
  ASSERT_GT(bit.work.result.forces.contact[1], 100.0);
  constexpr double h = 3e-7, at[4] = {-2.0, -1.0, 1.0, 2.0}, weight[4] = {1.0, -8.0, 8.0, -1.0};
  for (int column = 0; column < 6; ++column)
  {
    Vector6d slope = Vector6d::Zero();
    for (int k = 0; k < 4; ++k)
    {
      u[6 + column] = at[k] * h;
      evaluate(model, bit.rig.state, stage, u.data(), bit.work, residual.data(), nullptr);
      slope += weight[k] / (12.0 * h) * Eigen::Map<const Vector6d>(residual.data() + 6);
    }
    u[6 + column] = 0.0;
    EXPECT_LT((tangent.diagonal(1).col(column) - slope).norm(), 1e-6 * slope.norm()) << column;
  }
}

// A bent motor presses its bit aside and tilts it: on a ball freely, on pads as far as their play and what they sink in.
TEST(GaugeLength, holdsTheBitOfABentMotorAlongItsHole)
{
  Scene scene = motor_drilling_scene(0.05);
  const double ball = static_report(scene, no_sliding).bit_tilt;
  scene.string[0].bit->gauge_length = length;
  scene.string[0].bit->gauge_clearance = clearance;
  const StaticReport pads = static_report(scene, no_sliding);
  const double pressed = std::pow(pads.outcome.forces.contact[1] / scene.contact.assembly_stiffness, 2.0 / 3.0) +
                         std::pow(pads.outcome.forces.contact[0] / scene.contact.assembly_stiffness, 2.0 / 3.0);
  EXPECT_GT(ball, 2.0 * pads.bit_tilt);
  ASSERT_GT(pads.outcome.forces.contact[1], 1e3);
  EXPECT_NEAR(pads.bit_tilt, (clearance + pressed) / length, 0.1 * pads.bit_tilt);
}
}  // namespace test_model_gauge_length
