// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/string/mud.h"

#include <algorithm>

namespace drill_rig_sim
{
double confinement(double diameter, double hole_diameter) noexcept
{
  constexpr double most = 5.0;
  const double body = diameter * diameter, hole = hole_diameter * hole_diameter;
  const double room = std::max(hole - body, 0.0);
  return std::min((hole + body) / std::max(room, 1e-12 * body), most);
}

double fill_level(const MudSpec& mud, double bit_depth) noexcept
{
  const std::vector<FillLevel>& rows = mud.fill;
  const auto above = std::upper_bound(rows.begin(), rows.end(), bit_depth,
                                      [](double depth, const FillLevel& row) { return depth < row.bit_depth; });
  if (rows.empty()) return 0.0;
  if (above == rows.begin()) return rows.front().level;
  if (above == rows.end()) return rows.back().level;
  const FillLevel &upper = above[-1], &lower = *above;
  return upper.level + (lower.level - upper.level) * (bit_depth - upper.bit_depth) / (lower.bit_depth - upper.bit_depth);
}

}  // namespace drill_rig_sim
