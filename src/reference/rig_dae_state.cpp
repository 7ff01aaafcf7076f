// SPDX-License-Identifier: BSD-3-Clause
// From the differential-algebraic system back to the model: a stage within an interval, and the state at its end.
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/reference/rig_dae.h"

namespace drill_rig_sim
{
using Eigen::Map;
using Eigen::Vector3d;

void RigDae::fill_stage(double t, const double* y, const double* rate, Stage& stage, double* u)
{
  read(y);
  move_stage(model_, *start_, t - start_time_, stage);
  for (int i = 0; i < string_nodes(); ++i)
  {
    const GivenNode node = motion_of(i, y);
    Map<Vector6>(u + 6 * i) = node.increment;
    stage.rate[static_cast<std::size_t>(i)] = node.rate;
    stage.acceleration[static_cast<std::size_t>(i)] = Map<const Vector6>(rate + 12 * i + 6);
  }
  stage.bit = bit_drive_at(y, motion_of(bit(), y));
  // a stage solves for its rotor: so stiff, the answer is where IDA has it
  constexpr double stiff = 1e10;  // [1/s2]
  const Vector3d& axis = motion(rotor()).normal;
  const double turn = spin(rotor(), y) - spin(rotor(), start_y_.data());
  stage.drive = {};
  stage.drive.rate_0 = motion(rotor()).angular_velocity.dot(axis);
  stage.drive.da_du = stiff;
  stage.drive.acceleration_0 = Map<const Vector3d>(rate + 12 * rotor() + 9).dot(axis) - stiff * turn;
}

void RigDae::finish(double t, const std::vector<double>& y, State& state)
{
  read(y.data());
  take_motion(t, y.data());
  evaluate_motion(model_, *start_, stage_, motion_, work_, string_.data(), contact_.data(), nullptr, nullptr);
  const Drive drive = drive_at(y.data());
  StageResult& result = work_.result;
  const BlockForces on_block = block_forces(y.data());
  result.forces.hook_load = on_block.hook_load();
  result.forces.block_resistance = on_block.resistance();
  result.rail_deflection = on_block.rail.next;
  result.forces.meter_torque = model_.scene().rig.top_drive.meter_stiffness * drive.twist;
  result.forces.drive_torque = drive.by_drive.motor;
  result.forces.gear_friction = drive.by_drive.friction;
  result.drive = drive.by_drive.state;
  result.bit.motor_speed = stage_.bit.motor_speed;
  result.bit.mean_speed = stage_.bit.mean_speed;

  commit(stage_, work_, state);
  for (int i = 0; i < string_nodes(); ++i)
  {
    NodeState& node = state.nodes[static_cast<std::size_t>(i)];
    const BodyMotion& m = motion(i);
    const double spin_rate = m.angular_velocity.dot(m.normal);
    node.position = m.position;
    node.orientation = m.orientation.normalized();
    node.rate = {m.velocity, m.angular_velocity - spin_rate * m.normal, spin_rate};
  }
  advance_discrete(model_, stage_, work_, state);
}

}  // namespace drill_rig_sim
