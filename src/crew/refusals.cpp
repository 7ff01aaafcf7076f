// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/refusals.h"

#include <algorithm>

namespace drill_rig_sim
{
const char* why_slips_are_not_set(const StringAtTable& now) noexcept
{
  if (now.by_reference) return "slips: not available with the reference (ida), allowed: the other integrators";
  if (now.in_slips) return "slips: the slips are already set";
  if (now.block_moves) return "slips: the block moves, allowed: at rest";
  if (now.top_drive_turns) return "slips: the top drive turns, allowed: at rest";
  return nullptr;
}

const char* why_slips_are_not_pulled(const StringAtTable& now) noexcept
{
  if (!now.in_slips) return "slips: the slips are not set";
  if (now.broken_out) return "slips: the connection is broken out, it must be made up first";
  return nullptr;
}

const char* why_no_connection(const StringAtTable& now) noexcept
{
  if (!now.in_slips) return "connection: the slips are not set";
  if (now.broken_out) return "connection: a connection is already under way";
  if (now.pump_runs) return "connection: the pump runs, allowed: off";
  if (now.top_drive_turns) return "connection: the top drive turns, allowed: at rest";
  if (now.block_moves || now.block_commanded) return "connection: the block moves, allowed: at rest";
  return nullptr;
}

const char* why_locked(const WinchSetpoint& command, const StringAtTable& now) noexcept
{
  return now.broken_out && moves(command) ? "the connection is broken out: the crew moves the block until it is made up"
                                          : nullptr;
}

const char* why_locked(const TopDriveSetpoint& command, const StringAtTable& now) noexcept
{
  return now.in_slips && turns(command) ? "the string is in the slips: the top drive is locked, allowed: at rest" : nullptr;
}

const char* why_locked(const PumpSetpoint& command, const StringAtTable& now) noexcept
{
  return now.broken_out && command.flow > 0.0 ? "the connection is broken out: the pump is locked, allowed: 0" : nullptr;
}

const char* what_is_wrong(const Scene& scene, double bit_depth, double hole_depth, const Fault& fault) noexcept
{
  const FaultPlace place = traits_of(fault.kind).place;
  if (scene.numerics.integrator == IntegratorKind::ida && !traits_of(fault.kind).by_ida)
    return "fault: not available by integrator ida";
  if (needs_pipe(fault.kind) && !(fault.depth > 0.0 && fault.depth <= bit_depth)) return no_pipe_there;
  if (place == FaultPlace::in_hole && !(fault.depth > 0.0 && fault.depth <= hole_depth))
    return "depth: allowed is a place of the hole, above 0 (the rotary table) and not below its bottom";
  if (place == FaultPlace::from_there_down && !(fault.depth >= 0.0 && fault.depth <= hole_depth))
    return "depth: allowed is 0 (all of the hole) to the hole's bottom";
  const bool has_motor =
      std::any_of(scene.string.begin(), scene.string.end(), [](const PartSpec& part) { return part.motor.has_value(); });
  if (fault.kind == FaultKind::motor_stall && !has_motor) return "fault: there is no mud motor in the string";
  return what_is_wrong_with_magnitude(fault);
}

}  // namespace drill_rig_sim
