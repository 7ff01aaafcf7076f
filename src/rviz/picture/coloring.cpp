// SPDX-License-Identifier: BSD-3-Clause
#include "coloring.h"

#include <algorithm>

namespace drill_rig_sim
{
namespace
{
std::vector<double> quantity(std::size_t which, const StringData& data)
{
  switch (which)
  {
    case 0:
      return data.tension;
    case 1:
      return data.torque;
    case 2:
      return data.bending_stress;
    case 3:
      return side_force(data);
    case 4:
      return data.spin_speed;
    default:
      return data.buckling;
  }
}
}  // namespace

const std::vector<Coloring>& colorings()
{
  static const std::vector<Coloring> all{{"tension", Dimension::force, "", 1e3, 1.0, 0.0, false},
                                         {"torque", Dimension::torque, "", 100.0, 1.0, 0.0, false},
                                         {"bending stress", Dimension::specific_energy, "", 1e6, 0.98, 0.0, false},
                                         {"contact force", Dimension::force_per_length, "", 10.0, 0.95, 0.0, false},
                                         {"spin speed", Dimension::rotation, "", 0.1, 1.0, 0.0, false},
                                         {"buckling factor", Dimension::number, "1: buckles", 0.0, 1.0, 1.0, false},
                                         {"level of model", Dimension::number, "", 0.0, 1.0, 1.0, true}};
  return all;
}

std::vector<double> values_of(std::size_t which, const StringData& data, UnitSystem units)
{
  if (which >= colorings().size() || colorings()[which].levels) return {data.guided.begin(), data.guided.end()};
  std::vector<double> values = quantity(which, data);
  for (double& value : values) value = to_shown(value, colorings()[which].dimension, units);
  return values;
}

ColorScale at_least(const ColorScale& scale, const Coloring& coloring, UnitSystem units)
{
  if (!(coloring.least_scale > 0.0)) return scale;
  const double least = round_up(to_shown(coloring.least_scale, coloring.dimension, units) * (1.0 - 1e-9));
  return {-scale.low() < least ? 0.0 : scale.low(), std::max(scale.high(), least)};
}

Color level_color(double guided) noexcept
{
  return guided < 0.5 ? Color{1.00f, 0.60f, 0.10f} : Color{0.55f, 0.90f, 0.20f};
}

}  // namespace drill_rig_sim
