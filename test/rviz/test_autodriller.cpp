// SPDX-License-Identifier: BSD-3-Clause
// The Autodriller box of the driller's console, with the law in its process and a rig.
#include <cmath>
#include <string>
#include <vector>

#include "console_test.h"
#include "drill_rig_sim/ControllerStatus.h"
#include "drill_rig_sim/RigState.h"

using namespace console_test;
using drill_rig_sim::ControllerStatus;
using drill_rig_sim::RigState;

// The autodriller of the console: it starts, leads by the limit that is reached first, follows its boxes, gives the block away to
// who takes it, and stops.
TEST(Autodriller, StartsFollowsAndStops)
{
  end_shared_rig();
  const RigProcess rig("driller");
  Console console("driller");
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  ASSERT_TRUE(console.is_heard());
  set_speed("driller", 5.0);
  Listener<RigState> states("rig_state", "driller");
  Listener<ControllerStatus> laws("controller/status", "driller");
  const auto shows = [&](const QString& text) { return console.shows("autodriller status").contains(text); };
  console.open_page_of("autodriller start");
  ASSERT_TRUE(wait_until([&] { return shows("stopped"); }));
  EXPECT_FALSE(console.get<QAbstractButton>("autodriller stop")->isEnabled());
  console.type("autodriller weight", "20");  // kN; soft rock, so that the rate of penetration is reached first
  console.type("autodriller rop", "20");     // m/h
  console.type("autodriller rotary_speed", "55");
  console.type("autodriller flow", "1500");
  EXPECT_TRUE(shows("stopped")) << "Enter starts nothing";
  console.click("autodriller start");
  ASSERT_TRUE(wait_until([&] { return shows("spinning up"); })) << console.shows("answer").toStdString();
  EXPECT_FALSE(console.get<QAbstractButton>("autodriller start")->isEnabled());
  ASSERT_TRUE(wait_until([&] { return !states.all().empty() && std::abs(states.all().back()->top_drive.speed - 5.76) < 0.01; }));
  console.click("mud pump apply");
  EXPECT_TRUE(console.answers("mud pump: not sent: the autodriller has it"));
  console.open_page_of("autodriller start");
  ASSERT_TRUE(wait_until([&] { return shows("drilling, ROP leads"); }, 2.0 * patience))
      << console.shows("autodriller status").toStdString();
  console.window().grab().save(out_folder() + "/console_1280x800_autodriller.png");
  console.look("drilling");
  ASSERT_FALSE(laws.all().empty());
  const ControllerStatus& status = *laws.all().back();
  EXPECT_EQ("autodriller", status.law);
  EXPECT_EQ(std::vector<std::string>({"weight", "rop", "flow", "to_depth", "rotary_speed"}), status.set_point)
      << "others have no limit";
  console.type("autodriller weight", "4");  // Enter applies: now the weight is reached first
  EXPECT_TRUE(wait_until([&] { return shows("drilling, WOB leads"); })) << console.shows("autodriller status").toStdString();
  EXPECT_TRUE(wait_until([&] { return laws.all().back()->value[0] == 4e3; }));
  console.open_page_of("winch raise");
  console.type("winch speed", "0.05");
  QTest::mousePress(console.get("winch raise"), Qt::LeftButton);
  EXPECT_TRUE(wait_until([&] { return !laws.all().back()->running && states.all().back()->winch.block_velocity == 0.05; }));
  wait_for(2.0);
  EXPECT_DOUBLE_EQ(0.05, states.all().back()->winch.block_velocity) << "the brake is not set meanwhile";
  QTest::mouseRelease(console.get("winch raise"), Qt::LeftButton);
  console.open_page_of("autodriller start");
  EXPECT_TRUE(wait_until([&] { return shows("stopped"); }));
  EXPECT_NEAR(5.76, states.all().back()->top_drive.speed, 0.01) << "the drive goes on";
  console.click("autodriller start");
  ASSERT_TRUE(wait_until([&] { return shows("spinning up"); }));
  console.click("autodriller stop");
  EXPECT_TRUE(wait_until([&] { return shows("stopped") && states.all().back()->winch.brake; }))
      << console.shows("autodriller status").toStdString() << states.all().back()->winch << console.shows("answer").toStdString();
  console.click("autodriller start");
  ASSERT_TRUE(wait_until([&] { return laws.all().back()->running; }));
  console.close();  // with the law in the middle of its work
  EXPECT_TRUE(wait_until([&] { return states.all().back()->winch.brake && !laws.connected(); })) << "its process has ended";
}
