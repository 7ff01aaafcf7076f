// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/cuttings.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double per_foot = 0.3048;            // [m]
constexpr double per_ppg = 119.8264;           // [kg/m3]
constexpr double most_rotation = 600.0;        // of (3) [rpm]
constexpr double share_at_rest = 0.00505;      // c_e at u = 0
constexpr double per_speed = 0.64 / per_foot;  // of (5) [s/m]
constexpr double penetration_term = 18.16;     // of (4) [s/h]
constexpr double slowest = 0.05;               // speed that shears the mud in which cuttings settle while it rests [m/s]
constexpr double most_covered = 0.9;           // of the annulus by a bed
constexpr int rounds = 60;                     // of bisection

/// Of a circle, up to a chord at that height above its lowest point [m2].
double segment(double diameter, double height) noexcept
{
  const double h = std::clamp(height / diameter, 0.0, 1.0), half = std::acos(1.0 - 2.0 * h);
  return 0.25 * diameter * diameter * (half - std::sin(half) * std::cos(half));
}

double hole_area(const Passage& passage) noexcept
{
  return 0.25 * pi * passage.outer * passage.outer;
}

double slip_in(const CuttingsFluid& fluid, const Passage& passage, double speed) noexcept
{
  return slip_speed(fluid, apparent_viscosity(fluid.curve, passage, std::max(speed, slowest)));
}

/// (6) over a step: what settles, < 0 what is taken up [m3].
double settled(const CuttingsFluid& fluid, const CuttingsCell& cell, double step_rate, double carried, double open,
               const CuttingsContent& content) noexcept
{
  const double volume = open * cell.length, excess = content.suspended - carried * volume;
  const double moved = excess * step_rate / (1.0 + step_rate);
  if (moved < 0.0) return std::max(moved, -content.bed);
  if (cell.inclination < bed_inclination) return 0.0;
  const double room = most_covered * cell.passage.area() * cell.length * (1.0 - fluid.cuttings.porosity) - content.bed;
  return std::min(moved, std::max(0.0, room));
}
}  // namespace

double apparent_viscosity(const Rheology& mud, const Passage& annulus, double speed) noexcept
{
  return laminar_wall_stress(mud, annulus, speed) * annulus.gap() / (12.0 * speed);
}

double slip_speed(const CuttingsFluid& fluid, double viscosity) noexcept
{
  const double d = fluid.cuttings.size, rho = fluid.density, weight = standard_gravity * (fluid.cuttings.density - rho);
  const double slow = weight * d * d / (30.0 * viscosity);
  const double middle = std::pow(weight * 4.0 / 66.0, 2.0 / 3.0) * d / std::cbrt(rho * viscosity);
  const double fast = std::sqrt(8.0 / 9.0 * weight * d / rho);
  return std::min({slow, middle, fast});
}

double slip_factor(double inclination, double rotation, double mud_density) noexcept
{
  const double degrees = std::min(inclination / degree, 45.0);
  const double slower = std::max(0.0, most_rotation - std::abs(rotation) / rpm);
  return 1.0 + degrees * slower * (3.0 + mud_density / per_ppg) / 202500.0;
}

double carried_share(double speed, double open) noexcept
{
  if (speed <= 0.0) return 0.0;
  const double left = 1.0 - per_speed * speed * open;
  return left > share_at_rest / most_carried ? share_at_rest / left : most_carried;
}

double critical_cuttings_speed(const CuttingsFluid& fluid, const CuttingsCell& cell, double rop, double rotation) noexcept
{
  const double feet_an_hour = rop / per_foot * 3600.0, factor = slip_factor(cell.inclination, rotation, fluid.density);
  const double carries = per_foot * hole_area(cell.passage) / cell.passage.area() / (0.64 + penetration_term / feet_an_hour);
  // v_s falls as the mud moves slower: the needed speed less the speed falls with it
  double low = carries, high = carries + factor * slip_speed(fluid, 1e-6);
  for (int k = 0; k < rounds; ++k)
  {
    const double middle = 0.5 * (low + high);
    (carries + factor * slip_in(fluid, cell.passage, middle) > middle ? low : high) = middle;
  }
  return high;
}

double open_area(const CuttingsFluid& fluid, const CuttingsCell& cell, double bed) noexcept
{
  const double area = cell.passage.area();
  if (bed <= 0.0) return area;
  return std::max(area - bed / (cell.length * (1.0 - fluid.cuttings.porosity)), (1.0 - most_covered) * area);
}

double advance_cell(const CuttingsFluid& fluid, const CuttingsCell& cell, const CuttingsFlow& flow, double inflow,
                    CuttingsContent& content) noexcept
{
  content.suspended += inflow;
  if (cell.length <= 0.0)
  {
    const double all = content.suspended;
    content.suspended = 0.0;
    return all;
  }
  if (content.suspended <= 0.0 && content.bed <= 0.0) return 0.0;
  const double open = open_area(fluid, cell, content.bed), speed = flow.flow / open;
  const double slip = slip_in(fluid, cell.passage, speed);
  const double along = std::max(0.0, speed - slip_factor(cell.inclination, flow.rotation, fluid.density) * slip);
  const double moved = flow.time * along / cell.length;
  double out = content.suspended * moved / (1.0 + moved);
  content.suspended -= out;

  const double rate = flow.time * slip * std::sin(cell.inclination) * cell.passage.outer / open;
  const double bedded = settled(fluid, cell, rate, carried_share(along, open / hole_area(cell.passage)), open, content);
  content.suspended -= bedded;
  content.bed += bedded;

  const double most = (1.0 - fluid.cuttings.porosity) * open_area(fluid, cell, content.bed) * cell.length;
  const double pushed = std::max(0.0, content.suspended - most);
  content.suspended -= pushed;
  return out + pushed;
}

double bed_section(const Passage& passage, double height) noexcept
{
  return segment(passage.outer, height) - (passage.inner > 0.0 ? segment(passage.inner, height) : 0.0);
}

double bed_height(const Passage& passage, double section) noexcept
{
  if (section <= 0.0) return 0.0;
  double low = 0.0, high = passage.outer;
  for (int k = 0; k < rounds && high - low > 1e-6 * passage.outer; ++k)
  {
    const double middle = 0.5 * (low + high);
    (bed_section(passage, middle) < section ? low : high) = middle;
  }
  return high;
}

double bed_drag(const CuttingsFluid& fluid, double diameter, double height) noexcept
{
  if (height <= 0.0) return 0.0;
  const double covered = height < diameter ? std::acos(1.0 - 2.0 * height / diameter) : pi;
  const double weight =
      standard_gravity * (fluid.cuttings.density - fluid.density) * (1.0 - fluid.cuttings.porosity);  // per volume of bed
  const double radius = 0.5 * diameter;
  return fluid.cuttings.friction * weight * diameter * ((height - radius) * covered + radius * std::sin(covered));
}

}  // namespace drill_rig_sim
