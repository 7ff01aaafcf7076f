// SPDX-License-Identifier: BSD-3-Clause
// The driller's console beside a simulator that comes, goes, hangs or was never there; what it keeps, and what it costs.
#include <ros/callback_queue.h>
#include <ros/package.h>
#include <std_srvs/Trigger.h>
#include <sys/resource.h>

#include <csignal>
#include <thread>

#include "console_test.h"
#include "drill_rig_sim/RigState.h"

using namespace console_test;

namespace
{
bool subscribes(const std::string& rig)
{
  ros::V_string topics;
  ros::this_node::getSubscribedTopics(topics);
  for (const std::string& topic : topics)
    if (topic.find("/" + rig + "/") == 0 || topic == "/diagnostics") return true;
  return false;
}

double cpu_seconds()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_utime.tv_sec + usage.ru_stime.tv_sec + 1e-6 * (usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}
}  // namespace

TEST(Life, SaysWhoIsNotThereAndRefusesCommands)
{
  Console console("nobody_home");
  ASSERT_TRUE(console.is_in_state("ABSENT"));
  for (const auto& [button, what] : std::vector<std::pair<QString, QString>>{{"winch set brake", "winch"},
                                                                             {"top drive apply", "top drive"},
                                                                             {"mud pump apply", "mud pump"},
                                                                             {"steering apply", "steering"},
                                                                             {"time pause", "pause"},
                                                                             {"pipe tare", "tare"},
                                                                             {"slips set", "set_slips"},
                                                                             {"connection add", "make_connection"},
                                                                             {"fault begin", "inject_fault"}})
    EXPECT_TRUE(console.asks(button, what + ": not sent: no simulator at /nobody_home"));
  console.forget_answer();
  console.click_and_agree("well reset", "well reset question");
  EXPECT_TRUE(console.answers("reset_well: not sent: no simulator at /nobody_home"));
  const auto* log = console.get<QListWidget>("event log");
  const int lines = log->count();
  for (int n = 0; n < 3; ++n) EXPECT_TRUE(console.asks("time pause", "pause: not sent"));
  EXPECT_EQ(lines + 1, log->count()) << "a line that repeats is counted";
  EXPECT_TRUE(log->item(0)->text().endsWith("(3 times)")) << log->item(0)->text().toStdString();
  console.open_page_of("winch raise");
  console.forget_answer();
  QTest::mousePress(console.get("winch raise"), Qt::LeftButton);
  EXPECT_TRUE(console.answers("winch: not sent"));
}

TEST(Life, TheNodeIsKilledAndComesBack)
{
  auto rig = std::make_unique<RigProcess>("mortal");
  Console console("mortal");
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  rig->end(SIGKILL);
  EXPECT_TRUE(console.is_in_state("LATE"));
  EXPECT_TRUE(wait_until([&] { return console.shows("gauge hook_load").contains("stale"); }));
  EXPECT_TRUE(console.is_in_state("ABSENT"));
  EXPECT_EQ("No readings: warnings are not known", console.shows("gravest warning"));
  console.look("killed");
  EXPECT_TRUE(console.asks("mud pump apply", "mud pump: not sent"));
  rig = std::make_unique<RigProcess>("mortal");
  EXPECT_TRUE(console.is_in_state("RUNNING"));
  console.open_page(0);
  EXPECT_TRUE(wait_until([&] { return !console.shows("gauge hook_load").contains("stale"); }));
  ASSERT_TRUE(console.is_heard());
  console.type("mud pump flow", "1200");
  EXPECT_TRUE(wait_until([&] { return console.shows("gauge azimuth").contains("deg"); })) << "telemetry comes again too";
  rig->end(SIGINT);
  EXPECT_TRUE(console.is_in_state("ABSENT"));
  rig = std::make_unique<RigProcess>("mortal");
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  ASSERT_TRUE(console.is_heard());
  EXPECT_TRUE(wait_until([&] { return console.shows("mud pump in force").startsWith("0 L/min"); }));
}

TEST(Life, ClosedBeforeTheNodeAndAfterIt)
{
  auto rig = std::make_unique<RigProcess>("brief");
  {
    Console console("brief");
    ASSERT_TRUE(console.is_in_state("RUNNING"));
  }
  Console console("brief");
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  console.click("well reset");  // closed with a call under way
  rig.reset();
  console.close();
}

TEST(Life, APauseIsSeenByWhoComesLater)
{
  shared_rig();
  {
    Console console;
    ASSERT_TRUE(console.is_in_state("RUNNING"));
    ASSERT_TRUE(console.asks("time pause", "pause: "));
  }
  Console console;
  EXPECT_TRUE(console.is_in_state("PAUSED")) << "by the diagnostics: nothing else is sent";
  ASSERT_TRUE(console.asks("time resume", "resume: "));
  EXPECT_TRUE(console.is_in_state("RUNNING"));
}

TEST(Life, APauseThatBeganWhileItWasHiddenIsSeen)
{
  shared_rig();
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  console.panel()->hide();
  std_srvs::Trigger service;
  ASSERT_TRUE(ros::service::call("/" + std::string(shared_name) + "/pause", service) && service.response.success);
  wait_for(1.5);
  console.panel()->show();
  EXPECT_TRUE(console.is_in_state("PAUSED"));
  wait_for(3.0);
  EXPECT_TRUE(console.is_in_state("PAUSED"));
  ASSERT_TRUE(console.asks("time resume", "resume: "));
  EXPECT_TRUE(console.is_in_state("RUNNING"));
}

TEST(Life, AFailureIsTold)
{
  const QString scene = QString::fromStdString(ros::package::getPath("drill_rig_sim")) + "/test/scenes/unsolvable.yaml";
  const RigProcess rig("failing", {"_scene:=" + scene, "_rate:=20", "_play_program:=true"});
  Console console("failing");
  ASSERT_TRUE(console.is_in_state("FAILED"));
  EXPECT_TRUE(wait_until([&] { return console.shows("gravest warning").contains("stopped at the last good state"); }));
}

TEST(Life, InLockstepItWaitsAndSteps)
{
  const RigProcess rig("stepped", {"_clock:=lockstep"});
  Console console("stepped");
  ASSERT_TRUE(console.is_in_state("WAITS FOR A STEP"));
  ASSERT_TRUE(console.asks("time step", "step: done"));
  EXPECT_TRUE(wait_until([&] { return console.shows("simulated time").startsWith("0:00:01"); }))
      << console.shows("simulated time").toStdString();
}

TEST(Life, HiddenItListensToNothing)
{
  shared_rig();
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  EXPECT_TRUE(subscribes(shared_name));
  console.panel()->hide();
  EXPECT_FALSE(subscribes(shared_name));
  console.panel()->show();
  EXPECT_TRUE(subscribes(shared_name));
  EXPECT_TRUE(console.is_in_state("RUNNING"));
}

TEST(Life, AnyNamespace)
{
  shared_rig();
  Console console("nobody_home");
  ASSERT_TRUE(console.is_in_state("ABSENT"));
  console.open_page_of("settings namespace");
  auto* line = console.get<QComboBox>("settings namespace")->lineEdit();
  line->setText("no name!");
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_TRUE(console.answers("namespace: "));
  line->setText(shared_name);
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_TRUE(console.is_in_state("RUNNING"));
  EXPECT_EQ("/" + std::string(shared_name), console.shows("rig").toStdString());
}

TEST(Life, AnEmptyNamespaceFindsTheOnlyRig)
{
  shared_rig();
  Console console("");
  EXPECT_TRUE(console.is_in_state("RUNNING")) << "unless another rig runs on this master";
}

TEST(Life, SettingsAreKept)
{
  rviz::Config kept;
  {
    Console console("some/where");
    console.choose("settings units", "oilfield");
    console.type("settings bit diameter", "8.5");
    console.get<QAbstractButton>("settings truth")->click();
    console.choose("chart axis", "time down");
    console.open_page_of("chart axis");
    console.get<QAbstractButton>("chart scales")->click();
    console.get<QAbstractButton>("chart fixed torque")->click();
    QTest::mouseClick(console.get("chart scales ok"), Qt::LeftButton);
    kept = console.config();
  }
  Console console("elsewhere");
  console.panel()->load(kept);
  EXPECT_EQ("/some/where", console.shows("rig").toStdString());
  EXPECT_EQ("oilfield", console.get<QComboBox>("settings units")->currentText().toStdString());
  EXPECT_EQ("8.500 in", console.get<QAbstractSpinBox>("settings bit diameter")->text().toStdString());
  EXPECT_TRUE(console.get<QAbstractButton>("settings truth")->isChecked());
  EXPECT_EQ("time down", console.get<QComboBox>("chart axis")->currentText().toStdString());
  console.open_page_of("chart axis");
  console.get<QAbstractButton>("chart scales")->click();
  EXPECT_TRUE(console.get<QAbstractButton>("chart fixed torque")->isChecked());
  EXPECT_FALSE(console.get<QAbstractButton>("chart fixed hook_load")->isChecked());
}

TEST(Life, AServiceThatHangsDoesNotHangTheWindow)
{
  ros::NodeHandle node("/hanging");
  ros::CallbackQueue queue;
  node.setCallbackQueue(&queue);
  std::atomic<bool> over{false};
  std::atomic<int> calls{0};
  const boost::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)> hang =
      [&](std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)
  {
    ++calls;
    while (!over) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return true;
  };
  const ros::ServiceServer server = node.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>("pause", hang);
  ros::Publisher states = node.advertise<drill_rig_sim::RigState>("rig_state", 1);
  ros::AsyncSpinner spinner(1, &queue);
  spinner.start();
  Console console("hanging");
  drill_rig_sim::RigState state;
  const auto publish = [&]
  {
    state.header.stamp = state.header.stamp + ros::Duration(0.01);
    states.publish(state);
    return true;
  };
  ASSERT_TRUE(wait_until([&] { return publish() && console.get<QLabel>("simulator state")->text() == "RUNNING"; }));
  console.click("time pause");
  ASSERT_TRUE(wait_until([&] { return publish() && calls == 1; }));
  double longest = 0.0;
  QElapsedTimer between;
  between.start();
  ASSERT_TRUE(wait_until(
      [&]
      {
        longest = std::max(longest, 1e-3 * between.restart());
        return publish() && console.get<QLabel>("answer")->text().startsWith("pause: no answer within 10 s");
      },
      40.0));
  EXPECT_LT(longest, 2.0) << "seconds that the window stood";
  console.click("time pause");
  wait_until([&] { return publish() && false; }, 0.5);
  between.restart();
  console.close();
  EXPECT_LT(1e-3 * between.elapsed(), 5.0) << "closing does not wait for an answer either";
  over = true;
}

TEST(Life, CostsLessThanAQuarterOfACore)
{
  shared_rig();
  Console console;
  ASSERT_TRUE(console.is_in_state("RUNNING"));
  for (int page = 0; page < console.tabs()->count(); ++page)
  {
    console.open_page(page);
    wait_for(0.5);
    const double before = cpu_seconds();
    QTest::qWait(2000);
    const double share = (cpu_seconds() - before) / 2.0;
    RecordProperty("share_of_a_core_page_" + std::to_string(page), std::to_string(share));
    std::cout << "page " << page << ": " << 100.0 * share << " % of a core\n";
    EXPECT_LT(share, 0.25) << "page " << page;
  }
}
