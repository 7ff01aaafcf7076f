// SPDX-License-Identifier: BSD-3-Clause
#include "drill_tables.h"

#include "drill_rig_sim/instruments/signal_rows.h"
#include "drill_rig_sim/math/in_capitals.h"
#include "drill_rig_sim/rig/setpoints.h"
#include "drill_rig_sim/scene/fault_spec.h"
#include "drill_rig_sim/scene/read_scene.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t comment_column = 34;

/// A line of a message.
std::string line(std::string field, const std::string& comment)
{
  field.resize(std::max(field.size() + 1, comment_column), ' ');
  return field + "# " + comment + "\n";
}

std::string line(const SignalRow& row, bool with_reading)
{
  std::string comment = row.meaning;
  if (*unit_of(row)) comment += std::string(" [") + unit_of(row) + "]";
  const std::string reading = with_reading ? row.reading : "";
  if (!reading.empty() && reading != "exact" && reading != "the same") comment += ". Reading: " + reading;
  return line(std::string(row.type) + " " + row.name, comment);
}

std::string run_states()
{
  return line("uint8 RUNNING=0", "of run_state") + line("uint8 PAUSED=1", "time stands") +
         line("uint8 WAITING=2", "in lockstep: for the next step") +
         line("uint8 FAILED=3",
              "the next frame could not be computed: reset_well or restore_state; sent once, with the last good stamp");
}

std::string gauges()
{
  std::string text;
  for (int k = 0; k < gauge_count; ++k)
    text += line("uint32 " + in_capitals(gauge_names[k]) + "=" + std::to_string(1u << k), "of lost_gauges");
  return text;
}

std::string head_of_fields()
{
  return line("std_msgs/Header header", "stamp: end of the frame; frame_id: the rig floor") +
         line("uint8 run_state", "one of the constants above") +
         line("uint32 epoch", "grows by 1 with reset_well, load_survey and restore_state: a new run begins");
}

/// Operations and set points.
std::string tail_of_fields()
{
  return line("string current_operation",
              "of the rig's crew: connecting (make_connection), by connections: auto also stopping, lifting, quieting, slacking, "
              "picking_up, "
              "restarting, lowering; else of the operations (of the scene, or asked for by run_operations), by their words in "
              "scenes; empty: none") +
         line("uint32 operation_number", "of the operations, counted from 1; 0: none is under way [-]") +
         line("float64 operation_progress", "towards the nearest of its ends, 0 to 1 [-]") +
         line("time last_command", "stamp of the last accepted command; 0 = none yet") +
         line("WinchCommand winch",
              "set point in force; header.stamp: when it was accepted (before a file was restored: then); 0 = none yet, or the "
              "program's") +
         line("TopDriveCommand top_drive", "set point in force; header.stamp: when it was accepted") +
         line("MudPumpCommand mud_pump", "set point in force; header.stamp: when it was accepted");
}

/// Signals of the message of `own` beside those of both.
std::string fields(SignalOf own)
{
  std::string text;
  for (const SignalRow& row : signal_rows())
    if (row.of == SignalOf::both || row.of == own) text += line(row, own == SignalOf::reading);
  return text;
}

std::string rig_state_message()
{
  return "# A rig's signals at one instant as the driller's instruments show them, on rig_state. `drill reference --of "
         "RigState.msg` prints this.\n"
         "# \"Reading:\" says how a reading is made; a gauge adds the errors of the scene's key instruments.surface (noise, "
         "bias, delay, ...).\n" +
         run_states() + gauges() + head_of_fields() + fields(SignalOf::reading) + tail_of_fields() +
         line("string accuracy_code",
              "why accuracy_warning is set: a short identifier, which stays the same in later versions; empty: it is not set") +
         line("string accuracy_reason", "the same in one line, with the remedy") +
         line("uint32 commands_refused", "commands refused since the node began, by topics and services [-]") +
         line("string last_refusal", "why the last of them was; empty: none was");
}

std::string rig_truth_message()
{
  return "# A rig's signals at one instant as they are, on truth/rig_state: for judging a controller, not for feeding it.\n"
         "# `drill reference --of RigTruth.msg` prints this.\n" +
         run_states() + head_of_fields() + fields(SignalOf::truth) + tail_of_fields() +
         line("SteeringCommand steering",
              "that the rotary steerable tool obeys, by command or downlink; header.stamp: of the last command accepted") +
         line("bool magnetic_steering",
              "its toolface counts from north: the hole is nearer the vertical than 5 deg (hysteresis 4 and 6 deg)") +
         line("string[] active_faults",
              "the faults under way, by their words in scenes, those of gauges as \"sensor_bias of hook_load\"") +
         line("float64[] active_fault_depths",
              "measured depth of each of them, of a friction_change its upper end [m]; NaN: it has no place");
}

std::string message_of(const SignalRow& row)
{
  switch (row.of)
  {
    case SignalOf::both:
      return "`RigState`, `RigTruth`";
    case SignalOf::truth:
      return "`RigTruth`";
    case SignalOf::reading:
      return "`RigState`";
    case SignalOf::bit:
      break;
  }
  return *row.field ? "`BitTruth." + std::string(row.field) + "`" : "files";
}

std::string signals_for_readers()
{
  std::string text = "| signal | unit | message | meaning | reading |\n| --- | --- | --- | --- | --- |\n";
  for (const SignalRow& row : signal_rows())
    text += std::string("| `") + row.name + "` | " + unit_of(row) + " | " + message_of(row) + " | " + row.meaning + " | " +
            (row.by_gauge ? "gauge: " : "") + row.reading + " |\n";
  return text;
}

std::string modes_for_readers()
{
  std::string text = "| mode of the top drive | what it does |\n| --- | --- |\n";
  for (const TopDriveModeTraits& mode : top_drive_modes) text += "| " + in_capitals(mode.word) + " | " + mode.meaning + " |\n";
  return text;
}

std::string quoted(const std::string& text)
{
  return "\"" + text + "\"";
}

const char* word_of(SignalOf of)
{
  switch (of)
  {
    case SignalOf::both:
      return "both";
    case SignalOf::truth:
      return "truth";
    case SignalOf::reading:
      return "reading";
    case SignalOf::bit:
      break;
  }
  return "bit";
}

std::string signals_for_python()
{
  std::string text;
  for (const SignalRow& row : signal_rows())
    text += "    Signal(" + quoted(row.name) + ", " + quoted(word_of(row.of)) + ", " + quoted(row.type) + ", " +
            quoted(row.field) + ", " + quoted(row.quantity) + ", " + quoted(row.mnemonic) + ", " + std::to_string(row.item) +
            "),\n";
  return text;
}

/// A tuple of words.
template <class Rows, class Word>
std::string words_for_python(const char* name, const Rows& rows, const Word& word)
{
  std::string text = std::string(name) + " = (\n";
  for (const auto& row : rows) text += "    " + quoted(word(row)) + ",\n";
  return text + ")\n";
}

std::string python_tables()
{
  return "# SPDX-License-Identifier: BSD-3-Clause\n"
         "\"\"\"The lists of signals, top-drive modes, gauges and faults of include/drill_rig_sim, as `drill reference --of "
         "tables.py` prints them.\"\"\"\n"
         "import typing\n\n\n"
         "class Signal(typing.NamedTuple):\n"
         "    name: str      # of the column of drill run --csv\n"
         "    of: str        # both, truth, reading or bit\n"
         "    type: str      # in messages; \"\": in files only\n"
         "    field: str     # of RigState, RigTruth or BitTruth\n"
         "    quantity: str  # of drill_rig_sim.units\n"
         "    mnemonic: str  # in WITSML files; \"\": none\n"
         "    item: int      # in record 01 of WITS level 0; 0: none\n\n\n"
         "SIGNALS = (\n" +
         signals_for_python() + ")\n" +
         words_for_python("TOP_DRIVE_MODES", top_drive_modes, [](const TopDriveModeTraits& mode) { return mode.word; }) +
         words_for_python("GAUGES", gauge_names, [](const char* gauge) { return gauge; }) +
         words_for_python("FAULTS", fault_traits, [](const FaultTraits& fault) { return fault.word; });
}
}  // namespace

const std::vector<TableText>& table_texts()
{
  static const std::vector<TableText> texts = {{"scene", scene_reference},          {"signals", signals_for_readers},
                                               {"modes", modes_for_readers},        {"RigState.msg", rig_state_message},
                                               {"RigTruth.msg", rig_truth_message}, {"tables.py", python_tables}};
  return texts;
}

}  // namespace drill_rig_sim
