// SPDX-License-Identifier: BSD-3-Clause
// Boxes of numbers of the driller's console: set points follow what is in force until they are edited; a magnitude has its
// gauge's unit.
#include <cmath>

#include "console_test.h"
#include "drill_rig_sim/MudPumpCommand.h"
#include "drill_rig_sim/TopDriveCommand.h"

using namespace console_test;
using drill_rig_sim::MudPumpCommand;
using drill_rig_sim::TopDriveCommand;

class Boxes : public ::testing::Test
{
protected:
  Boxes() { shared_rig(); }
  void SetUp() override
  {
    ASSERT_TRUE(console_.is_in_state("RUNNING"));
    ASSERT_TRUE(console_.is_heard());
  }

  Console console_;
};

// Apply must never send a number that merely stood in a box: the boxes show what is in force.
TEST_F(Boxes, SetPointsFollowUntilTheyAreEdited)
{
  ros::NodeHandle rig("/" + std::string(shared_name));
  ros::Publisher others = rig.advertise<TopDriveCommand>("top_drive/command", 1);
  Listener<TopDriveCommand> commands("top_drive/command");
  console_.open_page_of("top drive speed");
  auto* speed = console_.get<QDoubleSpinBox>("top drive speed");
  const auto orders = [&](double rpm)
  {
    TopDriveCommand command;
    command.mode = TopDriveCommand::SPEED;
    command.speed = rpm * M_PI / 30.0;
    return [&, command, rpm] { return others.publish(command), std::abs(speed->value() - rpm) < 0.05; };
  };
  EXPECT_TRUE(wait_until(orders(53.0))) << "another's set point: " << speed->value();
  EXPECT_EQ(0, console_.get<QComboBox>("top drive mode")->currentIndex());
  EXPECT_EQ("", speed->accessibleDescription().toStdString());
  speed->setFocus();
  speed->selectAll();
  QTest::keyClicks(speed, "60");
  EXPECT_EQ("edited", speed->accessibleDescription().toStdString());
  EXPECT_TRUE(speed->font().bold());
  wait_for(1.5);
  EXPECT_TRUE(speed->text().startsWith("60")) << speed->text().toStdString();
  console_.window().grab().save(out_folder() + "/console_edited.png");
  QTest::keyClick(speed, Qt::Key_Escape);
  EXPECT_TRUE(wait_until([&] { return std::abs(speed->value() - 53.0) < 0.05; })) << speed->value();
  EXPECT_EQ("", speed->accessibleDescription().toStdString());
  console_.choose("top drive mode", "angle");
  EXPECT_EQ("edited", console_.get("top drive mode")->accessibleDescription().toStdString());
  QTest::keyClick(console_.get("top drive mode"), Qt::Key_Escape);
  EXPECT_TRUE(wait_until([&] { return console_.get<QComboBox>("top drive mode")->currentIndex() == 0; }));
  wait_for(0.5);
  commands.all();
  commands.clear();
  console_.click("top drive apply");
  ASSERT_TRUE(wait_until([&] { return !commands.all().empty(); }));
  EXPECT_NEAR(53.0 * M_PI / 30.0, commands.all().back()->speed, 1e-2) << "what turns goes on";
}

// The boxes follow what is in force only once the rig has reported it: Apply right after Stop must not start again what was
// stopped.
TEST_F(Boxes, ApplyAfterStopStartsNothing)
{
  Listener<MudPumpCommand> flows("mud_pump/command");
  Listener<TopDriveCommand> drives("top_drive/command");
  ASSERT_TRUE(wait_until([&] { return flows.connected() && drives.connected(); }));
  console_.choose("top drive mode", "speed");
  console_.type("top drive speed", "40");
  console_.type("mud pump flow", "900");
  EXPECT_TRUE(wait_until([&] { return console_.shows("top drive in force").contains("40"); }));
  EXPECT_TRUE(wait_until([&] { return console_.shows("mud pump in force").contains("900"); }));
  wait_for(1.2);  // what was sent has settled: the boxes follow
  flows.clear();
  drives.clear();
  for (const char* button : {"mud pump stop", "mud pump apply", "top drive stop", "top drive apply"}) console_.click(button);
  ASSERT_TRUE(wait_until([&] { return flows.all().size() == 2 && drives.all().size() == 2; }));
  for (const auto& flow : flows.all()) EXPECT_EQ(0.0, flow->flow);
  for (const auto& drive : drives.all()) EXPECT_EQ(0.0, drive->speed);
  EXPECT_EQ(TopDriveCommand::SPEED, drives.all().back()->mode);
  EXPECT_TRUE(wait_until([&] { return console_.shows("mud pump in force").startsWith("0 "); }))
      << console_.shows("mud pump in force").toStdString();
}

TEST_F(Boxes, AMagnitudeHasTheUnitOfItsGauge)
{
  console_.choose("fault kind", "sensor bias");
  console_.choose("fault gauge", "Flow");
  EXPECT_TRUE(console_.get<QAbstractSpinBox>("fault magnitude")->text().contains("L/min"));
  console_.choose("fault gauge", "Hook load");
  EXPECT_TRUE(console_.get<QAbstractSpinBox>("fault magnitude")->text().contains("kN"));
  EXPECT_FALSE(console_.get("fault depth")->isEnabled());
}
