// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_COLOR_SCALE_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_COLOR_SCALE_H

#include <string>
#include <vector>

namespace drill_rig_sim
{
/// Red, green, blue and opacity, each 0 to 1.
struct Color
{
  float r = 1.0f, g = 1.0f, b = 1.0f, a = 1.0f;
};

/// From a value to a colour and back to the reader. From violet at 0 to yellow (viridis); with both signs white at 0, orange
/// above, blue below; values beyond the ends have the colour of the end.
class ColorScale
{
public:
  /// `low` <= 0 < `high`; one that is not gets the nearest that is: a scale always has a colour.
  ColorScale(double low, double high);

  double low() const noexcept { return low_; }
  double high() const noexcept { return high_; }
  /// Grey where the value is not finite.
  Color at(double value) const noexcept;
  /// Round values from end to end, 1, 2 or 5 times a power of ten apart, at least two and at most `most` (>= 2).
  std::vector<double> ticks(int most) const;

private:
  double low_, high_;
};

/// The least of 1, 2, 2.5, 5 times a power of ten that is not below `value`; 1 where that is not above 0.
double round_up(double value) noexcept;

/// Chooses the ends of a scale for values that change with every message, so that colours do not flicker: an end moves at once
/// where values go beyond it, and back once they have not reached half of it for fifty messages.
class SteadyRange
{
public:
  /// Takes the values of a message. `share` of their sizes (0 to 1) is to lie within the scale: the rest is cut off, as one large
  /// value at the bit would hide all others.
  void take(const std::vector<double>& values, double share);
  ColorScale scale() const { return {low_, high_}; }
  void restart() { *this = SteadyRange(); }

private:
  double low_ = 0.0, high_ = 0.0;
  int small_for_ = 0;
};

/// A number as a legend writes it: as many digits as `step` needs.
std::string written(double value, double step);

}  // namespace drill_rig_sim

#endif
