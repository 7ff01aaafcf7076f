// SPDX-License-Identifier: BSD-3-Clause
#include "drill_units.h"

#include <cstdio>

namespace drill_rig_sim
{
CLI::Option* add_units(CLI::App& command, std::string& units)
{
  const auto known = [](const std::string& text) -> std::string
  { return text == "si" || text == "oilfield" ? "" : "'" + text + "' is not known, allowed: si or oilfield"; };
  return command
      .add_option("--units", units, "si (the default) or oilfield, of what is printed and drawn; JSON and CSV files stay in SI")
      ->type_name("SYSTEM")
      ->take_last()
      ->check(known);
}

std::string Printed::number(double si, Dimension dimension, const InSI& in_si) const
{
  char text[64];
  if (system_ == UnitSystem::si)
    std::snprintf(text, sizeof text, in_si.format, si * in_si.scale);
  else
    std::snprintf(text, sizeof text, "%.*f", unit_of(dimension, system_).decimals, to_shown(si, dimension, system_));
  const std::string shown = text;
  return shown[0] == '-' && shown.find_first_of("123456789") == std::string::npos ? shown.substr(1) : shown;
}

}  // namespace drill_rig_sim
