// SPDX-License-Identifier: BSD-3-Clause
// Every control of the driller's console: its command arrives, its service answers, what is in force is shown, and a refusal too.
#include <ros/package.h>

#include <QCheckBox>
#include <QFileDialog>
#include <QListWidget>
#include <cmath>
#include <fstream>

#include "console_test.h"
#include "drill_rig_sim/MudPumpCommand.h"
#include "drill_rig_sim/RigState.h"
#include "drill_rig_sim/SaveState.h"
#include "drill_rig_sim/SteeringCommand.h"
#include "drill_rig_sim/TopDriveCommand.h"
#include "drill_rig_sim/WinchCommand.h"

using namespace console_test;
using drill_rig_sim::MudPumpCommand;
using drill_rig_sim::RigState;
using drill_rig_sim::SaveState;
using drill_rig_sim::SteeringCommand;
using drill_rig_sim::TopDriveCommand;
using drill_rig_sim::WinchCommand;

class Commands : public ::testing::Test
{
protected:
  Commands() { shared_rig(); }
  void SetUp() override
  {
    ASSERT_TRUE(console_.is_in_state("RUNNING"));
    ASSERT_TRUE(console_.is_heard());
  }

  Console console_;
};

class Winch : public Commands
{
protected:
  void SetUp() override
  {
    Commands::SetUp();
    ASSERT_TRUE(wait_until([&] { return commands_.connected(); }));
    commands_.all();
    commands_.clear();
    console_.open_page_of("winch raise");
    console_.type("winch speed", "0.05");
  }
  // The command comes again and again while it is held, and once with 0 when not.
  void expect_held(double velocity)
  {
    EXPECT_TRUE(wait_until([&] { return commands_.all().size() >= 5; }));
    for (const auto& m : commands_.all()) EXPECT_DOUBLE_EQ(velocity, m->block_velocity);
    EXPECT_FALSE(commands_.all().back()->brake);
  }
  void expect_let_go()
  {
    ASSERT_TRUE(wait_until([&] { return !commands_.all().empty() && commands_.all().back()->block_velocity == 0.0; }));
    const std::size_t number = commands_.all().size();
    wait_for(0.5);
    EXPECT_EQ(number, commands_.all().size()) << "then nothing";
  }

  Listener<WinchCommand> commands_{"winch/command"};
};

TEST_F(Winch, RaisesWhileItIsHeld)
{
  QWidget* raise = console_.get("winch raise");
  QTest::mousePress(raise, Qt::LeftButton);
  expect_held(0.05);
  EXPECT_TRUE(wait_until([&] { return console_.shows("winch in force").contains("0.050 m/s"); }));
  QTest::mouseRelease(raise, Qt::LeftButton);
  expect_let_go();
  EXPECT_TRUE(wait_until([&] { return console_.shows("winch in force").contains("0.000 m/s"); }));
}

TEST_F(Winch, ByTheKeys)
{
  QWidget* lower = console_.get("winch lower");
  lower->setFocus();
  QTest::keyPress(lower, Qt::Key_Down);
  expect_held(-0.05);
  QTest::keyRelease(lower, Qt::Key_Down);
  expect_let_go();
  commands_.clear();
  QTest::keyPress(lower, Qt::Key_Space);
  expect_held(-0.05);
  QTest::keyRelease(lower, Qt::Key_Space);
  expect_let_go();
}

TEST_F(Winch, StopsWhenTheFocusGoes)
{
  QTest::mousePress(console_.get("winch raise"), Qt::LeftButton);
  expect_held(0.05);
  QFocusEvent out(QEvent::FocusOut);
  QApplication::sendEvent(console_.get("winch raise"), &out);
  expect_let_go();
}

TEST_F(Winch, StopsWhenTheWindowIsLost)
{
  QTest::mousePress(console_.get("winch raise"), Qt::LeftButton);
  expect_held(0.05);
  QEvent lost(QEvent::WindowDeactivate);
  QApplication::sendEvent(&console_.window(), &lost);
  expect_let_go();
}

TEST_F(Winch, StopsWhenThePanelIsHidden)
{
  QTest::mousePress(console_.get("winch raise"), Qt::LeftButton);
  expect_held(0.05);
  console_.panel()->hide();
  expect_let_go();
}

TEST_F(Winch, StopsWhenAnotherPageIsOpened)
{
  QTest::mousePress(console_.get("winch raise"), Qt::LeftButton);
  expect_held(0.05);
  console_.open_page(0);
  expect_let_go();
}

TEST_F(Winch, StopsWhenItIsClosed)
{
  QTest::mousePress(console_.get("winch raise"), Qt::LeftButton);
  expect_held(0.05);
  console_.close();
  expect_let_go();
}

TEST_F(Winch, Brake)
{
  console_.click("winch set brake");
  ASSERT_TRUE(wait_until([&] { return !commands_.all().empty(); }));
  EXPECT_TRUE(commands_.all().back()->brake);
  EXPECT_TRUE(wait_until([&] { return console_.shows("winch in force").startsWith("brake"); }));
  console_.click("winch release brake");
  ASSERT_TRUE(wait_until([&] { return commands_.all().size() >= 2; }));
  EXPECT_FALSE(commands_.all().back()->brake);
  EXPECT_TRUE(wait_until([&] { return console_.shows("winch in force").contains("0.000 m/s"); }));
}

TEST_F(Commands, EveryModeOfTheTopDrive)
{
  Listener<TopDriveCommand> commands("top_drive/command");
  ASSERT_TRUE(wait_until([&] { return commands.connected(); }));
  console_.type("top drive torque limit", "20");
  EXPECT_TRUE(wait_until([&] { return commands.all().size() == 1; })) << "Enter applies";
  const struct
  {
    const char *mode, *fill, *value, *in_force;
    int number;
  } modes[] = {{"speed", "top drive speed", "60", "in force: speed 60.0 rpm", TopDriveCommand::SPEED},
               {"torque", "top drive torque", "2", "in force: torque 2.00 kN m", TopDriveCommand::TORQUE},
               {"angle", "top drive angle", "720", "in force: angle", TopDriveCommand::ANGLE},
               {"soft torque", "top drive speed", "50", "in force: soft torque 50.0 rpm", TopDriveCommand::SOFT_TORQUE},
               {"Z torque", "top drive speed", "40", "in force: Z torque 40.0 rpm", TopDriveCommand::Z_TORQUE},
               {"oscillate", "top drive amplitude right", "180", "in force: oscillate", TopDriveCommand::OSCILLATE}};
  for (const auto& one : modes)
  {
    commands.clear();
    console_.choose("top drive mode", one.mode);
    ASSERT_TRUE(console_.get(one.fill)->isEnabled()) << one.mode;
    console_.type(one.fill, one.value);  // Enter applies
    ASSERT_TRUE(wait_until([&] { return commands.all().size() == 1; })) << one.mode;
    EXPECT_EQ(one.number, commands.all().back()->mode);
    EXPECT_DOUBLE_EQ(20e3, commands.all().back()->torque_limit);
    EXPECT_TRUE(wait_until([&] { return console_.shows("top drive in force").startsWith(one.in_force); }))
        << console_.shows("top drive in force").toStdString();
  }
  EXPECT_NEAR(M_PI, commands.all().back()->amplitude_right, 1e-3);
  commands.clear();
  console_.get<QCheckBox>("top drive brake")->click();
  console_.click("top drive apply");
  ASSERT_TRUE(wait_until([&] { return !commands.all().empty(); }));
  EXPECT_TRUE(commands.all().back()->brake);
  console_.click("top drive stop");
  EXPECT_TRUE(wait_until([&] { return console_.shows("top drive in force").startsWith("in force: speed 0.0 rpm"); }));
}

TEST_F(Commands, TheAngleOfNow)
{
  console_.choose("top drive mode", "angle");
  wait_for(0.5);
  console_.type("top drive angle", "12345");
  console_.click("top drive take angle");
  EXPECT_NE(12345.0, console_.get<QDoubleSpinBox>("top drive angle")->value());
}

TEST_F(Commands, FlowAndSteering)
{
  Listener<MudPumpCommand> flows("mud_pump/command");
  Listener<SteeringCommand> steerings("steering/command");
  ASSERT_TRUE(wait_until([&] { return flows.connected() && steerings.connected(); }));
  console_.type("mud pump flow", "900");
  ASSERT_TRUE(wait_until([&] { return !flows.all().empty(); }));
  EXPECT_NEAR(0.015, flows.all().back()->flow, 1e-9);
  EXPECT_TRUE(wait_until([&] { return console_.shows("mud pump in force").contains("900 L/min"); }));
  console_.type("steering toolface", "90");
  console_.type("steering ratio", "80");
  ASSERT_TRUE(wait_until([&] { return steerings.all().size() == 2; }));
  EXPECT_NEAR(0.5 * M_PI, steerings.all().back()->toolface, 1e-3);
  EXPECT_NEAR(0.8, steerings.all().back()->ratio, 1e-9);
  EXPECT_TRUE(wait_until([&] { return console_.shows("steering in force").contains("90.0 deg, 80 %"); }));
  console_.click("mud pump stop");
  EXPECT_TRUE(wait_until([&] { return console_.shows("mud pump in force").startsWith("0 L/min"); }));
}

TEST_F(Commands, PauseResumeStepSpeed)
{
  ASSERT_TRUE(console_.asks("time pause", "pause: "));
  EXPECT_TRUE(console_.is_in_state("PAUSED"));
  ASSERT_TRUE(console_.asks("time resume", "resume: "));
  EXPECT_TRUE(console_.is_in_state("RUNNING"));
  ASSERT_TRUE(console_.asks("time step", "step: ")) << "refused outside lockstep, which is shown";
  EXPECT_TRUE(console_.get<QLabel>("answer")->text().contains("lockstep"));
  console_.type("time speed", "2");
  ASSERT_TRUE(console_.asks("time set speed", "set_speed: "));
  const auto factor = [&] { return console_.shows("speed in force").section(QString::fromUtf8("×"), 1).toDouble(); };
  EXPECT_TRUE(wait_until([&] { return factor() > 1.8 && factor() < 2.2; }));
  console_.type("time speed", "1");
  ASSERT_TRUE(console_.asks("time set speed", "set_speed: "));
}

TEST_F(Commands, SlipsAndConnection)
{
  console_.click("top drive stop");
  console_.click("mud pump stop");
  console_.click("winch set brake");
  ASSERT_TRUE(console_.asks("connection add", "make_connection: ")) << "refused without slips";
  EXPECT_TRUE(console_.get<QLabel>("answer")->text().contains("slips")) << console_.get<QLabel>("answer")->text().toStdString();
  ASSERT_TRUE(console_.asks("connection remove", "make_connection: "));
  // refused while the top drive of the tests before still turns
  const auto is_in_slips = [&]
  {
    return console_.asks("slips set", "set_slips: ") &&
           wait_until([&] { return console_.shows("pipe state").contains("in slips"); }, 1.0);
  };
  EXPECT_TRUE(wait_until(is_in_slips)) << console_.get<QLabel>("answer")->text().toStdString();
  ASSERT_TRUE(console_.asks("slips pull", "set_slips: "));
}

TEST_F(Commands, Snapshots)
{
  Listener<RigState> states("rig_state");
  const auto depth = [&] { return states.all().back()->block_height; };
  ASSERT_TRUE(wait_until([&] { return !states.all().empty(); }));
  console_.get<QComboBox>("snapshot name")->setEditText(" before ");
  ASSERT_TRUE(console_.asks("snapshot save", "save_state: saved as before"));
  const double then = depth();
  console_.type("winch speed", "0.1");
  console_.open_page_of("winch raise");
  QTest::mousePress(console_.get("winch raise"), Qt::LeftButton);
  EXPECT_TRUE(wait_until([&] { return depth() > then + 0.2; }));
  QTest::mouseRelease(console_.get("winch raise"), Qt::LeftButton);
  ASSERT_TRUE(console_.asks("snapshot restore", "restore_state: restored before"));
  EXPECT_TRUE(wait_until([&] { return std::abs(depth() - then) < 0.05; })) << depth() << " instead of " << then;
  const auto listed = [&](const QString& name) { return console_.get<QComboBox>("snapshot name")->findText(name) >= 0; };
  EXPECT_TRUE(wait_until([&] { return listed("before"); })) << "to be chosen again";
  const QString file = out_folder() + "/console_snapshot";
  console_.get<QComboBox>("snapshot name")->setEditText(file);
  ASSERT_TRUE(console_.asks("snapshot save", "save_state: written to " + file));
  ASSERT_TRUE(console_.asks("snapshot restore", "restore_state: restored " + file));
  EXPECT_TRUE(wait_until([&] { return listed(file); }));
  SaveState elsewhere;
  elsewhere.request.name = "elsewhere";
  ASSERT_TRUE(ros::service::call("/" + std::string(shared_name) + "/save_state", elsewhere));
  QEvent enter(QEvent::Enter);
  QCoreApplication::sendEvent(console_.get("snapshot name"), &enter);
  EXPECT_TRUE(wait_until([&] { return listed("elsewhere"); })) << "another rig's";
  EXPECT_EQ(file, console_.get<QComboBox>("snapshot name")->currentText());
  console_.get<QComboBox>("snapshot name")->setEditText("before");
  console_.forget_answer();
  console_.click_and_agree("snapshot delete", "snapshot delete question");
  ASSERT_TRUE(console_.answers("delete_state: deleted before"));
  EXPECT_TRUE(wait_until([&] { return !listed("before"); }));
  ASSERT_TRUE(console_.asks("snapshot restore", "restore_state: ")) << "refused, which is told";
  EXPECT_TRUE(console_.get<QLabel>("answer")->text().contains("before")) << console_.get<QLabel>("answer")->text().toStdString();
}

TEST_F(Commands, ResetAndSurvey)
{
  const QString good = out_folder() + "/console_survey.csv", bad = out_folder() + "/console_bad_survey.csv";
  std::ofstream(good.toStdString()) << "md_m,inclination_deg,azimuth_deg\n0,0,0\n100,0,0\n210,10,45\n";
  std::ofstream(bad.toStdString()) << "md_m,inclination_deg,azimuth_deg\n0,0,0\n100,0,0\n90,10,45\n";
  const auto load = [&](const QString& file)
  {
    console_.forget_answer();
    console_.click("well load survey");
    auto* dialog = console_.get<QFileDialog>("survey file dialog");
    EXPECT_TRUE(dialog->directory().path().endsWith("/config/surveys")) << "where surveys are";
    ASSERT_TRUE(wait_until([&] { return dialog->isVisible(); }));
    auto* line = dialog->findChild<QLineEdit*>("fileNameEdit");
    line->setText(file);
    QTest::keyClick(line, Qt::Key_Return);
    wait_until([&] { return console_.panel()->findChildren<QFileDialog*>().isEmpty(); }, 5.0);
  };
  load(bad);
  ASSERT_TRUE(console_.answers("load_survey: "));
  EXPECT_TRUE(console_.shows("well answer").startsWith("refused: ")) << console_.shows("well answer").toStdString();
  load(good);
  ASSERT_TRUE(console_.answers("load_survey: "));
  EXPECT_FALSE(console_.shows("well answer").startsWith("refused: ")) << console_.shows("well answer").toStdString();
  console_.get<QLineEdit>("well scene")->setText("no_such_scene.yaml");
  console_.forget_answer();
  console_.click("well reset");
  wait_for(0.5);
  EXPECT_TRUE(console_.get<QLabel>("answer")->text().isEmpty()) << "it asks first";
  QTest::keyClick(console_.get("well reset question"), Qt::Key_Escape);
  wait_for(0.5);
  EXPECT_TRUE(console_.get<QLabel>("answer")->text().isEmpty()) << "and a no is a no";
  console_.click_and_agree("well reset", "well reset question");
  ASSERT_TRUE(console_.answers("reset_well: "));
  EXPECT_TRUE(console_.shows("well answer").startsWith("refused: "));
  console_.get<QLineEdit>("well scene")->setText("");
  console_.forget_answer();
  console_.click_and_agree("well reset", "well reset question");
  ASSERT_TRUE(console_.answers("reset_well: "));
  EXPECT_FALSE(console_.shows("well answer").startsWith("refused: ")) << console_.shows("well answer").toStdString();
  shared_rig().end(SIGINT);  // others want the scene's own well
}

TEST_F(Commands, EveryFaultIsAnswered)
{
  auto* kinds = console_.get<QComboBox>("fault kind");
  ASSERT_EQ(16, kinds->count());
  console_.type("fault depth", "150");
  for (int n = 0; n < kinds->count(); ++n)
  {
    console_.choose("fault kind", kinds->itemText(n));
    ASSERT_TRUE(console_.asks("fault begin", "inject_fault: ")) << kinds->itemText(n).toStdString();
    ASSERT_TRUE(console_.asks("fault end", "inject_fault: ")) << kinds->itemText(n).toStdString();
  }
  EXPECT_TRUE(wait_until([&] { return console_.get<QListWidget>("event log")->count() >= 32; }));
}
