// SPDX-License-Identifier: BSD-3-Clause
#include "variables.h"

#include <type_traits>
#include <utility>

#include "drill_rig_sim/math/hash.h"

namespace drill_rig_sim::fmi
{
namespace
{
template <class T>
constexpr VariableType type_of_field = VariableType::real;
template <>
constexpr VariableType type_of_field<int> = VariableType::integer;
template <>
constexpr VariableType type_of_field<bool> = VariableType::boolean;
template <>
constexpr VariableType type_of_field<TopDriveMode> = VariableType::drive_mode;

/// The variable of a field of Inputs.
template <auto field>
Variable own(const char* name, Causality causality, const char* unit, const char* meaning)
{
  using T = std::decay_t<decltype(std::declval<Inputs>().*field)>;
  Variable v{name, type_of_field<T>, causality, unit, meaning};
  v.get = [](const Inputs& in) { return static_cast<double>(in.*field); };
  v.set = [](Inputs& in, double value) { in.*field = static_cast<T>(value); };
  return v;
}

/// The variable of a field of one kind of set points.
template <auto kind, auto field>
Variable setpoint(CommandKind command, const char* name, const char* unit, const char* meaning)
{
  using T = std::decay_t<decltype(std::declval<Setpoints>().*kind.*field)>;
  Variable v{std::string(command_kind_names[static_cast<int>(command)]) + "." + name,
             type_of_field<T>,
             Causality::input,
             unit,
             meaning,
             command,
             true};
  v.get = [](const Inputs& in) { return static_cast<double>(in.setpoints.*kind.*field); };
  v.set = [](Inputs& in, double value) { in.setpoints.*kind.*field = static_cast<T>(value); };
  return v;
}

std::vector<Variable> inputs()
{
  constexpr auto winch = CommandKind::winch, top_drive = CommandKind::top_drive, pump = CommandKind::mud_pump,
                 steering = CommandKind::steering;
  return {
      own<&Inputs::seed>("seed", Causality::parameter, "", "of the instruments' noise, 0 or more"),
      own<&Inputs::rate>("rate", Causality::parameter, "1/s",
                         "frames a second; a communication step holds a whole number of frames"),
      own<&Inputs::play_program>("play_program", Causality::parameter, "",
                                 "the scene's program and operations give the set points until a set point is changed"),
      own<&Inputs::tare>("tare", Causality::input, "",
                         "when it becomes true, surface_wob and differential_pressure are zeroed; the bit must be off bottom"),
      setpoint<&Setpoints::winch, &WinchSetpoint::block_velocity>(winch, "block_velocity", "m/s",
                                                                  "of the travelling block, + up"),
      setpoint<&Setpoints::winch, &WinchSetpoint::brake>(winch, "brake", "", "sets the brake of the drawworks"),
      setpoint<&Setpoints::top_drive, &TopDriveSetpoint::mode>(top_drive, "mode", "", "of the top drive"),
      setpoint<&Setpoints::top_drive, &TopDriveSetpoint::speed>(
          top_drive, "speed", "rad/s", "clockwise looking downhole; in modes angle and oscillate the largest, 0: the rig's"),
      setpoint<&Setpoints::top_drive, &TopDriveSetpoint::torque>(top_drive, "torque", "N m", "in mode torque"),
      setpoint<&Setpoints::top_drive, &TopDriveSetpoint::angle>(top_drive, "angle", "rad",
                                                                "of the shaft, in modes angle and oscillate"),
      setpoint<&Setpoints::top_drive, &TopDriveSetpoint::torque_limit>(top_drive, "torque_limit", "N m", "0: the rig's"),
      setpoint<&Setpoints::top_drive, &TopDriveSetpoint::brake>(top_drive, "brake", "", "sets the brake of the top drive"),
      setpoint<&Setpoints::top_drive, &TopDriveSetpoint::amplitude_right>(top_drive, "amplitude_right", "rad",
                                                                          "in mode oscillate, clockwise"),
      setpoint<&Setpoints::top_drive, &TopDriveSetpoint::amplitude_left>(top_drive, "amplitude_left", "rad",
                                                                         "in mode oscillate, counterclockwise"),
      setpoint<&Setpoints::pump, &PumpSetpoint::flow>(pump, "flow", "m3/s", "of the mud pump"),
      setpoint<&Setpoints::steering, &SteeringSetpoint::toolface>(
          steering, "toolface", "rad", "of a rotary steerable tool, clockwise from the high side, or from north near vertical"),
      setpoint<&Setpoints::steering, &SteeringSetpoint::ratio>(steering, "ratio", "", "of full steering, 0 to 1"),
  };
}

VariableType type_of(const SignalRow& row)
{
  const std::string type = row.type;
  return type == "bool"                        ? VariableType::boolean
         : type == "int32" || type == "uint32" ? VariableType::integer
                                               : VariableType::real;
}

Variable output(const SignalRow& row, const char* side)
{
  return {std::string(side) + "." + row.name, type_of(row), Causality::output, unit_of(row), row.meaning};
}

std::vector<Variable> all()
{
  std::vector<Variable> out = inputs();
  for (const SignalRow& row : signal_rows())
  {
    if (row.in_readings == nullptr) continue;
    out.push_back(output(row, "readings"));
    out.back().in_readings = row.in_readings;
  }
  for (const SignalRow& row : signal_rows())
  {
    if (row.in_truth == nullptr) continue;
    out.push_back(output(row, "truth"));
    out.back().in_truth = row.in_truth;
  }
  return out;
}
}  // namespace

const std::vector<Variable>& variables()
{
  static const std::vector<Variable> list = all();
  return list;
}

std::uint64_t variables_hash()
{
  std::string text;
  for (const Variable& v : variables()) text += v.name + " " + std::to_string(static_cast<int>(v.type)) + " " + v.unit + "\n";
  return hash_bytes(text.data(), text.size());
}

}  // namespace drill_rig_sim::fmi
