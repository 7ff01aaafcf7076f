// SPDX-License-Identifier: BSD-3-Clause
#include "coloring.h"

namespace drill_rig_sim
{
namespace
{
constexpr double rpm = 0.10471975511965977;  // [rad/s]

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
  static const std::vector<Coloring> all{
      {"tension", "kN", 1e3, 1.0, 0.0, false},          {"torque", "kN m", 1e3, 1.0, 0.0, false},
      {"bending stress", "MPa", 1e6, 0.98, 0.0, false}, {"contact force", "kN/m", 1e3, 0.95, 0.0, false},
      {"spin speed", "rpm", rpm, 1.0, 0.0, false},      {"buckling factor", "1: buckles", 1.0, 1.0, 1.0, false},
      {"level of model", "", 1.0, 1.0, 1.0, true}};
  return all;
}

std::vector<double> values_of(std::size_t which, const StringData& data)
{
  if (which >= colorings().size() || colorings()[which].levels) return {data.guided.begin(), data.guided.end()};
  std::vector<double> values = quantity(which, data);
  for (double& value : values) value /= colorings()[which].unit_size;
  return values;
}

Color level_color(double guided) noexcept
{
  return guided < 0.5 ? Color{1.00f, 0.60f, 0.10f} : Color{0.55f, 0.90f, 0.20f};
}

}  // namespace drill_rig_sim
