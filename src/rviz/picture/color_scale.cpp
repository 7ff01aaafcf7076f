// SPDX-License-Identifier: BSD-3-Clause
#include "color_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "drill_rig_sim/math/viridis.h"

namespace drill_rig_sim
{
namespace
{
constexpr int patience = 50;  // messages until a scale that is too wide gets narrower

// where there are both signs: blue, white, orange, which the colour-blind can tell apart too
constexpr std::array<Rgb, 3> orange{{{0.97f, 0.97f, 0.97f}, {0.99f, 0.72f, 0.39f}, {0.90f, 0.38f, 0.01f}}};
constexpr std::array<Rgb, 3> blue{{{0.97f, 0.97f, 0.97f}, {0.45f, 0.68f, 0.85f}, {0.02f, 0.32f, 0.69f}}};

Color opaque(const Rgb& color)
{
  return {color[0], color[1], color[2]};
}

/// The size below which `share` of the sizes lie. `sizes`: may be empty.
double quantile(std::vector<double> sizes, double share)
{
  if (sizes.empty()) return 0.0;
  const auto place = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(place), sizes.end());
  return sizes[place];
}
}  // namespace

ColorScale::ColorScale(double low, double high)
    : low_(std::isfinite(low) ? std::min(low, 0.0) : 0.0), high_(std::isfinite(high) && high > 0.0 ? high : 1.0)
{
}

Color ColorScale::at(double value) const noexcept
{
  if (!std::isfinite(value)) return {0.5f, 0.5f, 0.5f};
  if (!(low_ < 0.0)) return opaque(viridis(value / high_));
  return opaque(value >= 0.0 ? color_along(orange, value / high_) : color_along(blue, value / low_));
}

std::vector<double> ColorScale::ticks(int most) const
{
  double step = round_up((high_ - low_) / std::max(most - 1, 1));
  while (std::floor(high_ / step) - std::ceil(low_ / step) < 1.0) step *= 0.5;
  std::vector<double> result;
  for (double k = std::ceil(low_ / step - 1e-9); k * step <= high_ * (1.0 + 1e-9); k += 1.0) result.push_back(k * step);
  return result;
}

double round_up(double value) noexcept
{
  if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0})
    if (value <= factor * power * (1.0 + 1e-9)) return factor * power;
  return 10.0 * power;
}

void SteadyRange::take(const std::vector<double>& values, double share)
{
  std::vector<double> above, below;
  for (const double value : values)
    if (std::isfinite(value)) (value < 0.0 ? below : above).push_back(std::abs(value));
  const double high = quantile(above, share), low = quantile(below, share);
  const bool wide = (high_ > 0.0 && high < 0.5 * high_) || (low_ < 0.0 && low < -0.5 * low_);
  small_for_ = wide ? small_for_ + 1 : 0;
  if (small_for_ > patience)
  {
    high_ = low_ = 0.0;
    small_for_ = 0;
  }
  if (high > high_) high_ = round_up(high);
  if (low > -low_) low_ = -round_up(low);
}

std::string written(double value, double step)
{
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(std::max(step, 1e-12)) - 1e-9)), 0, 9);
  const double unit = std::pow(10.0, -digits);
  const bool whole = std::abs(step / unit - std::round(step / unit)) < 1e-6;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", whole ? digits : digits + 1, value == 0.0 ? 0.0 : value);
  return text;
}

}  // namespace drill_rig_sim
