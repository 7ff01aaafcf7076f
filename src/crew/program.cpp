// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/program.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drill_rig_sim/crew/refusals.h"
#include "drill_rig_sim/crew/rig_controls.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/drive_reference.h"

namespace drill_rig_sim
{
namespace
{
bool commands_top_drive(const ProgramStep& step) noexcept
{
  return step.top_drive_mode >= 0 || is_set(step.top_drive_speed) || is_set(step.top_drive_torque) ||
         is_set(step.top_drive_angle) || is_set(step.amplitude_right) || is_set(step.amplitude_left) ||
         is_set(step.torque_limit) || is_set(step.top_drive_brake);
}

/// By the line's own word or its keys; what says nothing of it leaves it.
TopDriveMode mode_of(const ProgramStep& step, TopDriveMode before) noexcept
{
  if (step.top_drive_mode >= 0) return static_cast<TopDriveMode>(step.top_drive_mode);
  if (is_set(step.amplitude_right) || is_set(step.amplitude_left)) return TopDriveMode::oscillate;
  if (is_set(step.top_drive_angle)) return goal_of(before) == DriveGoal::swing ? before : TopDriveMode::angle;
  if (is_set(step.top_drive_torque)) return TopDriveMode::torque;
  return is_set(step.top_drive_speed) && !keeps_speed(before) ? TopDriveMode::speed : before;
}

/// A command that is locked ends the run: what follows it in the program would be another run than the one that was written.
template <class Setpoint>
void give(const Setpoint& setpoint, RigControls& rig) noexcept
{
  const CommandResult result = rig.command(setpoint);
  if (result.outcome == CommandResult::Outcome::refused) rig.fail(result.reason);
}

Ramp ramp_of(const ProgramStep& step, double from, double to) noexcept
{
  return {from, to, step.at, step.ramp, true};
}
}  // namespace

double Ramp::value(double now) const noexcept
{
  if (over(now)) return to;
  return from + (to - from) * std::max(0.0, (now - at) / duration);
}

bool Ramp::over(double now) const noexcept
{
  return now >= at + duration - time_rounding;
}

double program_end(const std::vector<ProgramStep>& steps) noexcept
{
  double end = 0.0;
  for (const ProgramStep& step : steps) end = std::max(end, step.at + step.ramp);
  return end;
}

ProgramPlayer::ProgramPlayer(std::vector<ProgramStep> steps) : steps_(std::move(steps))
{
}

void ProgramPlayer::apply(RigControls& rig) noexcept
{
  const double now = rig.truth().time;
  for (; next_ < steps_.size() && steps_[next_].at <= now + time_rounding; ++next_)
  {
    follow(steps_[next_].at, rig);
    begin(steps_[next_], rig);
  }
  follow(now, rig);
}

bool ProgramPlayer::finished() const noexcept
{
  return next_ == steps_.size() && !block_velocity_.running && !top_drive_speed_.running && !top_drive_torque_.running &&
         !flow_.running;
}

void ProgramPlayer::rewind() noexcept
{
  next_ = 0;
  for (Ramp* ramp : {&block_velocity_, &top_drive_speed_, &top_drive_torque_, &flow_}) ramp->running = false;
}

void ProgramPlayer::begin(const ProgramStep& step, RigControls& rig) noexcept
{
  if (is_set(step.block_velocity) || is_set(step.brake)) begin_winch(step, rig);
  if (commands_top_drive(step)) begin_top_drive(step, rig);
  if (is_set(step.flow)) flow_ = ramp_of(step, rig.asked().pump.flow, step.flow);
  if (is_set(step.steering_toolface) || is_set(step.steering_ratio))
  {
    SteeringSetpoint steering = rig.asked().steering;
    if (is_set(step.steering_toolface)) steering.toolface = step.steering_toolface;
    if (is_set(step.steering_ratio)) steering.ratio = step.steering_ratio;
    give(steering, rig);
  }
  if (step.free == 1.0) rig.free_pipe();
  const Gauge gauge = static_cast<Gauge>(std::max(0, step.fault_gauge));
  if (step.clear_fault >= 0) rig.clear(static_cast<FaultKind>(step.clear_fault), gauge);
  if (is_set(step.slips))
    if (const char* refused = rig.set_slips(step.slips == 1.0)) rig.fail(refused);
  if (is_set(step.connection))
    if (const char* refused = rig.make_connection(static_cast<int>(std::abs(step.connection)), step.connection < 0.0))
      rig.fail(refused);
  if (is_set(step.free_length) && !rig.set_free_length(step.free_length))
    rig.fail("program: free_length is longer than before, allowed: shorter than before");
  if (is_set(step.stuck_at) && !rig.stick_pipe(step.stuck_at))
    rig.fail("program: stuck_at is below the bit, allowed: where there is pipe in the hole");
  if (step.fault < 0) return;
  const char* wrong = rig.inject({static_cast<FaultKind>(step.fault), step.fault_depth, step.fault_magnitude, gauge});
  if (wrong == no_pipe_there) wrong = "program: fault_depth is below the bit, allowed: where there is pipe in the hole";
  if (wrong) rig.fail(wrong);
}

void ProgramPlayer::begin_winch(const ProgramStep& step, RigControls& rig) noexcept
{
  WinchSetpoint winch = rig.asked().winch;  // what this line leaves out stays
  if (is_set(step.block_velocity))
  {
    block_velocity_ = ramp_of(step, winch.brake ? 0.0 : winch.block_velocity, step.block_velocity);
    winch = {block_velocity_.value(step.at), false};
  }
  if (is_set(step.brake)) winch.brake = step.brake != 0.0;
  if (winch.brake) block_velocity_.running = false;
  give(winch, rig);
}

void ProgramPlayer::begin_top_drive(const ProgramStep& step, RigControls& rig) noexcept
{
  TopDriveSetpoint drive = rig.asked().top_drive;
  const Truth& truth = rig.truth();
  const TopDriveMode before = drive.mode;
  drive.mode = mode_of(step, before);
  if (drive.mode != before) top_drive_speed_.running = top_drive_torque_.running = false;
  if (is_set(step.top_drive_speed))
  {
    const double from = turns_to_angle(drive.mode)            ? step.top_drive_speed
                        : keeps_speed(before) && !drive.brake ? drive.speed
                                                              : truth.top_drive_speed;
    top_drive_speed_ = ramp_of(step, from, step.top_drive_speed);
    drive.speed = top_drive_speed_.value(step.at);
  }
  if (is_set(step.top_drive_torque))
  {
    const bool in_force = before == TopDriveMode::torque && !drive.brake;
    top_drive_torque_ = ramp_of(step, in_force ? drive.torque : truth.torque, step.top_drive_torque);
    drive.torque = top_drive_torque_.value(step.at);
  }
  if (is_set(step.top_drive_angle)) drive.angle = step.top_drive_angle;
  if (is_set(step.amplitude_right)) drive.amplitude_right = step.amplitude_right;
  if (is_set(step.amplitude_left)) drive.amplitude_left = step.amplitude_left;
  if (is_set(step.torque_limit)) drive.torque_limit = step.torque_limit;
  drive.brake = step.top_drive_brake == 1.0;
  if (drive.brake) top_drive_speed_.running = top_drive_torque_.running = false;
  give(drive, rig);
}

void ProgramPlayer::follow(double now, RigControls& rig) noexcept
{
  const Setpoints in_force = rig.asked();
  const auto move = [now](Ramp& ramp, double& setpoint)
  {
    const bool moves = ramp.running;
    if (moves) setpoint = ramp.value(now);
    ramp.running = moves && !ramp.over(now);
    return moves;
  };
  WinchSetpoint winch = in_force.winch;
  if (move(block_velocity_, winch.block_velocity)) give(winch, rig);
  TopDriveSetpoint drive = in_force.top_drive;
  const bool by_speed = move(top_drive_speed_, drive.speed), by_torque = move(top_drive_torque_, drive.torque);
  if (by_speed || by_torque) give(drive, rig);
  PumpSetpoint pump = in_force.pump;
  if (move(flow_, pump.flow)) give(pump, rig);
}

}  // namespace drill_rig_sim
