// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_FLAGS_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_FLAGS_H

#include <array>
#include <bitset>
#include <cstddef>

#include "drill_rig_sim/scene/instruments_spec.h"
#include "limits.h"

namespace drill_rig_sim::console
{
/// The flags of rig_state that are shown as a list.
enum class Flag : std::size_t
{
  accuracy_warning,
  over_pull,
  slack_line,
  over_stress,
  over_torque,
  buckled,
  motor_stalled,
  relief_valve_open,
  pump_tripped,
  drive_tripped,
  commands_timed_out,
  command_clamped,
  stop_reached,
  winch_limited,
  top_drive_limited,
  brake_set,
  top_drive_brake_set,
  in_slips,
  on_bottom,
  count
};
constexpr std::size_t flag_count = static_cast<std::size_t>(Flag::count);
using Flags = std::bitset<flag_count>;

struct FlagRow
{
  Flag flag;
  const char* key;   // field of RigState or RigTruth
  const char* text;  // what it means to a driller
  Level level;       // normal: no warning, only what is the case
};

/// The one table of flags, in the order of Flag. The page of drill web has its texts and ranks from it: after a change write
/// src/python/web/flags.py by test/tool/test_tables.py DRILL --write.
const std::array<FlagRow, flag_count>& flag_rows();
inline const FlagRow& row_of(Flag flag)
{
  return flag_rows()[static_cast<std::size_t>(flag)];
}

/// The gauges that can fail: fields of RigState, in the order of the bits of lost_gauges.
const std::array<Quantity, drill_rig_sim::gauge_count>& failing_gauges();

}  // namespace drill_rig_sim::console

#endif
