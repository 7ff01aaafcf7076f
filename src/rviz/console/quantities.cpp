// SPDX-License-Identifier: BSD-3-Clause
#include "quantities.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <deque>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim::console
{
namespace
{
Dimension dimension_of(std::string_view signal)
{
#define BOTH(type, name, dimension, ...) \
  if (signal == #name) return Dimension::dimension;
#include "drill_rig_sim/scene/signal_list.h"
  return Dimension::number;
}

/// Lives as long as the process.
const char* kept(const std::string& text)
{
  static std::deque<std::string> texts;
  return texts.emplace_back(text).c_str();
}

QuantityRow of_signal(Quantity quantity, const char* name, const char* label, double usual)
{
  return {quantity, name, label, kept(std::string("rig_state/") + name), dimension_of(name), usual};
}

using Rows = std::array<QuantityRow, quantity_count>;

/// Those with a name in the code.
Rows named_rows()
{
#define ROW(name, label, usual) of_signal(Quantity::name, #name, label, usual)
  return {{
      ROW(hook_load, "Hook load", 1e5),
      ROW(surface_wob, "WOB", 2e4),
      ROW(torque, "Torque", 5e3),
      ROW(top_drive_speed, "Top drive", 10.0),
      ROW(rop, "ROP", 20.0 / 3600.0),
      ROW(stand_pipe_pressure, "Stand pipe", 1e7),
      ROW(differential_pressure, "Diff. pressure", 2e6),
      ROW(flow, "Flow", 0.02),
      ROW(bit_depth, "Bit depth", 100.0),
      ROW(hole_depth, "Hole depth", 100.0),
      ROW(block_height, "Block height", 30.0),
      {Quantity::inclination, "inclination", "Inclination", "downhole/mwd, downhole/inclination", Dimension::angle, 0.5 * pi},
      {Quantity::azimuth, "azimuth", "Azimuth", "downhole/mwd", Dimension::angle, 2.0 * pi},
      {Quantity::toolface, "toolface", "Toolface", "downhole/toolface", Dimension::angle, pi},
      {Quantity::stick_slip, "stick_slip", "Stick-slip", "downhole/dynamics", Dimension::number, 1.0},
      {Quantity::specific_energy, "specific_energy", "MSE", "rig_state and the bit's diameter", Dimension::specific_energy, 1e8},
      ROW(dead_line_hook_load, "Dead line", 1e5),
      ROW(block_velocity, "Block speed", 0.01),
      ROW(top_drive_angle, "Drive angle", 2.0 * pi),
      ROW(stroke_rate, "Strokes", 1.0),
      ROW(ecd, "ECD", 1500.0),
  }};
#undef ROW
}

/// Under its name, to the scale that others of its dimension have.
QuantityRow other_row(Quantity quantity, const char* name, const Rows& rows)
{
  std::string label = name;
  std::replace(label.begin(), label.end(), '_', ' ');
  label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
  double usual = 1.0;
  for (const QuantityRow& row : rows)
    if (row.key != nullptr && row.dimension == dimension_of(name)) usual = row.usual;
  return of_signal(quantity, name, kept(label), usual);
}

Rows all_rows()
{
  Rows rows = named_rows();
  std::size_t n = index_of(Quantity::other);
#define BOTH(type, name, ...)                                     \
  if constexpr (std::is_same_v<type, double> && !is_named(#name)) \
  {                                                               \
    rows[n] = other_row(static_cast<Quantity>(n), #name, rows);   \
    ++n;                                                          \
  }
#include "drill_rig_sim/scene/signal_list.h"
  return rows;
}
}  // namespace

const std::array<QuantityRow, quantity_count>& quantities()
{
  static const Rows rows = all_rows();
  return rows;
}

const QuantityRow& row_of(Quantity quantity)
{
  return quantities()[index_of(quantity)];
}

Quantity quantity_of(const std::string& key)
{
  for (const QuantityRow& row : quantities())
    if (key == row.key) return row.quantity;
  return Quantity::count;
}

double specific_energy(double weight, double torque, double speed, double rop, double diameter)
{
  if (!(diameter > 0.0) || !(rop > least_rop)) return missing;
  const double area = 0.25 * pi * diameter * diameter;
  return weight / area + torque * speed / (area * rop);
}

std::string number_text(double si, Dimension dimension, UnitSystem system)
{
  const Unit& unit = unit_of(dimension, system);
  double shown = to_shown(si, dimension, system);
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
