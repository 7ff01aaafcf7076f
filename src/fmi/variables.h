// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_FMI_VARIABLES_H
#define DRILL_RIG_SIM_SRC_FMI_VARIABLES_H

#include <cstdint>
#include <string>
#include <vector>

#include "drill_rig_sim/instruments/signal_rows.h"
#include "drill_rig_sim/rig/setpoints.h"

/// The variables of a rig as an FMU: parameters, set points as inputs, all signals as outputs. A variable's place in the list is
/// its value reference.
namespace drill_rig_sim::fmi
{
enum class VariableType
{
  real,
  integer,
  boolean,
  drive_mode  ///< integer with the numbers and names of TopDriveMode
};

enum class Causality
{
  parameter,
  input,
  output
};

/// What the caller may set: set points, and what is not one.
struct Inputs
{
  Setpoints setpoints;
  bool tare = false;         ///< when it becomes true, weight on bit and differential pressure are zeroed
  int seed = 0;              ///< of the instruments' noise
  double rate = 100.0;       ///< frames a second [1/s]
  bool play_program = true;  ///< the scene's program and operations give the set points until an input changes
};

struct Variable
{
  std::string name;  ///< "winch.block_velocity", "readings.hook_load", "truth.wob"
  VariableType type;
  Causality causality;
  const char* unit;                          ///< SI, "" for none
  std::string meaning;                       ///< one line
  CommandKind command = CommandKind::winch;  ///< of a set point
  bool is_setpoint = false;
  double (*get)(const Inputs&) = nullptr;            ///< null for outputs
  void (*set)(Inputs&, double value) = nullptr;      ///< null for outputs
  double (*in_truth)(const Truth&) = nullptr;        ///< null unless it is an output of the truth
  double (*in_readings)(const Readings&) = nullptr;  ///< null unless it is an output of the readings
};

/// In the order of their value references.
const std::vector<Variable>& variables();
/// Of names, types and units: a model description with another one is of another program.
std::uint64_t variables_hash();

}  // namespace drill_rig_sim::fmi

#endif
