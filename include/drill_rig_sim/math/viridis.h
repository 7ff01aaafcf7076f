// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_VIRIDIS_H
#define DRILL_RIG_SIM_MATH_VIRIDIS_H

#include <algorithm>
#include <array>
#include <cstddef>

/// A scale of colours that the colour-blind can tell apart, dark to light: viridis (S. van der Walt, N. Smith, matplotlib 1.5)
/// without its darkest part, which a dark ground swallows.
namespace drill_rig_sim
{
using Rgb = std::array<float, 3>;  ///< red, green, blue, 0 to 1

constexpr std::array<Rgb, 5> viridis_colors{
    {{0.27f, 0.23f, 0.51f}, {0.17f, 0.44f, 0.56f}, {0.13f, 0.66f, 0.51f}, {0.56f, 0.84f, 0.27f}, {0.99f, 0.91f, 0.14f}}};

/// The colour of a share between 0, violet, and 1, yellow; of the nearer end outside.
inline Rgb viridis(double share) noexcept
{
  const double place = std::clamp(share, 0.0, 1.0) * (viridis_colors.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), viridis_colors.size() - 2);
  const float part = static_cast<float>(place - static_cast<double>(i));
  Rgb color = viridis_colors[i];
  for (std::size_t k = 0; k < color.size(); ++k) color[k] += part * (viridis_colors[i + 1][k] - color[k]);
  return color;
}
}  // namespace drill_rig_sim

#endif
