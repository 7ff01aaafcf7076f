// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TOP_DRIVE_FIXTURES_H
#define DRILL_RIG_SIM_TOP_DRIVE_FIXTURES_H

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/rig/top_drive.h"

/// Set points of a top drive, a rotor on its own, and what every solution of a step must fulfil.
namespace drill_rig_sim
{
/// A drive without friction.
inline TopDriveSpec smooth()
{
  TopDriveSpec spec;
  spec.gearbox_friction = 0.0;
  return spec;
}
inline TopDriveSetpoint speed_command(double speed)
{
  return {TopDriveMode::speed, speed, 0.0, 0.0, 0.0, false};
}
inline TopDriveSetpoint torque_command(double torque)
{
  return {TopDriveMode::torque, 0.0, torque, 0.0, 0.0, false};
}
inline TopDriveSetpoint brake_command()
{
  return {TopDriveMode::speed, 0.0, 0.0, 0.0, 0.0, true};
}

/// A rotor at `speed` [rad/s] whose loop has gathered `integral` [rad], its meter and gear twisted [rad].
inline DriveState running(double speed, double integral = 0.0, double meter_twist = 0.0, double gear_twist = 0.0,
                          bool braked = false)
{
  DriveState out;
  out.speed = out.reference = speed;
  out.integral = integral;
  out.meter_twist = meter_twist;
  out.gear_twist = gear_twist;
  out.braked = braked;
  return out;
}

/// Implicit Euler of length h from a start at `speed`.
inline RotorStage euler(double h, double speed)
{
  return {h, 1.0 / h, 1.0 / (h * h), 0.0, -speed / h};
}

/// The rotor alone: string top free, it follows the rotor without torque.
class FreeRotor
{
public:
  explicit FreeRotor(const TopDriveSpec& spec) : spec_(spec) {}

  RotorResult step(const TopDriveSetpoint& command, double h, double load = 0.0)
  {
    // the top turns so that the meter shows the load: T = k (twist + u - top); found by the linear answer, two passes for
    // branches
    double top = 0.0;
    RotorResult r;
    for (int i = 0; i < 4; ++i)
    {
      r = solve_rotor(spec_, command, state_, euler(h, state_.speed), top);
      top += (r.meter_torque - load) / std::max(r.stiffness, 1e-9);
    }
    r = solve_rotor(spec_, command, state_, euler(h, state_.speed), top);
    state_ = r.state;
    return r;
  }

  DriveState& state() { return state_; }

private:
  TopDriveSpec spec_;
  DriveState state_;
};

/// Checks the equation of motion and the derivative at a stage, and returns the result.
inline RotorResult check(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start,
                         const RotorStage& stage, double top)
{
  const RotorResult r = solve_rotor(spec, command, start, stage, top);

  const double acceleration = stage.da_du * r.increment + stage.acceleration_0;
  EXPECT_NEAR(spec.inertia * acceleration, r.motor_torque + r.friction - r.meter_torque, 1e-8 * (std::abs(r.meter_torque) + 1e4));
  EXPECT_NEAR(r.meter_torque, spec.meter_stiffness * (start.meter_twist + r.increment - top), 1e-8);
  const double h = 1e-7;
  const double slope = (solve_rotor(spec, command, start, stage, top + h).meter_torque -
                        solve_rotor(spec, command, start, stage, top - h).meter_torque) /
                       (2.0 * h);
  EXPECT_NEAR(-r.stiffness, slope, 1e-6 * std::abs(slope));
  EXPECT_LE(std::abs(r.motor_torque), motor_torque_limit(spec, command, start.speed) * (1.0 + 1e-12));
  return r;
}

}  // namespace drill_rig_sim

#endif
