// SPDX-License-Identifier: BSD-3-Clause
// The URDF of a rig: a link for each frame, joints that robot_state_publisher leaves alone.
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <set>
#include <string>

#include "drill_rig_sim/ros/robot_description.h"
#include "test_scenes.h"

namespace drill_rig_sim::test_ros_robot_description
{
namespace
{
const tinyxml2::XMLElement* robot(const Scene& scene, const std::string& prefix, tinyxml2::XMLDocument& document)
{
  EXPECT_EQ(document.Parse(robot_description(scene, prefix).c_str()), tinyxml2::XML_SUCCESS);
  return document.RootElement();
}

std::set<std::string> names_of(const tinyxml2::XMLElement& robot, const char* element)
{
  std::set<std::string> names;
  for (const auto* e = robot.FirstChildElement(element); e != nullptr; e = e->NextSiblingElement(element))
    names.insert(e->Attribute("name"));
  return names;
}
}  // namespace

TEST(RobotDescription, hasALinkForEachFrameButPipe)
{
  const Scene scene = drilling_scene(0.005);
  tinyxml2::XMLDocument document;
  const auto* top = robot(scene, "a/", document);
  std::set<std::string> links = {"a/rig_floor", "a/traveling_block", "a/top_drive"};
  for (const PartSpec& part : scene.string)
    if (part.type != PartType::pipe) links.insert("a/" + part.name);
  EXPECT_EQ(names_of(*top, "link"), links);
}

TEST(RobotDescription, hangsAllFramesOnTheFloorByFloatingJoints)
{
  tinyxml2::XMLDocument document;
  const auto* top = robot(drilling_scene(0.005), "", document);
  std::set<std::string> children;
  for (const auto* joint = top->FirstChildElement("joint"); joint != nullptr; joint = joint->NextSiblingElement("joint"))
  {
    EXPECT_STREQ(joint->Attribute("type"), "floating");
    EXPECT_STREQ(joint->FirstChildElement("parent")->Attribute("link"), "rig_floor");
    children.insert(joint->FirstChildElement("child")->Attribute("link"));
  }
  children.insert("rig_floor");
  EXPECT_EQ(children, names_of(*top, "link"));
}

TEST(RobotDescription, drawsAPartFromItsLowerEndUp)
{
  const Scene scene = drilling_scene(0.005);
  tinyxml2::XMLDocument document;
  const auto* top = robot(scene, "", document);
  const PartSpec& bit = scene.string.front();
  for (const auto* link = top->FirstChildElement("link"); link != nullptr; link = link->NextSiblingElement("link"))
  {
    if (bit.name != link->Attribute("name")) continue;
    const auto* visual = link->FirstChildElement("visual");
    const auto* cylinder = visual->FirstChildElement("geometry")->FirstChildElement("cylinder");
    EXPECT_NEAR(cylinder->DoubleAttribute("radius"), 0.5 * bit.bit->diameter, 1e-6);
    EXPECT_NEAR(cylinder->DoubleAttribute("length"), bit.length, 1e-6);
    EXPECT_NEAR(std::stod(visual->FirstChildElement("origin")->Attribute("xyz")), -0.5 * bit.length, 1e-5)
        << "x is towards the bit";
  }
}
}  // namespace drill_rig_sim::test_ros_robot_description
