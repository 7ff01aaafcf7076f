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
      {Flag::buckled, "buckled", "buckled: pipe compressed beyond its critical buckling load", Level::caution},
      {Flag::motor_stalled, "motor_stalled", "mud motor stalled", Level::alarm},
      {Flag::relief_valve_open, "relief_valve_open", "relief valve open: part of the flow goes back", Level::alarm},
      {Flag::pump_tripped, "pump_tripped", "pump tripped: no flow until a flow of 0 is commanded", Level::alarm},
      {Flag::drive_tripped, "drive_tripped", "top drive tripped: it coasts", Level::alarm},
      {Flag::commands_timed_out, "commands_timed_out", "commands stopped: brake set, drive coasts", Level::alarm},
      {Flag::command_clamped, "command_clamped", "command clamped to a limit", Level::caution},
      {Flag::stop_reached, "stop_reached", "block at its lowest or highest place", Level::caution},
      {Flag::winch_limited, "winch_limited", "winch held back by a limit", Level::caution},
      {Flag::top_drive_limited, "top_drive_limited", "top drive at a limit of torque, speed or power", Level::caution},
      {Flag::brake_set, "brake_set", "drawworks brake set", Level::normal},
      {Flag::top_drive_brake_set, "top_drive_brake_set", "top drive's brake set", Level::normal},
      {Flag::in_slips, "in_slips", "string in the slips", Level::normal},
      {Flag::on_bottom, "on_bottom", "bit on bottom (truth)", Level::normal},
  }};
  return rows;
}

const std::array<FaultRow, fault_count>& fault_rows()
{
  constexpr Dimension of_gauge = Dimension::count, number = Dimension::number;
  static const std::array<FaultRow, fault_count> rows = {{
      {0, "stuck pipe", true, nullptr, number, 0.0, false},
      {1, "sensor freeze", false, nullptr, number, 0.0, true},
      {2, "sensor bias", false, "error", of_gauge, 0.0, true},
      {3, "sensor noise", false, "deviation", of_gauge, 0.0, true},
      {4, "brake slip", false, "holds", Dimension::force, 1e5, false},
      {5, "drive trip", false, nullptr, number, 0.0, false},
      {6, "motor stall", false, nullptr, number, 0.0, false},
      {7, "washed-out hole", true, "wider by", Dimension::diameter, 0.05, false},
      {8, "pump trip", false, nullptr, number, 0.0, false},
      {9, "sensor drop-out", false, nullptr, number, 0.0, true},
      {10, "sensor drift", false, "per second", of_gauge, 0.0, true},
      {11, "differential sticking", true, "overpressure x length", Dimension::force_per_length, 1e6, false},
      {12, "pack-off", true, "drag", Dimension::force, 5e4, false},
      {13, "friction change", true, "factor", number, 1.5, false},
      {14, "formation change", false, "factor", number, 0.5, false},
      {15, "washed-out pipe", true, "hole", Dimension::area, 1e-4, false},
  }};
  return rows;
}

const std::array<Quantity, 6>& failing_gauges()
{
  static const std::array<Quantity, 6> gauges = {Quantity::hook_load,           Quantity::dead_line_hook_load, Quantity::torque,
                                                 Quantity::stand_pipe_pressure, Quantity::flow,                Quantity::block_height};
  return gauges;
}

}  // namespace drill_rig_sim::console
