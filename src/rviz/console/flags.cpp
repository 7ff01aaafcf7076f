// SPDX-License-Identifier: BSD-3-Clause
#include "flags.h"

namespace drill_rig_sim::console
{
const std::array<FlagRow, flag_count>& flag_rows()
{
  static const std::array<FlagRow, flag_count> rows = {{
      {Flag::accuracy_warning, "accuracy_warning", "accuracy: the simulation itself may be wrong", Level::caution},
      {Flag::over_pull, "over_pull", "over-pull: brake set until a command that does not raise", Level::alarm},
      {Flag::slack_line, "slack_line", "slack line: the lines carry nothing", Level::alarm},
      {Flag::over_stress, "over_stress", "over-stress: pipe beyond its yield strength", Level::alarm},
      {Flag::over_torque, "over_torque", "over-torque: beyond a connection's make-up torque", Level::alarm},
      {Flag::buckled, "buckled", "buckling: pipe compressed beyond its critical buckling load", Level::alarm},
      {Flag::motor_stalled, "motor_stalled", "mud motor stalled", Level::alarm},
      {Flag::relief_valve_open, "relief_valve_open", "relief valve open: part of the flow goes back", Level::alarm},
      {Flag::pump_tripped, "pump_tripped", "pump tripped: no flow until a flow of 0 is commanded", Level::alarm},
      {Flag::drive_tripped, "drive_tripped", "top drive tripped: it coasts", Level::alarm},
      {Flag::commands_timed_out, "commands_timed_out", "commands stopped: brake set, drive coasts", Level::alarm},
      {Flag::command_clamped, "command_clamped", "command clamped to a limit", Level::caution},
      {Flag::stop_reached, "stop_reached", "block at its lowest or highest position", Level::caution},
      {Flag::winch_limited, "winch_limited", "winch held back by a limit", Level::caution},
      {Flag::top_drive_limited, "top_drive_limited", "top drive at a limit of torque, speed or power", Level::caution},
      {Flag::brake_set, "brake_set", "drawworks brake set", Level::normal},
      {Flag::top_drive_brake_set, "top_drive_brake_set", "top drive's brake set", Level::normal},
      {Flag::in_slips, "in_slips", "string in the slips", Level::normal},
      {Flag::on_bottom, "on_bottom", "bit on bottom (truth)", Level::normal},
  }};
  return rows;
}

const std::array<Quantity, drill_rig_sim::gauge_count>& failing_gauges()
{
  static const std::array<Quantity, drill_rig_sim::gauge_count> gauges = []
  {
    std::array<Quantity, drill_rig_sim::gauge_count> found{};
    for (std::size_t n = 0; n < found.size(); ++n) found[n] = quantity_of(gauge_names[n]);
    return found;
  }();
  return gauges;
}

}  // namespace drill_rig_sim::console
