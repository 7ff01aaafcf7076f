// SPDX-License-Identifier: BSD-3-Clause
#include "command_intake.h"

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/well/directions.h"
#include "frame_queue.h"

namespace drill_rig_sim
{
CommandIntake::CommandIntake(const Scene& scene, const Motion& motion, SimulatorState& state)
    : scene_(scene),
      motion_(motion),
      state_(state),
      commands_(state.commands),
      delay_(state.delay),
      downlink_(state.downlink),
      interlocks_(state.interlocks)
{
  delay_ = CommandDelay(scene_.rig.plc_latency, scene_.rig.hoisting.latency);
}

const char* CommandIntake::locked(const WinchSetpoint& c) const noexcept
{
  return state_.crew.doing == CrewTask::none ? why_locked(c, at_table()) : nullptr;
}

const char* CommandIntake::locked(const TopDriveSetpoint& c) const noexcept
{
  return state_.crew.doing == CrewTask::none ? why_locked(c, at_table()) : nullptr;
}

const char* CommandIntake::locked(const PumpSetpoint& c) const noexcept
{
  return state_.crew.doing == CrewTask::none ? why_locked(c, at_table()) : nullptr;
}

const char* CommandIntake::locked(const SteeringSetpoint&) const noexcept
{
  return motion_.model()->steerable() ? nullptr : "steering: the string has no rotary_steerable";
}

StringAtTable CommandIntake::at_table() const noexcept
{
  constexpr double standing_block = 0.01;  // bouncing in its lines by less it counts as at rest [m/s]
  const State& now = motion_.shown_at_ends();
  const Setpoints set = requested();
  const bool bounces =
      scene_.rig.heave.amplitude == 0.0 && std::abs(block_velocity(now)) > standing_block;  // in waves it always does
  StringAtTable at;
  at.by_reference = scene_.numerics.integrator == IntegratorKind::ida;
  at.in_slips = now.slips.node >= 0;
  at.broken_out = state_.connection.under_way;
  at.block_moves = std::abs(now.hoist.winch_speed) > standing_winch || (!at.in_slips && bounces);
  at.block_commanded = moves(set.winch);
  at.top_drive_turns = std::abs(now.drive.speed) > standing_rotor || (!at.in_slips && turns(set.top_drive));
  at.pump_runs = set.pump.flow > 0.0 || now.hydraulics.pump_flow > 0.0;
  return at;
}

void CommandIntake::watch() noexcept
{
  watch_commands(timeout_, motion_.now(), commands_);
  steer();
  delay_.take(commands_.in_force(), motion_.now());
  watch_interlocks(scene_.rig, state_.readings, commands_.in_force(), passed(), interlocks_);
}

/// What the actuators get after dead times.
Setpoints CommandIntake::passed() const noexcept
{
  return delay_.is_on() ? delay_.passed() : commands_.in_force();
}

/// What the tool in the string receives, and where it points.
void CommandIntake::steer() noexcept
{
  const Model& model = *motion_.model();
  const int node = model.mesh().steering_node();
  if (node < 0) return;
  Setpoints& asked = commands_.asked;
  const auto heard = downlink_.hear(motion_.now(), state_.truth.bit_flow, model.steerable()->downlink_bit_time);
  if (heard) asked.steering = *heard;
  const Eigen::Vector3d axis = x_axis(motion_.shown_at_ends().nodes[node].orientation);
  asked.magnetic_steering = toolface_reference(axis, asked.magnetic_steering).magnetic;
}

Setpoints CommandIntake::in_force() const noexcept
{
  return restrained(passed(), interlocks_, state_.mechanics.faults);
}

void CommandIntake::follow(const FrameOrder& order) noexcept
{
  commands_ = order.commands;
  delay_.follow(order.passed);
  downlink_ = order.downlink;
  interlocks_ = order.interlocks;
}

}  // namespace drill_rig_sim
