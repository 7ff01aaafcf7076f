// SPDX-License-Identifier: BSD-3-Clause
// When the driller's console warns, and how far its scales reach.
#include <gtest/gtest.h>

#include <cmath>

#include "rviz/console/flags.h"
#include "rviz/console/limits.h"

namespace test_rviz_limits
{
using namespace drill_rig_sim::console;

namespace
{
RigAbilities a_rig()
{
  RigAbilities rig;
  rig.max_hook_load = 2e6;
  rig.min_hook_load = rig.trip_hook_load = 0.0;
  rig.lowest_block_height = 1.0;
  rig.highest_block_height = 41.0;
  rig.max_block_speed = 1.5;
  rig.max_top_drive_speed = 20.0;
  rig.max_top_drive_torque = 50e3;
  rig.max_flow = 0.06;
  rig.relief_pressure = 30e6;
  rig.trip_pressure = 0.0;
  return rig;
}

Level level(Quantity quantity, double value, const RigAbilities& rig = a_rig(), const OwnAlarms& own = OwnAlarms())
{
  return level_of(value, limits_of(quantity, rig, own));
}
}  // namespace

TEST(ConsoleLimits, CautionAtNineTenths)
{
  EXPECT_EQ(Level::normal, level(Quantity::hook_load, 1.79e6));
  EXPECT_EQ(Level::caution, level(Quantity::hook_load, 1.81e6));
  EXPECT_EQ(Level::alarm, level(Quantity::hook_load, 2e6));
}

TEST(ConsoleLimits, TheTripComesBeforeTheMost)
{
  RigAbilities rig = a_rig();
  rig.trip_hook_load = 1e6;
  rig.trip_pressure = 20e6;
  rig.min_hook_load = 50e3;
  EXPECT_EQ(Level::alarm, level(Quantity::hook_load, 1.01e6, rig));
  EXPECT_EQ(Level::alarm, level(Quantity::hook_load, 49e3, rig));
  EXPECT_EQ(Level::caution, level(Quantity::hook_load, 54e3, rig));
  EXPECT_EQ(Level::alarm, level(Quantity::stand_pipe_pressure, 20.1e6, rig));
  EXPECT_EQ(Level::normal, level(Quantity::stand_pipe_pressure, 20.1e6)) << "no trip";
}

TEST(ConsoleLimits, BothWays)
{
  EXPECT_EQ(Level::alarm, level(Quantity::torque, -50e3));
  EXPECT_EQ(Level::caution, level(Quantity::top_drive_speed, -19.0));
}

TEST(ConsoleLimits, TheBlockNearItsStops)
{
  EXPECT_EQ(Level::alarm, level(Quantity::block_height, 1.2));
  EXPECT_EQ(Level::caution, level(Quantity::block_height, 2.5));
  EXPECT_EQ(Level::normal, level(Quantity::block_height, 20.0));
  EXPECT_EQ(Level::caution, level(Quantity::block_height, 39.5));
  EXPECT_EQ(Level::alarm, level(Quantity::block_height, 40.9));
}

TEST(ConsoleLimits, NothingIsKnownNothingIsAlarming)
{
  for (const QuantityRow& row : quantities())
  {
    if (row.quantity == Quantity::stick_slip) continue;
    EXPECT_EQ(Level::normal, level(row.quantity, 1e12, RigAbilities())) << row.key;
    EXPECT_EQ(Level::normal, level(row.quantity, missing)) << row.key;
  }
  EXPECT_EQ(Level::alarm, level(Quantity::stick_slip, 1.0, RigAbilities()));
}

TEST(ConsoleLimits, OwnAlarmsGoFirst)
{
  OwnAlarms own;
  own.above[index_of(Quantity::surface_wob)] = 100e3;
  own.above[index_of(Quantity::torque)] = 10e3;
  EXPECT_EQ(Level::caution, level(Quantity::surface_wob, 95e3, a_rig(), own));
  EXPECT_EQ(Level::alarm, level(Quantity::surface_wob, 101e3, a_rig(), own));
  EXPECT_EQ(Level::alarm, level(Quantity::torque, 10e3, a_rig(), own));
  EXPECT_EQ(Level::alarm, level(Quantity::torque, -50e3, a_rig(), own)) << "the rig's other side stays";
}

TEST(ConsoleScale, HoldsLimitsAndValues)
{
  const Limits none, hook = limits_of(Quantity::hook_load, a_rig(), OwnAlarms());
  EXPECT_NEAR(2.0e6 / 0.9, scale_of(Quantity::hook_load, hook, missing, missing).high, 1.0);
  EXPECT_DOUBLE_EQ(5e4, scale_of(Quantity::surface_wob, none, 0.0, 3.3e4).high);
  EXPECT_DOUBLE_EQ(-1e3, scale_of(Quantity::surface_wob, none, -800.0, 3.3e4).low);
  EXPECT_DOUBLE_EQ(0.0, scale_of(Quantity::torque, limits_of(Quantity::torque, a_rig(), OwnAlarms()), 0.0, 1e3).low);
  EXPECT_LT(scale_of(Quantity::torque, limits_of(Quantity::torque, a_rig(), OwnAlarms()), -1e3, 1e3).low, -50e3);
  EXPECT_DOUBLE_EQ(0.0, scale_of(Quantity::torque, limits_of(Quantity::torque, a_rig(), OwnAlarms()), -1.0, 1e3).low)
      << "noise about 0";
}

TEST(ConsoleScale, RoundedUp)
{
  EXPECT_DOUBLE_EQ(1.0, rounded_up(1.0));
  EXPECT_DOUBLE_EQ(2.0, rounded_up(1.01));
  EXPECT_DOUBLE_EQ(50.0, rounded_up(20.5));
  EXPECT_DOUBLE_EQ(0.1, rounded_up(0.06));
}

TEST(ConsoleFlags, TablesAreInOrder)
{
  for (std::size_t n = 0; n < flag_count; ++n) EXPECT_EQ(n, static_cast<std::size_t>(flag_rows()[n].flag));
  for (std::size_t n = 0; n < failing_gauges().size(); ++n)
    EXPECT_STREQ(drill_rig_sim::gauge_names[n], row_of(failing_gauges()[n]).key);
}
}  // namespace test_rviz_limits
