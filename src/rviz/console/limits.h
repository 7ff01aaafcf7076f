// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_LIMITS_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_LIMITS_H

#include <array>

#include "quantities.h"

namespace drill_rig_sim::console
{
enum class Level
{
  normal,
  caution,
  alarm
};

/// What the rig can do, as rig_limits reports it [SI]; NaN before it has, 0 where a limit may be off.
struct RigAbilities
{
  double max_block_speed = missing, max_hook_load = missing, min_hook_load = missing, trip_hook_load = missing;
  double lowest_block_height = missing, highest_block_height = missing;
  double max_top_drive_speed = missing, max_top_drive_torque = missing;
  double max_flow = missing, relief_pressure = missing, trip_pressure = missing;
};

/// The user's own alarms, upper ones [SI]; NaN: the rig's.
struct OwnAlarms
{
  OwnAlarms() { above.fill(missing); }
  std::array<double, quantity_count> above;
};

/// Where a value begins to be remarkable [SI]; NaN: never.
struct Limits
{
  double low_alarm = missing, low_caution = missing, high_caution = missing, high_alarm = missing;
};

/// Limits of a quantity: the user's own, else the rig's; caution at 90 % of the alarm. Torque and speed count both ways; the
/// block's height is alarming within 1 % of its way from either end, and remarkable within 5 %. A stick-slip index of 1 is a bit
/// that stands, 0.5 on the way there.
Limits limits_of(Quantity quantity, const RigAbilities& rig, const OwnAlarms& own);
/// How remarkable a value is; NaN is normal.
Level level_of(double value, const Limits& limits);

/// A scale from `low` to `high` [SI].
struct Scale
{
  double low = 0.0, high = 1.0;
};
/// The scale that shows limits and the values between `least` and `most` seen (NaN: none yet): from 0, or as far below as values
/// or limits go.
Scale scale_of(Quantity quantity, const Limits& limits, double least, double most);
/// The next of 1, 2, 5, 10, ... that is not below a positive value.
double rounded_up(double value);

}  // namespace drill_rig_sim::console

#endif
