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

#include "drill_rig_sim/DrillstringState.h"
#include "drill_rig_sim/RigDescription.h"
#include "rviz/picture/coloring.h"

using drill_rig_sim::Color;
using drill_rig_sim::ColorScale;
using drill_rig_sim::DrillstringState;
using drill_rig_sim::RigDescription;

namespace
{
constexpr double patience = 60.0;  // wall seconds that anything may take on a loaded machine
constexpr double depth = 1000.0, spacing = 10.0, rpm = 2.0 * M_PI / 60.0;
constexpr int width = 800, height = 700;

/// `deeper`: than 1000 m [m].
DrillstringState string(double deeper)
{
  DrillstringState m;
  m.header.frame_id = "rig_floor";
  for (double from_bit = 0.0; from_bit <= depth; from_bit += spacing)
  {
    m.from_bit.push_back(from_bit);
    m.md.push_back(depth + deeper - from_bit);
    m.position.emplace_back();
    m.position.back().z = from_bit - depth - deeper;
    m.tension.push_back(1e3 * from_bit);
    m.true_axial_force.push_back(0.0);
    m.torque.push_back(-3e3 + 15.0 * from_bit);
    m.bending_moment.push_back(4.0 * from_bit);
    m.bending_stress.push_back(1.5e5 * from_bit);
    m.contact_force.push_back(0.7 * from_bit);
    m.contact_side.push_back(0.5 * M_PI);
    m.spin_speed.push_back(0.12 * rpm * from_bit);
    m.buckling_factor.push_back(8e-4 * from_bit);
    m.guided.push_back(from_bit >= 500.0);
  }
  return m;
}

RigDescription description()
{
  RigDescription m;
  m.header.frame_id = "rig_floor";
  m.part_name = {"bit", "collar", "pipe"};
  m.part_type = {RigDescription::BIT, RigDescription::COLLAR, RigDescription::PIPE};
  m.part_length = {0.3, 99.7, 0.0};
  m.part_joint_length = {0.3, 9.97, 9.5};
  m.part_diameter = {0.2159, 0.165, 0.127};
  m.part_bore = {0.0, 0.07, 0.1};
  m.part_widest = {0.2159, 0.165, 0.168};
  m.section_bottom = {2000.0};
  m.section_diameter = {0.2159};
  m.layer_base = {5000.0};
  m.layer_drillability = {1e-8};
  m.crown_height = 46.0;
  m.sheaves = 6;
  return m;
}

nav_msgs::Path path()
{
  nav_msgs::Path m;
  m.header.frame_id = "rig_floor";
  for (double md = 0.0; md <= depth + 1.0; md += 1.0)
  {
    m.poses.emplace_back();
    m.poses.back().pose.position.z = -md;
    m.poses.back().pose.orientation.y = m.poses.back().pose.orientation.w = std::sqrt(0.5);  // x axis down
  }
  return m;
}

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
    for (ros::Publisher* publisher : {&description_, &path_, &string_}) publisher->shutdown();
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
  inline static ros::Publisher description_, path_, string_;
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
