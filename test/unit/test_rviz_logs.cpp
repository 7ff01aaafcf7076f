// SPDX-License-Identifier: BSD-3-Clause
// What the driller's console remembers of alarms and connections.
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

#include "rviz/console/alarm_log.h"
#include "rviz/console/connection_log.h"

namespace test_rviz_logs
{
using namespace drill_rig_sim::console;

namespace
{
Flags flags(std::initializer_list<Flag> up)
{
  Flags result;
  for (const Flag flag : up) result.set(static_cast<std::size_t>(flag));
  return result;
}
}  // namespace

TEST(AlarmLog, aShortAlarmStaysUntilItIsAcknowledged)
{
  AlarmLog log;
  EXPECT_TRUE(log.take(1.0, {}).empty());
  const auto begun = log.take(1.01, flags({Flag::over_stress}));
  ASSERT_EQ(1u, begun.size());
  EXPECT_TRUE(begun[0].lasts);
  EXPECT_TRUE(log.take(1.02, {}).empty());
  EXPECT_TRUE(log.take(11.0, {}).empty());
  const auto ended = log.take(11.5, {});
  ASSERT_EQ(1u, ended.size());
  EXPECT_TRUE(ended[0].ended);
  EXPECT_DOUBLE_EQ(1.01, ended[0].from);
  EXPECT_DOUBLE_EQ(1.01, ended[0].to);
  log.take(1000.0, {});
  ASSERT_EQ(1u, log.latched().size());
  EXPECT_EQ(Flag::over_stress, log.latched()[0].flag);
  log.acknowledge();
  EXPECT_TRUE(log.latched().empty());
}

TEST(AlarmLog, oneThatFlickersIsOne)
{
  AlarmLog log;
  std::size_t lines = 0;
  for (int n = 0; n < 600; ++n)
    lines += log.take(0.1 * n, n % 2 != 0 ? flags({Flag::top_drive_limited, Flag::motor_stalled}) : Flags()).size();
  EXPECT_EQ(2u, lines);
  ASSERT_EQ(1u, log.latched().size()) << "a caution is not latched";
  EXPECT_NEAR(0.1, log.latched()[0].from, 1e-9);
  EXPECT_NEAR(59.9, log.latched()[0].to, 1e-9);
}

TEST(AlarmLog, acknowledgedWhileItLasts)
{
  AlarmLog log;
  log.take(1.0, flags({Flag::slack_line}));
  log.acknowledge();
  EXPECT_TRUE(log.latched().empty());
  log.take(2.0, flags({Flag::slack_line}));
  EXPECT_TRUE(log.latched().empty()) << "it is the same one";
  EXPECT_EQ(1u, log.take(20.0, {}).size()) << "its end is logged";
  EXPECT_EQ(1u, log.take(21.0, flags({Flag::slack_line})).size());
  EXPECT_EQ(1u, log.latched().size()) << "and this is another";
}

TEST(AlarmLog, anotherWellForgets)
{
  AlarmLog log;
  log.take(100.0, flags({Flag::buckled}));
  log.take(0.0, {});
  EXPECT_TRUE(log.latched().empty());
}

// Drills to 100 s, raises the string, 98 s in slips from 120 s, weight again at 255 s.
TEST(ConnectionLog, inSlipsAndWeightToWeight)
{
  ConnectionLog log;
  std::vector<Connection> made;
  for (int n = 0; n <= 3000; ++n)
  {
    const double t = 0.1 * n;
    const bool slips = n >= 1200 && n < 2180;
    const auto connection = log.take({t, slips, n < 1700 ? 20 : 21, n <= 1000 || n >= 2550});
    if (connection) made.push_back(*connection);
  }
  ASSERT_EQ(2u, made.size()) << "when the slips are pulled, and when the bit drills";
  EXPECT_EQ(1, made[1].number);
  EXPECT_NEAR(98.0, made[0].in_slips, 1e-6);
  EXPECT_TRUE(std::isnan(made[0].weight_to_weight));
  EXPECT_NEAR(98.0, made[1].in_slips, 1e-6);
  EXPECT_NEAR(155.0, made[1].weight_to_weight, 1e-6);
}

TEST(ConnectionLog, pipeThatIsTakenAwayIsNoConnection)
{
  ConnectionLog log;
  for (int n = 0; n <= 100; ++n) EXPECT_FALSE(log.take({1.0 * n, n % 20 < 10, 50 - n / 20, false}));
}

TEST(ConnectionLog, aGapHidesTheConnectionInIt)
{
  ConnectionLog log;
  EXPECT_FALSE(log.take({0.0, false, 3, true}));
  EXPECT_FALSE(log.take({1.0, true, 3, false}));
  EXPECT_FALSE(log.take({60.0, true, 4, false})) << "the page was hidden";
  EXPECT_FALSE(log.take({61.0, false, 4, false})) << "how long it was in slips is not known";
}

}  // namespace test_rviz_logs
