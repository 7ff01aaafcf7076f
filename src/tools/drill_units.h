// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_UNITS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_UNITS_H

#include <CLI/CLI.hpp>
#include <string>

#include "drill_rig_sim/math/shown_units.h"

namespace drill_rig_sim
{
/// `--units si|oilfield`, of commands that print for people; JSON and CSV files stay in SI.
CLI::Option* add_units(CLI::App& command, std::string& units);

/// SI numbers as a command prints them: by its own format in SI, with the unit and decimals of math/shown_units.h in oilfield
/// units.
class Printed
{
public:
  /// Of an option's value, "si" or "oilfield".
  explicit Printed(const std::string& units) : system_(units == "oilfield" ? UnitSystem::oilfield : UnitSystem::si) {}

  /// How a command writes a number in SI: {"%.1f", "kN", 1e-3} prints a force in kN with one decimal.
  struct InSI
  {
    const char* format;  ///< of printf, for a double
    const char* unit;
    double scale = 1.0;
  };

  /// Without a sign where it rounds to zero.
  std::string number(double si, Dimension dimension, const InSI& in_si) const;
  const char* unit(Dimension dimension, const InSI& in_si) const
  {
    return system_ == UnitSystem::si ? in_si.unit : unit_of(dimension, system_).name;
  }
  /// Number and unit.
  std::string operator()(double si, Dimension dimension, const InSI& in_si) const
  {
    return number(si, dimension, in_si) + " " + unit(dimension, in_si);
  }

private:
  UnitSystem system_;
};

}  // namespace drill_rig_sim

#endif
