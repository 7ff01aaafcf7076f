// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_REFUSALS_H
#define DRILL_RIG_SIM_CREW_REFUSALS_H

#include "drill_rig_sim/crew/commands.h"
#include "drill_rig_sim/scene/scene.h"

/// Why slips, connections, faults and commands are refused: the rules that need no forces. The simulator obeys them, and the
/// rehearsal of a program (rehearsal.h) finds with them what a run would refuse. Each function returns one line in static
/// storage; null: nothing is refused.
namespace drill_rig_sim
{
/// Why no pipe can be gripped at a place.
inline constexpr char no_pipe_there[] =
    "depth: allowed is where there is pipe in the hole, above 0 (the rotary table) and not below the bit";

/// What the slips and a connection made by hand depend on.
struct StringAtTable
{
  bool by_reference = false;  ///< the integrator is ida
  bool in_slips = false;
  bool broken_out = false;  ///< a connection is under way
  bool block_moves = false;
  bool block_commanded = false;  ///< to move, whether it does or not
  bool top_drive_turns = false;  ///< or is commanded to
  bool pump_runs = false;        ///< or is commanded to
};

const char* why_slips_are_not_set(const StringAtTable& now) noexcept;
const char* why_slips_are_not_pulled(const StringAtTable& now) noexcept;
const char* why_no_connection(const StringAtTable& now) noexcept;

/// Why a command is locked, while no crew works by itself.
const char* why_locked(const WinchSetpoint& command, const StringAtTable& now) noexcept;
const char* why_locked(const TopDriveSetpoint& command, const StringAtTable& now) noexcept;
const char* why_locked(const PumpSetpoint& command, const StringAtTable& now) noexcept;

/// Why a fault is refused in a scene, with bit and hole at these depths [m MD].
const char* what_is_wrong(const Scene& scene, double bit_depth, double hole_depth, const Fault& fault) noexcept;

}  // namespace drill_rig_sim

#endif
