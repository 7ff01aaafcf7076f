// Drill line and top drive: what pulls and turns the top node.
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/rig/top_drive.h"
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
  const DriveState& start = start_->drive;
  const RotorState rotor{start.speed, start.integral, start.meter_twist};
  const RotorStage stage{stage_.step, stage_.coefficient, stage_.drive_rate, stage_.drive_acceleration};
  const RotorResult drive = solve_rotor(scene_.rig.top_drive, setpoints_.top_drive, false, rotor, stage, s.spin);
  r[5] += drive.meter_torque;
  forces_.meter_torque = drive.meter_torque;
  drive_end_ = {start.angle + drive.increment, drive.state.speed, start.speed, drive.increment,
                drive.state.integral,          drive.state.twist, drive.limited};
  if (!tangent) return;
  tangent->diagonal(top)(2, 2) += pull.stiffness;
  tangent->diagonal(top)(5, 5) += drive.stiffness;
}

}  // namespace drill_rig_sim
