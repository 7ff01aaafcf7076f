// SPDX-License-Identifier: BSD-3-Clause
// The display Drillstring and the tool Probe in a view of their own, with a string whose numbers are known: a vertical one, hung
// at the table, its bit at 1000 m. Along it every number grows steadily with the distance from the bit, so that a place tells
// what must be shown there.
#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <rviz/display.h>
#include <rviz/properties/property.h>
#include <rviz/properties/status_list.h>
#include <rviz/properties/vector_property.h>
#include <rviz/render_panel.h>
#include <rviz/tool_manager.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <QApplication>
#include <QFileInfo>
#include <QScreen>
#include <QtTest>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>

#include "drill_rig_sim/ControllerStatus.h"
#include "drill_rig_sim/RigTruth.h"
#include "known_string.h"
#include "rviz/picture/coloring.h"

using drill_rig_sim::Color;
using drill_rig_sim::ColorScale;
using drill_rig_sim::ControllerStatus;
using drill_rig_sim::DrillstringState;
using drill_rig_sim::RigDescription;
using drill_rig_sim::RigTruth;
using namespace known_string;

namespace
{
constexpr double patience = 60.0;  // wall seconds that anything may take on a loaded machine
constexpr int width = 800, height = 700;

QString out_folder()
{
  const char* const home = std::getenv("ROS_HOME");
  return QFileInfo(home != nullptr ? home : "/tmp/x").path();
}
}  // namespace

/// A view with the display, that hears what is sent here. One for all tests: rviz has one in a process.
class Display : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    node_ = std::make_unique<ros::NodeHandle>("/shown");
    frames_ = std::make_unique<tf2_ros::StaticTransformBroadcaster>();
    description_ = node_->advertise<RigDescription>("rig_description", 1, true);
    path_ = node_->advertise<nav_msgs::Path>("trajectory", 1, true);
    string_ = node_->advertise<DrillstringState>("drillstring_state", 1);
    truth_ = node_->advertise<RigTruth>("truth/rig_state", 1);
    panel_ = std::make_unique<rviz::RenderPanel>();
    geometry_msgs::TransformStamped floor;
    floor.header.frame_id = "world";
    floor.child_frame_id = "rig_floor";
    floor.transform.rotation.w = 1.0;
    frames_->sendTransform(floor);
    description_.publish(description());
    path_.publish(path());
    panel_->resize(width, height);
    panel_->show();
    manager_ = std::make_unique<rviz::VisualizationManager>(panel_.get());
    panel_->initialize(manager_->getSceneManager(), manager_.get());
    manager_->initialize();
    manager_->setFixedFrame("rig_floor");
    manager_->startUpdate();
    display_ = manager_->createDisplay("drill_rig_sim/Drillstring", "Drillstring", true);
    display_->subProp("Topic")->setValue("/shown/drillstring_state");
    manager_->getToolManager()->setCurrentTool(manager_->getToolManager()->addTool("drill_rig_sim/Probe"));
  }
  static void TearDownTestSuite()
  {
    manager_.reset();
    panel_.reset();
    for (ros::Publisher* publisher : {&description_, &path_, &string_, &truth_}) publisher->shutdown();
    frames_.reset();
    node_.reset();
  }
  void SetUp() override
  {
    look_at(depth - 300.0);
    ASSERT_TRUE(wait_until([&] { return !status("Colours").isEmpty(); }));
  }

  /// From the north, level, at the string's place of this measured depth.
  void look_at(double md)
  {
    rviz::ViewController* view = manager_->getViewManager()->getCurrent();
    dynamic_cast<rviz::VectorProperty*>(view->subProp("Focal Point"))
        ->setVector(Ogre::Vector3(0.0f, 0.0f, static_cast<float>(-md)));
    view->subProp("Distance")->setValue(40.0f);
    view->subProp("Pitch")->setValue(0.0f);
    view->subProp("Yaw")->setValue(1.5708f);
  }

  /// Sends the string ten times a second while it handles events, until the condition is true.
  bool wait_until(const std::function<bool()>& condition, double seconds = patience)
  {
    QElapsedTimer since;
    since.start();
    while (!condition())
    {
      if (since.elapsed() > 1e3 * seconds) return false;
      string_.publish(string(deeper_));
      truth_.publish(faults_);
      QTest::qWait(100);
    }
    return true;
  }

  /// What a status of the display says; empty: there is none.
  QString status(const QString& name)
  {
    for (int i = 0; i < display_->numChildren(); ++i)
      if (auto* list = qobject_cast<rviz::StatusList*>(display_->childAt(i)))
        for (int k = 0; k < list->numChildren(); ++k)
          if (list->childAt(k)->getName() == name) return list->childAt(k)->getValue().toString();
    return {};
  }

  QImage picture(const QString& name)
  {
    QImage image = QGuiApplication::primaryScreen()->grabWindow(panel_->winId()).toImage();
    image.save(out_folder() + "/display_values_" + name + ".png");
    return image;
  }

  void click(const QPoint& at) { QTest::mouseClick(panel_.get(), Qt::LeftButton, Qt::NoModifier, at); }

  inline static std::unique_ptr<ros::NodeHandle> node_;
  inline static std::unique_ptr<tf2_ros::StaticTransformBroadcaster> frames_;
  inline static ros::Publisher description_, path_, string_, truth_;
  inline static RigTruth faults_;  // that are sent with the string
  inline static std::unique_ptr<rviz::RenderPanel> panel_;
  inline static std::unique_ptr<rviz::VisualizationManager> manager_;
  inline static rviz::Display* display_ = nullptr;
  inline static double deeper_ = 0.0;  // the bit [m]
};

TEST_F(Display, ProbeShowsTheNumbersOfThePlaceThatIsClickedOn)
{
  const QPoint middle(width / 2, height / 2);
  EXPECT_EQ("", status("Probe"));
  const auto shows = [&](const QString& wanted)
  { return wait_until([&] { return click(middle), QTest::qWait(100), status("Probe").startsWith(wanted); }); };
  // half a pixel is 0.03 m there
  ASSERT_TRUE(shows("pipe: measured depth")) << status("Probe").toStdString();
  const QStringList said = status("Probe").split(", ");
  ASSERT_EQ(11, said.size()) << status("Probe").toStdString();
  const auto value = [&](int i, const char* what, const char* unit)
  {
    EXPECT_TRUE(said[i].contains(what) && said[i].endsWith(unit)) << said[i].toStdString();
    return said[i].section(what, 1).section(' ', 1, 1).toDouble();
  };
  const double from_bit = value(1, "from the bit", " m");
  EXPECT_NEAR(300.0, from_bit, 0.1);
  EXPECT_NEAR(depth - from_bit, value(0, "measured depth", " m"), 0.011);
  EXPECT_NEAR(from_bit, value(2, "tension", " kN"), 0.06);
  EXPECT_NEAR(-3.0 + 0.015 * from_bit, value(3, "torque", " kN m"), 0.006);
  EXPECT_NEAR(4e-3 * from_bit, value(4, "bending moment", " kN m"), 0.006);
  EXPECT_NEAR(0.15 * from_bit, value(5, "bending stress", " MPa"), 0.06);
  EXPECT_NEAR(7e-5 * from_bit, value(6, "contact force", " kN/m"), 0.0006);
  EXPECT_EQ("its side 90 deg", said[7]);
  EXPECT_NEAR(0.12 * from_bit, value(8, "spin", " rpm"), 0.06);
  EXPECT_NEAR(8e-4 * from_bit, value(9, "buckling", ""), 0.006);
  EXPECT_EQ("modelled free", said[10]);
  picture("probe");
  // another place, in another part and modelled otherwise
  look_at(950.0);
  QTest::qWait(500);
  EXPECT_TRUE(shows("collar: measured depth 9")) << status("Probe").toStdString();
  look_at(200.0);
  QTest::qWait(500);
  ASSERT_TRUE(shows("pipe: measured depth")) << status("Probe").toStdString();
  EXPECT_TRUE(status("Probe").endsWith("modelled guided")) << status("Probe").toStdString();
  // beside it: none
  click(QPoint(20, height / 2));
  EXPECT_TRUE(wait_until([&] { return status("Probe").isEmpty(); })) << status("Probe").toStdString();
}

TEST_F(Display, EveryColouringHasItsUnitScaleAndColour)
{
  const struct
  {
    const char *name, *legend;
    double value, low, high;  // value: at the middle of the picture
  } all[] = {{"tension", "tension [kN], 0 to 1000", 300.0, 0.0, 1000.0},
             {"torque", "torque [kN m], -5 to 20", 1.5, -5.0, 20.0},
             {"bending stress", "bending stress [MPa], 0 to 200", 45.0, 0.0, 200.0},
             {"contact force", "contact force [kN/m], 0 to 0.1", 0.021, 0.0, 0.1},
             {"spin speed", "spin speed [rpm], 0 to 200", 36.0, 0.0, 200.0},
             {"buckling factor", "buckling factor [1: buckles], 0 to 1", 0.24, 0.0, 1.0},
             {"level of model", "level of model: free in all directions, guided by the hole", 0.0, 0.0, 1.0}};
  for (const auto& one : all)
  {
    display_->subProp("Coloured by")->setValue(one.name);
    EXPECT_TRUE(wait_until([&] { return status("Colours") == one.legend; }))
        << one.name << ": " << status("Colours").toStdString();
    wait_until([] { return false; }, 1.0);
    const QColor seen = picture(QString(one.name).replace(' ', '_')).pixelColor(width / 2, height / 2);
    const Color wanted =
        QString(one.name) == "level of model" ? drill_rig_sim::level_color(0.0) : ColorScale(one.low, one.high).at(one.value);
    // light makes all three darker alike
    const float most = std::max({wanted.r, wanted.g, wanted.b});
    const double most_seen = std::max({seen.redF(), seen.greenF(), seen.blueF()});
    ASSERT_GT(most_seen, 0.2) << one.name;
    EXPECT_NEAR(wanted.r / most, seen.redF() / most_seen, 0.05) << one.name;
    EXPECT_NEAR(wanted.g / most, seen.greenF() / most_seen, 0.05) << one.name;
    EXPECT_NEAR(wanted.b / most, seen.blueF() / most_seen, 0.05) << one.name;
  }
}

// The hole comes once a second, the string ten times: the bit may have come here before the hole that it has drilled.
TEST_F(Display, TheBitIsNeverOutsideItsHole)
{
  display_->subProp("Coloured by")->setValue("tension");
  deeper_ = 1.25;  // than the path, by 0.25 m
  EXPECT_TRUE(wait_until([&] { return status("Legend").contains("hole 1001.25 m"); })) << status("Legend").toStdString();
  EXPECT_TRUE(status("Legend").contains("bit 1001.25 m")) << status("Legend").toStdString();
  deeper_ = 0.0;
}

TEST_F(Display, FaultsAreDrawnAtTheirDepthAndListed)
{
  const auto red = [](const QImage& image, int from, int to)  // pixels of the marks in these rows
  {
    int count = 0;
    for (int y = from; y < to; ++y)
      for (int x = 0; x < image.width(); ++x)
      {
        const QColor c = image.pixelColor(x, y);
        count += c.red() > 200 && c.green() > 70 && c.green() < 140 && c.blue() > 50 && c.blue() < 125;
      }
    return count;
  };
  display_->subProp("Coloured by")->setValue("tension");
  wait_until([] { return false; }, 1.0);
  EXPECT_EQ(0, red(picture("no_fault"), 0, height));
  faults_.active_faults = {"stuck_pipe", "pump_trip"};
  faults_.active_fault_depths = {depth - 300.0, NAN};  // at the middle of the picture
  ASSERT_TRUE(wait_until([&] { return status("Legend").contains("! stuck pipe 700.00 m, ! pump trip , bit"); }))
      << status("Legend").toStdString();
  EXPECT_TRUE(wait_until([&] { return red(picture("fault"), height / 2 - 15, height / 2 + 15) > 100; }));
  const QImage seen = picture("fault");
  EXPECT_EQ(0, red(seen, 0, height / 2 - 30) + red(seen, height / 2 + 30, height)) << "and nowhere else";
  faults_ = RigTruth();
  EXPECT_TRUE(wait_until([&] { return red(picture("no_fault"), 0, height) == 0 && !status("Legend").contains("!"); }));
}

TEST_F(Display, TheLawThatCommandsTheRigIsShownWithItsPlan)
{
  ros::Publisher law = node_->advertise<ControllerStatus>("controller/status", 1, true);
  ControllerStatus m;
  m.header.frame_id = "rig_floor";
  m.law = "slide_steering";
  m.running = true;
  m.phase = "drilling";
  m.leads = "weight";
  m.set_point = {"weight", "rop", "some_other"};
  m.value = {60e3, 0.01, 5.0};
  m.plan.resize(2);
  m.plan[1].x = 12.0;  // beside the hole, down to its bottom
  m.plan[0].x = 12.0;
  m.plan[1].z = -depth - 50.0;
  law.publish(m);
  ASSERT_TRUE(wait_until([&] { return status("Legend").contains("slide steering drilling"); })) << status("Legend").toStdString();
  EXPECT_TRUE(status("Legend").contains("> WOB 60.0 kN,   ROP 36.00 m/h")) << status("Legend").toStdString();
  EXPECT_TRUE(wait_until([&] { return status("Legend").contains("off the plan 12.00 m"); })) << status("Legend").toStdString();
  picture("law");
  m.running = false;
  law.publish(m);
  EXPECT_TRUE(wait_until([&] { return !status("Legend").contains("WOB") && !status("Legend").contains("plan"); }));
  m.running = true;
  law.publish(m);
  ASSERT_TRUE(wait_until([&] { return status("Legend").contains("WOB"); }));
  law.shutdown();  // as when its node is killed
  EXPECT_TRUE(wait_until([&] { return !status("Legend").contains("WOB"); })) << status("Legend").toStdString();
}

TEST_F(Display, LegendRulerAndProbeAreInTheUnitsThatAreChosen)
{
  display_->subProp("Coloured by")->setValue("tension");
  EXPECT_TRUE(wait_until([&] { return status("Colours") == "tension [kN], 0 to 1000"; })) << status("Colours").toStdString();
  display_->subProp("Units")->setValue("oilfield");
  EXPECT_TRUE(wait_until([&] { return status("Colours") == "tension [klbf], 0 to 250"; })) << status("Colours").toStdString();
  EXPECT_TRUE(wait_until([&] { return status("Legend").contains("bit 3280.84 ft"); })) << status("Legend").toStdString();
  EXPECT_TRUE(status("Legend").contains(" klbf/ft")) << status("Legend").toStdString();
  EXPECT_FALSE(status("Legend").contains(" m")) << status("Legend").toStdString();
  EXPECT_TRUE(wait_until(
      [&] {
        return click(QPoint(width / 2, height / 2)), QTest::qWait(100), status("Probe").startsWith("pipe: measured depth 229");
      }))
      << status("Probe").toStdString();
  EXPECT_TRUE(status("Probe").contains(" klbf, torque ")) << status("Probe").toStdString();
  picture("oilfield");
  display_->subProp("Units")->setValue("as the console");
  EXPECT_TRUE(wait_until([&] { return status("Colours") == "tension [kN], 0 to 1000"; })) << "without a console SI";
  click(QPoint(20, height / 2));
}

TEST_F(Display, TheLegendGivesWayToTheBit)
{
  const auto has_legend = [&](int x)
  {
    const QColor seen = picture("legend").pixelColor(x, 13);
    return seen.red() < 40 && seen.green() < 40 && seen.blue() < 45;
  };
  EXPECT_TRUE(wait_until([&] { return has_legend(width - 20) && !has_legend(20); }));
  rviz::ViewController* view = manager_->getViewManager()->getCurrent();
  auto* focus = dynamic_cast<rviz::VectorProperty*>(view->subProp("Focal Point"));
  focus->setVector(Ogre::Vector3(13.0f, 0.0f, static_cast<float>(-depth - 10.0)));  // the bit above to the right
  EXPECT_TRUE(wait_until([&] { return has_legend(20) && !has_legend(width - 20); }));
  focus->setVector(Ogre::Vector3(-13.0f, 0.0f, static_cast<float>(-depth - 10.0)));
  EXPECT_TRUE(wait_until([&] { return has_legend(width - 20) && !has_legend(20); }));
}

// As when rviz is begun with a config and another fixed frame, -f.
TEST_F(Display, ACameraThatWaitsIsNotForgottenForAnotherFixedFrame)
{
  display_->subProp("Camera")->setValue("bit");
  manager_->setFixedFrame("world");
  auto* focus = dynamic_cast<rviz::VectorProperty*>(manager_->getViewManager()->getCurrent()->subProp("Focal Point"));
  EXPECT_TRUE(wait_until([&] { return std::abs(focus->getVector().z + depth) < 10.0f; })) << focus->getVector().z;
  display_->subProp("Camera")->setValue("as it is");
  manager_->setFixedFrame("rig_floor");
}

int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_display", ros::init_options::AnonymousName | ros::init_options::NoSigintHandler);
  ros::NodeHandle node;
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
