// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/flow_losses.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
bool is_bore(const Passage& passage) noexcept
{
  return passage.inner <= 0.0;
}

/// (a^p + b^p)^(1/p) of positive numbers: near the larger one for p > 0, near the smaller one for p < 0.
double joined(double a, double b, double p) noexcept
{
  const double low = std::min(a, b), high = std::max(a, b), main = p > 0.0 ? high : low, other = p > 0.0 ? low : high;
  return main * std::pow(1.0 + std::pow(other / main, p), 1.0 / p);
}

/// n' = d ln tau_w/d ln V of laminar flow at a stress above the yield stress, from (2) and (3).
double local_index(const Rheology& mud, const Passage& passage, double stress) noexcept
{
  const double y = mud.yield_stress, a = stress - y, m = 1.0 / mud.index;
  if (y <= 0.0) return mud.index;
  const bool bore = is_bore(passage);
  const double profile = bore ? a * a / (3.0 + m) + 2.0 * y * a / (2.0 + m) + y * y / (1.0 + m) : a / (2.0 + m) + y / (1.0 + m);
  const double by_stress = bore ? 2.0 * a / (3.0 + m) + 2.0 * y / (2.0 + m) : 1.0 / (2.0 + m);
  return std::max(least_flow_index, 1.0 / ((1.0 + m) * stress / a + stress * by_stress / profile - (bore ? 3.0 : 2.0)));
}

/// tau_w of (5) from an index and the stress of a power law's laminar flow at the same speed.
double turbulent_stress(double dynamic, double laminar, double index) noexcept
{
  const double a = (std::log10(index) + 3.93) / 50.0, b = (1.75 - std::log10(index)) / 7.0;
  return 0.5 * dynamic * a * std::pow(8.0 * dynamic / laminar, -b);
}

/// tau_w of (5).
double turbulent_wall_stress(const Rheology& mud, double density, const Passage& passage, double speed, double laminar) noexcept
{
  const double dynamic = density * speed * speed;
  const double thin = laminar_wall_stress({0.0, mud.consistency, mud.index}, passage, speed),
               without = turbulent_stress(dynamic, thin, mud.index);
  if (mud.yield_stress <= 0.0) return without;
  const double at = std::max(without, laminar), index = local_index(mud, passage, at);
  return turbulent_stress(dynamic, at * std::pow(speed / laminar_speed(mud, passage, at), index), index);
}
}  // namespace

double Passage::area() const noexcept
{
  return 0.25 * pi * (outer - inner) * (outer + inner);
}

double laminar_speed(const Rheology& mud, const Passage& passage, double wall_stress) noexcept
{
  const double y = mud.yield_stress, a = wall_stress - y, m = 1.0 / mud.index, w = wall_stress;
  if (a <= 0.0) return 0.0;
  const double at_wall = std::pow(a / mud.consistency, m);  // shear rate
  if (is_bore(passage))
    return 0.5 * passage.gap() * at_wall * a / (w * w * w) * (a * a / (3.0 + m) + 2.0 * y * a / (2.0 + m) + y * y / (1.0 + m));
  return 0.25 * passage.gap() * at_wall * a / (w * w) * (a / (2.0 + m) + y / (1.0 + m));
}

double laminar_wall_stress(const Rheology& mud, const Passage& passage, double speed) noexcept
{
  const double m = 1.0 / mud.index;
  const double rate =
      (is_bore(passage) ? 2.0 * (3.0 + m) : 4.0 * (2.0 + m)) * speed / passage.gap();  // at the wall without a yield stress
  const double without = mud.consistency * (mud.index == 1.0 ? rate : std::pow(rate, mud.index));
  if (mud.yield_stress <= 0.0) return without;
  double low = mud.yield_stress, high = 1.5 * mud.yield_stress + without;
  while (laminar_speed(mud, passage, high) < speed) high *= 2.0;
  while (high - low > 1e-14 * high)
  {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (laminar_speed(mud, passage, middle) < speed ? low : high) = middle;
  }
  return high;
}

double reynolds_number(const Rheology& mud, double density, const Passage& passage, double speed) noexcept
{
  return 8.0 * density * speed * speed / laminar_wall_stress(mud, passage, speed);
}

double critical_reynolds_number(const Rheology& mud) noexcept
{
  return 3470.0 - 1370.0 * mud.index;
}

double critical_speed(const Rheology& mud, double density, const Passage& passage) noexcept
{
  if (density <= 0.0) return HUGE_VAL;
  const double critical = critical_reynolds_number(mud);
  double low = 0.0, high = 1.0;
  while (reynolds_number(mud, density, passage, high) < critical) high *= 2.0;
  while (high - low > 1e-9 * high)
  {
    const double middle = 0.5 * (low + high);
    (reynolds_number(mud, density, passage, middle) < critical ? low : high) = middle;
  }
  return high;
}

double wall_stress(const Rheology& mud, double density, const Passage& passage, double speed) noexcept
{
  const EccentricShare share = is_bore(passage) ? EccentricShare() : eccentric_share(mud, passage);
  if (speed <= 0.0) return share.laminar * mud.yield_stress;
  const double laminar = laminar_wall_stress(mud, passage, speed);
  if (density <= 0.0) return share.laminar * laminar;
  const double critical = critical_reynolds_number(mud), dynamic = density * speed * speed;
  const double transitional = share.laminar * 64.0 * dynamic * (dynamic / laminar) / (critical * critical);  // f = 16 Re/Re_c^2
  const double turbulent = share.turbulent * turbulent_wall_stress(mud, density, passage, speed, laminar);
  return joined(joined(transitional, turbulent, -8.0), share.laminar * laminar, 12.0);
}

double pressure_gradient(const Rheology& mud, double density, const Passage& passage, double speed) noexcept
{
  return 4.0 * wall_stress(mud, density, passage, speed) / passage.gap();
}

EccentricShare eccentric_share(const Rheology& mud, const Passage& annulus) noexcept
{
  const double e = std::min(annulus.eccentricity, 0.95), r = std::clamp(annulus.inner / annulus.outer, 0.3, 0.9),
               n = std::clamp(mud.index, 0.4, 1.0);
  if (e <= 0.0) return {};
  const double first = e / n * std::pow(r, 0.8454), second = e * e * std::sqrt(n) * std::pow(r, 0.1852),
               third = e * e * e * std::sqrt(n) * std::pow(r, 0.2527);
  return {1.0 - 0.072 * first - 1.5 * second + 0.96 * third, 1.0 - 0.048 * first - 2.0 / 3.0 * second + 0.285 * third};
}

double rotation_factor(double at_120_rpm, double speed) noexcept
{
  constexpr double fitted_at = 120.0 * rpm, fastest = 240.0 * rpm;
  return 1.0 + (at_120_rpm - 1.0) * std::min(std::abs(speed), fastest) / fitted_at;
}

double nozzle_loss(double density, double flow, double area) noexcept
{
  constexpr double discharge = 0.95;
  const double speed = flow / (discharge * area);
  return 0.5 * density * speed * speed;
}

double clinging(double ratio, double turbulence) noexcept
{
  const double laminar = 0.25 + 0.275 * ratio;
  return laminar + turbulence * (clinging_constant(ratio) - laminar);
}

double clinging_constant(double ratio) noexcept
{
  return 0.41 + 0.1 * ratio;
}

double turbulence_at(double speed, double critical_speed) noexcept
{
  return std::clamp(std::abs(speed) / critical_speed - 1.0, 0.0, 1.0);
}

}  // namespace drill_rig_sim
