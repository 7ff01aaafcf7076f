// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/pump_strokes.h"

#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double crank_over_rod = 1.0 / 6.0;

/// Share of its volume that a piston has delivered at a crank angle from the beginning of its stroke, in turns, 0 to 1.
double piston_share(double turn) noexcept
{
  if (turn >= 0.5) return 1.0;
  const double angle = 2.0 * pi * turn, sine = crank_over_rod * std::sin(angle);
  return 0.5 * (1.0 - std::cos(angle) + (1.0 - std::sqrt(1.0 - sine * sine)) / crank_over_rod);
}
}  // namespace

double delivered_strokes(double strokes, int cylinders) noexcept
{
  if (cylinders <= 0) return strokes;
  double sum = 0.0;
  for (int i = 0; i < cylinders; ++i)
  {
    const double turns = strokes + static_cast<double>(i) / cylinders, whole = std::floor(turns);
    sum += whole + piston_share(turns - whole);
  }
  return sum / cylinders;
}

}  // namespace drill_rig_sim
