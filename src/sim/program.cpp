#include "drill_rig_sim/sim/program.h"

#include <cmath>
#include <utility>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
namespace
{
bool is_set(double value) noexcept
{
  return !std::isnan(value);
}

void apply_step(const ProgramStep& step, Simulator& simulator) noexcept
{
  const Setpoints now = simulator.setpoints();  // what this line leaves out stays
  if (is_set(step.block_velocity) || is_set(step.brake))
  {
    WinchSetpoint winch = now.winch;
    if (is_set(step.block_velocity)) winch = {step.block_velocity, false};
    if (is_set(step.brake)) winch.brake = step.brake != 0.0;
    simulator.command(winch);
  }
  if (is_set(step.top_drive_speed) || is_set(step.top_drive_torque) || is_set(step.top_drive_brake))
  {
    TopDriveSetpoint drive = now.top_drive;
    drive.brake = step.top_drive_brake == 1.0;
    if (is_set(step.top_drive_speed))
    {
      drive.mode = TopDriveMode::speed;
      drive.speed = step.top_drive_speed;
    }
    if (is_set(step.top_drive_torque))
    {
      drive.mode = TopDriveMode::torque;
      drive.torque = step.top_drive_torque;
    }
    simulator.command(drive);
  }
  if (is_set(step.flow)) simulator.command(PumpSetpoint{step.flow});
}
}  // namespace

ProgramPlayer::ProgramPlayer(std::vector<ProgramStep> steps) : steps_(std::move(steps))
{
}

void ProgramPlayer::apply(Simulator& simulator) noexcept
{
  const double now = simulator.truth().time;
  for (; next_ < steps_.size() && steps_[next_].at <= now + time_rounding; ++next_) apply_step(steps_[next_], simulator);
}

}  // namespace drill_rig_sim
