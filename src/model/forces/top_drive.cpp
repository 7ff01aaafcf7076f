// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/top_drive.h"

#include "drill_rig_sim/rig/top_drive.h"

namespace drill_rig_sim
{
namespace
{
RotorResult rotor_at(const Model& model, const State& start, const Stage& at, double top_spin) noexcept
{
  RotorStage stage = at.drive;
  stage.time = at.time;
  return solve_rotor(model.scene().rig.top_drive, at.setpoints.top_drive, start.drive, stage, top_spin);
}

void add_top_drive(const StageContext& at, const ForceRows& to) noexcept
{
  const int top = at.model.top();
  const RotorResult rotor = rotor_at(at.model, at.start, at.stage, at.node(top).spin);
  to.force(top)[5] += rotor.meter_torque;
  if (to.with_tangent()) to.slope(top)(5, 5) += rotor.stiffness;

  StageResult& result = at.work.result;
  result.forces.meter_torque = rotor.meter_torque;
  result.forces.drive_torque = rotor.motor_torque;
  result.forces.gear_friction = rotor.friction;
  result.drive = rotor.state;
  result.drive_increment = rotor.increment;
  result.drive_acceleration = rotor.acceleration;
}

void store_top_drive(const StageContext& at, StoredEnergy& energy) noexcept
{
  const TopDriveSpec& spec = at.model.scene().rig.top_drive;
  const DriveState& drive = at.work.result.drive;
  energy.rotor += 0.5 * spec.inertia * drive.speed * drive.speed;
  energy.meter += 0.5 * spec.meter_stiffness * drive.meter_twist * drive.meter_twist;
  energy.gear += 0.5 * gear_stiffness * drive.gear_twist * drive.gear_twist;
}

void sample_top_drive(const StageContext& at, EnergySample& sample) noexcept
{
  const StageResult& result = at.work.result;
  sample.drive_torque = result.forces.drive_torque;
  sample.gear_friction = result.forces.gear_friction;
  sample.rotor_speed = result.drive.speed;
  sample.rotor_inertia = at.model.scene().rig.top_drive.inertia * result.drive_acceleration;
  sample.rotor_increment = result.drive_increment;
}
}  // namespace

const Force top_drive = {"top drive", Cost::rig,     Sum::none,       add_top_drive,
                         nullptr,     add_top_drive, store_top_drive, sample_top_drive};

double drive_increment(const Model& model, const State& start, const Stage& stage, const double* u) noexcept
{
  const Eigen::Map<const Eigen::Vector3d> rotation(u + 3);
  return rotor_at(model, start, stage, rotation.dot(stage.normal.back())).increment;
}

}  // namespace drill_rig_sim
