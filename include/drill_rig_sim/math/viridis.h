// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_VIRIDIS_H
#define DRILL_RIG_SIM_MATH_VIRIDIS_H

#include <algorithm>
#include <array>
#include <cstddef>

namespace drill_rig_sim
{
using Rgb = std::array<float, 3>;  ///< red, green, blue, 0 to 1

/// The colour of a share between 0, the first of `colors`, and 1, the last, which are evenly apart; of the nearer end outside.
template <std::size_t n>
Rgb color_along(const std::array<Rgb, n>& colors, double share) noexcept
{
  const double place = std::clamp(share, 0.0, 1.0) * (n - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), n - 2);
  const float part = static_cast<float>(place - static_cast<double>(i));
  Rgb color = colors[i];
  for (std::size_t k = 0; k < color.size(); ++k) color[k] += part * (colors[i + 1][k] - color[k]);
  return color;
}

/// A scale that the colour-blind can tell apart, dark to light: viridis (S. van der Walt, N. Smith, matplotlib 1.5) without its
/// darkest part, which a dark ground swallows.
constexpr std::array<Rgb, 5> viridis_colors{
    {{0.27f, 0.23f, 0.51f}, {0.17f, 0.44f, 0.56f}, {0.13f, 0.66f, 0.51f}, {0.56f, 0.84f, 0.27f}, {0.99f, 0.91f, 0.14f}}};

/// From violet at 0 to yellow at 1.
inline Rgb viridis(double share) noexcept
{
  return color_along(viridis_colors, share);
}
}  // namespace drill_rig_sim

#endif
