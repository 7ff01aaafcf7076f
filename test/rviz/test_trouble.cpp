// SPDX-License-Identifier: BSD-3-Clause
// Trouble: a stuck pipe that is pulled, with its margin to yield and the fault by its depth; a motor that stalls.
#include <ros/package.h>

#include <QListWidget>

#include "console_test.h"

using namespace console_test;

TEST(Pull, IsNotShownAsAWeight)
{
  end_shared_rig();
  const RigProcess rig("pulled");
  Console console("pulled");
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  ASSERT_TRUE(console.is_heard());
  ASSERT_TRUE(console.asks("pipe tare", "tare: "));
  console.choose("fault kind", "stuck pipe");
  console.type("fault depth", "150");
  ASSERT_TRUE(console.asks("fault begin", "inject_fault: "));
  console.type("winch speed", "0.02");
  console.open_page_of("winch raise");
  QTest::mousePress(console.get("winch raise"), Qt::LeftButton);
  EXPECT_TRUE(wait_until([&] { return console.shows("watch surface_wob").startsWith("over-pull "); }))
      << console.shows("watch surface_wob").toStdString();
  EXPECT_TRUE(console.shows("watch surface_wob").contains("caution"));
  EXPECT_GT(console.shows("watch surface_wob").section(' ', 1, 1).toDouble(), 0.0);
  // 5 in pipe yields at 2465 kN, less what hangs on it
  ASSERT_TRUE(wait_until([&] { return console.shows("watch surface_wob").contains(" kN to yield"); }))
      << console.shows("watch surface_wob").toStdString();
  const double margin = console.shows("watch surface_wob").section(", ", 1).section(' ', 0, 0).toDouble();
  EXPECT_GT(margin, 1800.0);
  EXPECT_LT(margin, 2465.0);
  auto* warnings = console.get<QListWidget>("warnings now");
  EXPECT_TRUE(wait_until([&] { return !warnings->findItems("fault: stuck pipe at 1", Qt::MatchContains).isEmpty(); }))
      << "by its depth";
  QTest::mouseRelease(console.get("winch raise"), Qt::LeftButton);
  console.look("over_pull");
}

TEST(Stall, IsAnAlarmUntilItIsAcknowledged)
{
  end_shared_rig();
  const QString scene = QString::fromStdString(ros::package::getPath("drill_rig_sim")) + "/test/scenes/faults.yaml";
  const RigProcess rig("stalled", {"_scene:=" + scene});
  Console console("stalled");
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  ASSERT_TRUE(console.is_heard());
  console.type("mud pump flow", "1200");
  console.choose("fault kind", "motor stall");
  ASSERT_TRUE(console.asks("fault begin", "inject_fault: "));
  auto* warnings = console.get<QListWidget>("warnings now");
  const auto shows = [&](const QString& text) { return !warnings->findItems(text, Qt::MatchContains).isEmpty(); };
  EXPECT_TRUE(wait_until([&] { return shows("▲ mud motor stalled"); }));
  EXPECT_EQ("▲ mud motor stalled", console.shows("gravest warning"));
  console.look("stall");
  ASSERT_TRUE(console.asks("fault end", "inject_fault: "));
  EXPECT_TRUE(wait_until([&] { return shows("mud motor stalled (over: "); })) << "it stays until it is acknowledged";
  console.click("alarms acknowledge");
  EXPECT_TRUE(wait_until([&] { return !shows("mud motor stalled"); }));
}
