// SPDX-License-Identifier: BSD-3-Clause
// Connections from the console: by one click, and step by step.
#include <ros/package.h>

#include <cmath>

#include "console_test.h"
#include "drill_rig_sim/RigState.h"

using namespace console_test;
using drill_rig_sim::RigState;

TEST(Connection, ByOneClick)
{
  end_shared_rig();
  const QString scene = QString::fromStdString(ros::package::getPath("drill_rig_sim")) + "/test/scenes/console_connection.yaml";
  const RigProcess rig("crew", {"_scene:=" + scene});
  Console console("crew");
  Listener<RigState> states("rig_state", "crew");
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  ASSERT_TRUE(console.is_heard());
  ASSERT_TRUE(wait_until([&] { return !states.all().empty(); }));
  set_speed("crew", 4.0);
  const int stands = states.all().back()->stand_count;
  console.type("mud pump flow", "300");
  ASSERT_TRUE(wait_until([&] { return states.all().back()->flow > 1e-3; }));
  console.click("autodriller connection");
  EXPECT_TRUE(wait_until([&] { return console.shows("autodriller status").startsWith("connection: "); }))
      << console.get<QLabel>("answer")->text().toStdString();
  EXPECT_FALSE(console.get<QAbstractButton>("autodriller apply")->isEnabled());
  EXPECT_TRUE(wait_until([&] { return states.all().back()->stand_count == stands + 1; }, 2.0 * patience))
      << console.shows("autodriller status").toStdString();
  EXPECT_TRUE(wait_until([&] { return console.shows("autodriller status") == "stopped" && states.all().back()->in_slips == 0; }))
      << console.shows("autodriller status").toStdString();
  EXPECT_TRUE(wait_until([&] { return states.all().back()->winch.brake; }));
  EXPECT_EQ(0.0, states.all().back()->mud_pump.flow) << "the pump stays off";
}

// Slips, slack off, a stand, pick up, slips: what a driller does.
TEST(Connection, AStandByHand)
{
  const QString scene = QString::fromStdString(ros::package::getPath("drill_rig_sim")) + "/test/scenes/console_connection.yaml";
  end_shared_rig();
  const RigProcess rig("connected", {"_scene:=" + scene});
  Console console("connected");
  Listener<RigState> states("rig_state", "connected");
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  ASSERT_TRUE(wait_until([&] { return !states.all().empty(); }));
  set_speed("connected", 3.0);
  const auto last = [&]() -> const RigState& { return *states.all().back(); };
  const auto hold = [&](const QString& button, const std::function<bool()>& enough)
  {
    console.open_page_of(button);
    QTest::mousePress(console.get(button), Qt::LeftButton);
    const bool came = wait_until(enough);
    QTest::mouseRelease(console.get(button), Qt::LeftButton);
    console.click("winch set brake");
    return came && wait_until([&] { return std::abs(last().block_velocity) < 1e-6; });
  };
  const auto shows_pipe = [&](const QString& text)
  { return wait_until([&] { return console.shows("pipe state").startsWith(text); }); };
  const unsigned stands = last().stand_count;
  const double hanging = last().hook_load;
  ASSERT_TRUE(console.asks("slips set", "set_slips: the slips are set"));
  EXPECT_TRUE(shows_pipe(QStringLiteral("in slips, %1 stands").arg(stands)));
  console.type("winch speed", "0.01");
  constexpr double block_and_pipe = 9.80665 * (17500.0 + 10.0 * 31.9),
                   gravity = 9.80665;  // of the scene; a joint at most lies above the slips
  ASSERT_GT(hanging, block_and_pipe + 50e3);
  ASSERT_TRUE(hold("winch lower", [&] { return last().hook_load < block_and_pipe + 4e3; })) << last().hook_load;
  ASSERT_TRUE(console.asks("connection add", "make_connection: adding one stand; current_operation shows when it is finished"))
      << console.get<QLabel>("answer")->text().toStdString();
  EXPECT_TRUE(wait_until([&] { return last().current_operation == "connecting"; }));
  set_speed("connected", 0.2);  // longer than the pictures take
  console.look("connection");
  set_speed("connected", 3.0);
  ASSERT_TRUE(shows_pipe(QStringLiteral("in slips, %1 stands").arg(stands + 1)));
  ASSERT_TRUE(wait_until([&] { return last().current_operation.empty(); }));
  const double stand = 28.5 * 31.9 * gravity;
  ASSERT_TRUE(hold("winch raise", [&] { return last().hook_load > hanging + stand - 2e3; })) << last().hook_load;
  // the block's rail, moving up, shows on the hook as well: a little more where the slips still bear too much
  const auto is_pulled = [&]
  {
    if (!console.asks("slips pull", "set_slips: ")) return false;
    if (console.get<QLabel>("answer")->text().contains("the slips are pulled")) return true;
    const double height = last().block_height;
    hold("winch raise", [&] { return last().block_height > height + 1e-3; });
    return false;
  };
  ASSERT_TRUE(wait_until(is_pulled)) << console.get<QLabel>("answer")->text().toStdString();
  EXPECT_TRUE(shows_pipe(QStringLiteral("on the hook, %1 stands").arg(stands + 1)));
  wait_for(1.0);
  EXPECT_NEAR(hanging + stand, last().hook_load, 8e3) << "the block's rail carries some of it";
}
