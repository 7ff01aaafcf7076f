#include "quantities.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim::console
{
const std::array<QuantityRow, quantity_count>& quantities()
{
  static const std::array<QuantityRow, quantity_count> rows = {{
      {Quantity::hook_load, "hook_load", "Hook load", "rig_state/hook_load", Dimension::force, 1e5},
      {Quantity::surface_wob, "surface_wob", "WOB", "rig_state/surface_wob", Dimension::force, 2e4},
      {Quantity::torque, "torque", "Torque", "rig_state/torque", Dimension::torque, 5e3},
      {Quantity::top_drive_speed, "top_drive_speed", "Top drive", "rig_state/top_drive_speed", Dimension::rotation, 10.0},
      {Quantity::rop, "rop", "ROP", "rig_state/rop", Dimension::penetration, 20.0 / 3600.0},
      {Quantity::stand_pipe_pressure, "stand_pipe_pressure", "Stand pipe", "rig_state/stand_pipe_pressure", Dimension::pressure, 1e7},
      {Quantity::differential_pressure, "differential_pressure", "Diff. pressure", "rig_state/differential_pressure", Dimension::pressure, 2e6},
      {Quantity::flow, "flow", "Flow", "rig_state/flow", Dimension::flow, 0.02},
      {Quantity::bit_depth, "bit_depth", "Bit depth", "rig_state/bit_depth", Dimension::length, 100.0},
      {Quantity::hole_depth, "hole_depth", "Hole depth", "rig_state/hole_depth", Dimension::length, 100.0},
      {Quantity::block_height, "block_height", "Block height", "rig_state/block_height", Dimension::length, 30.0},
      {Quantity::inclination, "inclination", "Inclination", "downhole/mwd, downhole/inclination", Dimension::angle, 0.5 * pi},
      {Quantity::azimuth, "azimuth", "Azimuth", "downhole/mwd", Dimension::angle, 2.0 * pi},
      {Quantity::toolface, "toolface", "Toolface", "downhole/toolface", Dimension::angle, pi},
      {Quantity::stick_slip, "stick_slip", "Stick-slip", "downhole/dynamics", Dimension::number, 1.0},
      {Quantity::specific_energy, "specific_energy", "MSE", "rig_state and the bit's diameter", Dimension::specific_energy, 1e8},
      {Quantity::dead_line_hook_load, "dead_line_hook_load", "Dead line", "rig_state/dead_line_hook_load", Dimension::force, 1e5},
      {Quantity::block_velocity, "block_velocity", "Block speed", "rig_state/block_velocity", Dimension::speed, 0.01},
      {Quantity::top_drive_angle, "top_drive_angle", "Drive angle", "rig_state/top_drive_angle", Dimension::angle, 2.0 * pi},
      {Quantity::stroke_rate, "stroke_rate", "Strokes", "rig_state/stroke_rate", Dimension::strokes, 1.0},
      {Quantity::ecd, "ecd", "ECD", "rig_state/ecd", Dimension::density, 1500.0},
  }};
  return rows;
}

const QuantityRow& row_of(Quantity quantity) { return quantities()[index_of(quantity)]; }

Quantity quantity_of(const std::string& key)
{
  for (const QuantityRow& row : quantities())
    if (key == row.key) return row.quantity;
  return Quantity::count;
}

double specific_energy(double weight, double torque, double speed, double rop, double diameter)
{
  if (!(diameter > 0.0) || !(rop > 0.1 / 3600.0)) return missing;
  const double area = 0.25 * pi * diameter * diameter;
  return weight / area + torque * speed / (area * rop);
}

std::string number_text(double si, Dimension dimension, UnitSystem system)
{
  const Unit& unit = unit_of(dimension, system);
  double shown = si * unit.per_si;
  if (!std::isfinite(shown)) return "-";
  const double half = 0.5 * std::pow(10.0, -unit.decimals);
  if (std::abs(shown) < half) shown = 0.0;  // no -0.0
  char text[64];
  std::snprintf(text, sizeof text, std::abs(shown) < 1e9 ? "%.*f" : "%.*e", unit.decimals, shown);
  return text;
}

std::string error_text(double si, Dimension dimension, UnitSystem system)
{
  if (!std::isfinite(si)) return "";
  const Unit& unit = unit_of(dimension, system);
  const double last_digit = std::pow(10.0, -unit.decimals) / unit.per_si;
  return "±" + number_text(std::max(si, last_digit), dimension, system);
}

}  // namespace drill_rig_sim::console
