// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/contact/cut_ground.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
/// Where an angle is in the ring, in cells.
double cells_at(int blades, double angle) noexcept
{
  return angle * (blades * CutGround::cells / (2.0 * pi));
}

/// Of the cell of this number, counted on over any number of rounds.
std::size_t in_ring(double number) noexcept
{
  return static_cast<std::size_t>(number - std::floor(number / CutGround::cells) * CutGround::cells);
}

/// Of the ring as the blades have left it: the last cell passed, and the part of the next that is behind them, count as they are
/// cut.
double mean_height(const CutGround& ground, double front) noexcept
{
  const double last = std::floor(front), behind = ground.heights[in_ring(last)], ahead = ground.heights[in_ring(last + 1.0)];
  const double sum = std::accumulate(ground.heights.begin(), ground.heights.end(), 0.0);
  return (sum + std::max(0.0, ground.pending - behind) + (front - last) * std::max(0.0, ground.height - ahead)) /
         CutGround::cells;
}
}  // namespace

GroundHeight ground_ahead(const CutGround& ground, int blades, double angle) noexcept
{
  const double at = cells_at(blades, std::max(angle, ground.front));
  const double below = std::floor(at);
  const double left = ground.heights[in_ring(below)], right = ground.heights[in_ring(below + 1.0)];
  const double slope = angle > ground.front ? (right - left) * cells_at(blades, 1.0) : 0.0;
  return {left + (at - below) * (right - left), slope};
}

double cut(CutGround& ground, int blades, double angle, double height) noexcept
{
  const double start_angle = ground.angle, start_height = ground.height;
  ground.angle = angle;
  ground.height = height;
  if (angle <= ground.front) return 0.0;
  const double to = cells_at(blades, angle);
  const auto last = static_cast<std::int64_t>(std::floor(to));
  const auto first = static_cast<std::int64_t>(std::floor(cells_at(blades, ground.front))) + 1;
  // more than a sector in one step: what the blades left at first is cut again
  for (std::int64_t cell = std::max(first, last - CutGround::cells + 1); cell <= last; ++cell)
  {
    const auto passed = static_cast<double>(cell);
    double& before = ground.heights[in_ring(passed - 1.0)];
    before = std::max(before, ground.pending);
    const double share = (passed / cells_at(blades, 1.0) - start_angle) / (angle - start_angle);
    ground.pending = start_height + share * (height - start_height);
  }
  ground.front = angle;
  const double mean = std::max(ground.mean, mean_height(ground, to));
  const double lowered = mean - ground.mean;
  ground.mean = mean;
  return lowered;
}

}  // namespace drill_rig_sim
