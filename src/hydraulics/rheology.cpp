// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/rheology.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace drill_rig_sim
{
namespace
{
constexpr double rate_300 = 300.0 * shear_rate_per_rpm;  // [1/s]

/// Yield stress and consistency at an index that leave the least squares of the stress, and these.
struct Candidate
{
  Rheology curve;
  double squares = 0.0;
};

Candidate best_at(double index, bool yields, const std::vector<ViscometerReading>& readings)
{
  double n = 0.0, x = 0.0, xx = 0.0, y = 0.0, xy = 0.0;
  for (const ViscometerReading& reading : readings)
  {
    const double rate = std::pow(shear_rate_per_rpm * reading.speed, index), stress = stress_per_dial_degree * reading.dial;
    n += 1.0;
    x += rate;
    xx += rate * rate;
    y += stress;
    xy += rate * stress;
  }
  const double determinant = n * xx - x * x;
  double yield = yields && determinant > 0.0 ? (xx * y - x * xy) / determinant : 0.0;
  // a yield stress below 0 is none: the best fit without one
  yield = std::max(yield, 0.0);
  Candidate out{{yield, (xy - yield * x) / xx, index}, 0.0};
  for (const ViscometerReading& reading : readings)
    out.squares +=
        std::pow(shear_stress(out.curve, shear_rate_per_rpm * reading.speed) - stress_per_dial_degree * reading.dial, 2);
  return out;
}

/// The index in between whose best fit is best, by golden sections.
Rheology best_index(bool yields, const std::vector<ViscometerReading>& readings)
{
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = least_flow_index, high = most_flow_index;
  while (high - low > 1e-9)
  {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    if (best_at(left, yields, readings).squares < best_at(right, yields, readings).squares)
      high = right;
    else
      low = left;
  }
  return best_at(0.5 * (low + high), yields, readings).curve;
}

double dial_at(double speed, const std::vector<ViscometerReading>& readings)
{
  for (const ViscometerReading& reading : readings)
    if (reading.speed == speed) return reading.dial;
  return 0.0;
}

bool are_of_api(const std::vector<ViscometerReading>& readings)
{
  const double speeds[] = {600.0, 300.0, 6.0, 3.0};
  return readings.size() == 4 &&
         std::all_of(std::begin(speeds), std::end(speeds), [&](double speed) { return dial_at(speed, readings) > 0.0; });
}

/// The measurement method of API RP 13D.
Rheology of_api(const std::vector<ViscometerReading>& readings)
{
  const double r600 = dial_at(600.0, readings), r300 = dial_at(300.0, readings),
               yield = std::max(0.0, 2.0 * dial_at(3.0, readings) - dial_at(6.0, readings));
  const double index = std::log2((r600 - yield) / (r300 - yield));
  return {stress_per_dial_degree * yield, stress_per_dial_degree * (r300 - yield) / std::pow(rate_300, index), index};
}

std::size_t parameters_of(RheologyLaw law)
{
  switch (law)
  {
    case RheologyLaw::newtonian:
      return 1;
    case RheologyLaw::bingham:
    case RheologyLaw::power_law:
      return 2;
    case RheologyLaw::herschel_bulkley:
      return 3;
  }
  return 0;
}

std::string text_of(const char* form, double first, double second)
{
  char text[160];
  std::snprintf(text, sizeof text, form, first, second);
  return text;
}

/// Of two neighbours by growing speed.
std::string pair_problem(RheologyLaw law, const ViscometerReading& slow, const ViscometerReading& fast)
{
  if (fast.speed == slow.speed) return text_of("%g rpm is given twice, allowed: once", fast.speed, 0.0);
  if (fast.dial < slow.dial || (fast.dial == slow.dial && law != RheologyLaw::herschel_bulkley))
    return text_of("the dial reading does not increase from %g to %g rpm, needed: a larger reading at a larger speed", slow.speed,
                   fast.speed);
  return "";
}
}  // namespace

double shear_stress(const Rheology& mud, double rate) noexcept
{
  return mud.yield_stress + mud.consistency * (mud.index == 1.0 ? rate : std::pow(rate, mud.index));
}

double plastic_viscosity(const Rheology& mud) noexcept
{
  return (shear_stress(mud, 2.0 * rate_300) - shear_stress(mud, rate_300)) / rate_300;
}

Rheology fitted(RheologyLaw law, const std::vector<ViscometerReading>& readings)
{
  if (law == RheologyLaw::herschel_bulkley && are_of_api(readings)) return of_api(readings);
  if (law == RheologyLaw::newtonian || law == RheologyLaw::bingham)
    return best_at(1.0, law == RheologyLaw::bingham, readings).curve;
  return best_index(law == RheologyLaw::herschel_bulkley, readings);
}

std::string readings_problem(RheologyLaw law, const std::vector<ViscometerReading>& readings)
{
  const std::size_t needed = parameters_of(law);
  if (readings.size() < needed)
    return std::to_string(readings.size()) + " readings are too few for this law, needed: " + std::to_string(needed);
  std::vector<ViscometerReading> sorted = readings;
  std::sort(sorted.begin(), sorted.end(),
            [](const ViscometerReading& a, const ViscometerReading& b) { return a.speed < b.speed; });
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    std::string problem = pair_problem(law, sorted[i - 1], sorted[i]);
    if (!problem.empty()) return problem;
  }
  const Rheology curve = fitted(law, readings);
  if (!(curve.consistency > 0.0 && curve.index >= least_flow_index && curve.index <= most_flow_index))
    return text_of("they give a flow index n of %.3g, allowed: %g to 1 (shear thinning)", curve.index, least_flow_index);
  if (needed != 2) return "";
  // least squares end at the limits of the law where readings grow faster than they allow
  const ViscometerReading &slow = sorted[sorted.size() - 2], &fast = sorted.back();
  if (fast.dial / slow.dial > (1.0 + 1e-6) * fast.speed / slow.speed)
    return text_of("the dial reading grows faster than the speed from %g to %g rpm, needed: shear thinning", slow.speed,
                   fast.speed);
  return "";
}

Rheology curve_of(const RheologySpec& spec, double viscosity)
{
  if (!spec.readings.empty()) return fitted(spec.law, spec.readings);
  switch (spec.law)
  {
    case RheologyLaw::newtonian:
      return {0.0, viscosity, 1.0};
    case RheologyLaw::bingham:
      return {spec.yield_point, spec.plastic_viscosity, 1.0};
    case RheologyLaw::power_law:
      return {0.0, spec.consistency, spec.index};
    case RheologyLaw::herschel_bulkley:
      return {spec.yield_stress, spec.consistency, spec.index};
  }
  return {};
}

}  // namespace drill_rig_sim
