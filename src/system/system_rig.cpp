// Drill line and top drive: what pulls and turns the top node.
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/system/system.h"

namespace drill_rig_sim
{
HoistState System::advance_hoist(const SystemState& state, double step) const noexcept
{
  const HoistingSpec& spec = scene_.rig.hoisting;
  const double height = state.nodes.back().position.z();
  const double hook_load = line_pull(spec, height, state.hoist.line_length).hook_force;
  const WinchStep winch =
      advance_winch(spec, setpoints_.winch, state.hoist.line_length, state.hoist.winch_speed, height, hook_load, step);
  return {winch.line_length, winch.speed, winch.limits.any()};
}

void System::add_rig(double* residual, BlockTridiagonal* tangent) noexcept
{
  const int top = nodes() - 1;
  const NodeScratch& s = scratch_[top];
  Eigen::Map<Vector6d> r(residual + 6 * top);

  const LinePull pull = line_pull(scene_.rig.hoisting, s.position.z(), hoist_end_.line_length);
  r[2] -= pull.hook_force - standard_gravity * scene_.rig.hoisting.block_mass;
  forces_.hook_load = pull.hook_force;

  // the shaft points down: spin is clockwise looking downhole, a turn about -z
  const RotorResult drive = drive_at(s.spin);
  r[5] += drive.meter_torque;
  forces_.meter_torque = drive.meter_torque;
  forces_.drive_torque = drive.motor_torque;
  const DriveState& start = start_->drive;
  drive_end_.angle = start.angle + drive.increment;
  drive_end_.speed = drive.state.speed;
  drive_end_.last_speed = start.speed;
  drive_end_.last_increment = drive.increment;
  drive_end_.acceleration = drive.acceleration;
  drive_end_.averaged_acceleration = start.averaged_acceleration;
  drive_end_.integral = drive.state.integral;
  drive_end_.meter_twist = drive.state.twist;
  drive_end_.limited = drive.limited;
  if (!tangent) return;
  tangent->diagonal(top)(2, 2) += pull.stiffness;
  tangent->diagonal(top)(5, 5) += drive.stiffness;
}

RotorResult System::drive_at(double top_spin) const noexcept
{
  const DriveState& start = start_->drive;
  const RotorState rotor{start.speed, start.integral, start.meter_twist};
  RotorStage stage = stage_.drive;
  stage.time = stage_.time;
  return solve_rotor(scene_.rig.top_drive, setpoints_.top_drive, rotor, stage, top_spin);
}

double System::drive_increment(const double* u) const noexcept
{
  const int top = nodes() - 1;
  return drive_at(Eigen::Map<const Vector6d>(u + 6 * top).tail<3>().dot(scratch_[top].normal_start)).increment;
}

}  // namespace drill_rig_sim
