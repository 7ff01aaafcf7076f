// SPDX-License-Identifier: BSD-3-Clause
#include "limits.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim::console
{
namespace
{
constexpr double share_of_caution = 0.9;

// The lesser of those that are set.
double first_reached(double a, double b)
{
  if (!(a > 0.0)) return b > 0.0 ? b : missing;
  return b > 0.0 ? std::min(a, b) : a;
}

Limits below(double alarm)
{
  return {missing, missing, share_of_caution * alarm, alarm};
}

Limits both_ways(double alarm)
{
  return {-alarm, -share_of_caution * alarm, share_of_caution * alarm, alarm};
}

Limits of_the_block(const RigAbilities& rig)
{
  const double way = rig.highest_block_height - rig.lowest_block_height;
  return {rig.lowest_block_height + 0.01 * way, rig.lowest_block_height + 0.05 * way, rig.highest_block_height - 0.05 * way,
          rig.highest_block_height - 0.01 * way};
}

Limits of_the_rig(Quantity quantity, const RigAbilities& rig)
{
  switch (quantity)
  {
    case Quantity::hook_load:
    case Quantity::dead_line_hook_load:
    {
      Limits limits = below(first_reached(rig.max_hook_load, rig.trip_hook_load));
      if (rig.min_hook_load > 0.0) limits.low_alarm = rig.min_hook_load;
      if (rig.min_hook_load > 0.0) limits.low_caution = rig.min_hook_load / share_of_caution;
      return limits;
    }
    case Quantity::torque:
      return both_ways(rig.max_top_drive_torque);
    case Quantity::top_drive_speed:
      return both_ways(rig.max_top_drive_speed);
    case Quantity::stand_pipe_pressure:
      return below(first_reached(rig.relief_pressure, rig.trip_pressure));
    case Quantity::flow:
      return below(rig.max_flow);
    case Quantity::block_height:
      return of_the_block(rig);
    case Quantity::block_velocity:
      return both_ways(rig.max_block_speed);
    case Quantity::stick_slip:
      return {missing, missing, 0.5, 1.0};
    default:
      return {};
  }
}
}  // namespace

Limits limits_of(Quantity quantity, const RigAbilities& rig, const OwnAlarms& own)
{
  Limits limits = of_the_rig(quantity, rig);
  const double above = own.above[index_of(quantity)];
  if (std::isfinite(above))
  {
    limits.high_alarm = above;
    limits.high_caution = above - (1.0 - share_of_caution) * std::abs(above);
  }
  return limits;
}

Level level_of(double value, const Limits& limits)
{
  if (value >= limits.high_alarm || value <= limits.low_alarm) return Level::alarm;
  if (value >= limits.high_caution || value <= limits.low_caution) return Level::caution;
  return Level::normal;
}

double rounded_up(double value)
{
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= value * (1.0 - 1e-9)) return step * power;
  return 10.0 * power;
}

Scale scale_of(Quantity quantity, const Limits& limits, double least, double most)
{
  Scale scale{0.0, row_of(quantity).usual};
  if (std::isfinite(limits.high_alarm) && limits.high_alarm > 0.0)
    scale.high = limits.high_alarm / share_of_caution;
  else if (most > scale.high)
    scale.high = rounded_up(most);
  if (quantity == Quantity::toolface) scale.low = -scale.high;
  if (least < -0.01 * scale.high && scale.low == 0.0)  // NaN is not, nor is the noise of a gauge about 0
  {
    const bool limited = std::isfinite(limits.low_alarm) && limits.low_alarm < 0.0;
    scale.low = limited ? limits.low_alarm / share_of_caution : std::max(-scale.high, -rounded_up(-least));
  }
  if (quantity == Quantity::block_height && std::isfinite(limits.high_alarm)) scale.high = limits.high_alarm * 1.02;
  return scale;
}

}  // namespace drill_rig_sim::console
