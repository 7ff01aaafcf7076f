// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_QUANTITIES_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_QUANTITIES_H

#include <array>
#include <bitset>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include "units.h"

namespace drill_rig_sim::console
{
/// Numbers of the list of signals (scene/signal_list.h) that have a name in the code here.
constexpr std::string_view named_quantities[] = {"hook_load",
                                                 "surface_wob",
                                                 "torque",
                                                 "top_drive_speed",
                                                 "rop",
                                                 "stand_pipe_pressure",
                                                 "differential_pressure",
                                                 "flow",
                                                 "bit_depth",
                                                 "hole_depth",
                                                 "block_height",
                                                 "dead_line_hook_load",
                                                 "block_velocity",
                                                 "top_drive_angle",
                                                 "stroke_rate",
                                                 "ecd"};
constexpr bool is_named(std::string_view name)
{
  for (const std::string_view named : named_quantities)
    if (named == name) return true;
  return false;
}
/// The others: the chart has them too, under their names.
constexpr std::size_t other_quantities = 0
#define BOTH(type, name, ...) +(std::is_same_v<type, double> && !is_named(#name) ? 1 : 0)
#include "drill_rig_sim/scene/signal_list.h"
    ;

/// What gauges and chart show. Those before `dead_line_hook_load` have a gauge.
enum class Quantity : std::size_t
{
  hook_load,
  surface_wob,
  torque,
  top_drive_speed,
  rop,
  stand_pipe_pressure,
  differential_pressure,
  flow,
  bit_depth,
  hole_depth,
  block_height,
  inclination,
  azimuth,
  toolface,
  stick_slip,
  specific_energy,
  dead_line_hook_load,
  block_velocity,
  top_drive_angle,
  stroke_rate,
  ecd,
  other,  // the first of other_quantities
  count = other + other_quantities
};
constexpr std::size_t quantity_count = static_cast<std::size_t>(Quantity::count);
constexpr std::size_t gauge_count = static_cast<std::size_t>(Quantity::dead_line_hook_load);

struct QuantityRow
{
  Quantity quantity;
  const char* key;     // as the field of the message is called; names widgets, settings and columns
  const char* label;   // what is shown
  const char* source;  // topic and field
  Dimension dimension;
  double usual;  // its scale reaches so far at least, where no limit says more [SI]
};

/// The one table of what is shown, in the order of Quantity.
const std::array<QuantityRow, quantity_count>& quantities();
/// The row of a quantity.
const QuantityRow& row_of(Quantity quantity);
/// The quantity of this key; Quantity::count where there is none.
Quantity quantity_of(const std::string& key);
constexpr std::size_t index_of(Quantity quantity)
{
  return static_cast<std::size_t>(quantity);
}

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// All quantities at one instant [SI]; what is not known is NaN, and `why` gives the reason in two words.
struct Values
{
  Values()
  {
    value.fill(missing);
    why.fill("no reading");
    error.fill(missing);
  }
  double operator[](Quantity quantity) const { return value[index_of(quantity)]; }
  void set(Quantity quantity, double to) { value[index_of(quantity)] = to; }
  void lack(Quantity quantity, const char* reason)
  {
    value[index_of(quantity)] = missing;
    why[index_of(quantity)] = reason;
  }

  std::array<double, quantity_count> value;
  std::array<const char*, quantity_count> why;
  std::array<double, quantity_count> error;  // of the simulation, as its companion measures it [SI]; NaN: not measured
  std::bitset<quantity_count> lost;          // in a drop-out: repeats its last reading
};

constexpr double least_rop = 5e-5;  // from which on something is drilled: 0.18 m/h, as on the page of drill web [m/s]

/// Mechanical specific energy (Teale 1965), F/A + T w/(A v) [Pa], of weight F [N], torque T [N m], speed w [rad/s], rate of
/// penetration v [m/s] and the bit's diameter [m]. NaN below 0.18 m/h or without a diameter: nothing is drilled.
double specific_energy(double weight, double torque, double speed, double rop, double diameter);

/// A number as it is shown, without its unit; "-" where there is none.
std::string number_text(double si, Dimension dimension, UnitSystem system);
/// An error as it stands behind the number, "±0.3": at least one of the last digit shown; empty where there is none.
std::string error_text(double si, Dimension dimension, UnitSystem system);

}  // namespace drill_rig_sim::console

#endif
