// SPDX-License-Identifier: BSD-3-Clause
// A string that is picked up and slacked off: its weights are marks of the hook load and lines of the log.
#include <QListWidget>
#include <algorithm>

#include "console_test.h"
#include "drill_rig_sim/RigState.h"

using namespace console_test;

namespace
{
/// "▲ Pick-up weight 262.3 kN at 190.12 m" of the hook load's tool tip; "" where there is none.
QString mark_of(const Console& console, const QString& name)
{
  for (const QString& line : console.get("gauge hook_load")->toolTip().split('\n'))
    if (line.contains(name)) return line;
  return {};
}

double load_of(const QString& mark)
{
  return mark.section("weight ", 1).section(' ', 0, 0).toDouble();
}
}  // namespace

TEST(Weights, AreMarksOfTheHookLoad)
{
  end_shared_rig();
  const RigProcess rig("weighed");
  Console console("weighed", 900, 970);
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  ASSERT_TRUE(console.is_heard());
  set_speed("weighed", 8.0);
  console.type("winch speed", "0.1");
  Listener<drill_rig_sim::RigState> states("rig_state", "weighed");
  console.open_page_of("winch raise");
  QTest::mousePress(console.get("winch raise"), Qt::LeftButton);
  ASSERT_TRUE(wait_until([&] { return !mark_of(console, "▲ Pick-up").isEmpty(); }));
  const double up = load_of(mark_of(console, "▲ Pick-up"));
  ASSERT_TRUE(wait_until([&] { return states.all().back()->bit_depth < 192.0; })) << "room to slack off";
  QTest::mouseRelease(console.get("winch raise"), Qt::LeftButton);
  EXPECT_NEAR(1e-3 * states.all().back()->hook_load, up, 15.0);
  auto* log = console.get<QListWidget>("event log");
  EXPECT_TRUE(wait_until([&] { return !log->findItems("Pick-up weight", Qt::MatchContains).isEmpty(); }))
      << "logged when the move is over";
  console.type("winch speed", "0.1");
  console.open_page_of("winch lower");
  QTest::mousePress(console.get("winch lower"), Qt::LeftButton);
  ASSERT_TRUE(wait_until([&] { return !mark_of(console, "▼ Slack-off").isEmpty(); }))
      << states.all().back()->bit_depth << " m, " << states.all().back()->block_velocity;
  QTest::mouseRelease(console.get("winch lower"), Qt::LeftButton);
  EXPECT_LT(load_of(mark_of(console, "▼ Slack-off")), up) << "the wall holds the string up";
  console.choose("settings units", "oilfield");
  EXPECT_TRUE(wait_until([&] { return mark_of(console, "▲ Pick-up").contains(" klbf at "); }));
  console.choose("settings units", "SI");
  console.open_page_of("winch raise");
  wait_for(0.5);
  console.window().grab().save(out_folder() + "/console_weights.png");
}
