// SPDX-License-Identifier: BSD-3-Clause
// What displays receive of a scene, against the scene.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/ros/rig_description.h"
#include "test_scenes.h"

namespace drill_rig_sim::test_ros_rig_description
{
namespace
{
RigDescription described(const Scene& scene)
{
  std_msgs::Header header;
  header.frame_id = "rig_b/rig_floor";
  return to_rig_description(scene, header);
}
}  // namespace

TEST(RigDescriptionMessage, hasEachPartAsTheSceneHasIt)
{
  Scene scene = vertical_scene(200.0, 150.0);
  PartSpec blades = collar_part(1, 1.8);
  blades.type = PartType::stabilizer;
  blades.length = 1.8;
  blades.stabilizer.emplace();
  blades.stabilizer->blade_diameter = 0.21;
  scene.string = {bit_part(0.2159), blades, collar_part(2, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
  const RigDescription m = described(scene);
  EXPECT_EQ("rig_b/rig_floor", m.header.frame_id);
  EXPECT_EQ((std::vector<std::string>{"bit", "collar", "collar", "pipe"}), m.part_name);
  EXPECT_EQ(
      (std::vector<std::uint8_t>{RigDescription::BIT, RigDescription::STABILIZER, RigDescription::COLLAR, RigDescription::PIPE}),
      m.part_type);
  EXPECT_EQ((std::vector<double>{0.3, 1.8, 18.8, 0.0}), m.part_length);
  EXPECT_EQ((std::vector<double>{0.3, 1.8, 9.4, 9.5}), m.part_joint_length);
  EXPECT_EQ((std::vector<double>{0.2159, 0.165, 0.165, 0.127}), m.part_diameter);
  EXPECT_EQ((std::vector<double>{0.0, 0.0714, 0.0714, 0.1086}), m.part_bore);
  EXPECT_EQ((std::vector<double>{0.2159, 0.21, 0.165, 0.168}), m.part_widest);
  EXPECT_EQ(0.0, m.bend);
  EXPECT_EQ(scene.rig.hoisting.crown_height, m.crown_height);
  EXPECT_EQ(scene.rig.hoisting.sheaves, m.sheaves);
}

TEST(RigDescriptionMessage, plansByTheSurveyAPointEveryTenMetres)
{
  Scene scene = vertical_scene(200.0, 150.0);
  const double down = 0.0, level = pi / 2.0;
  scene.well.survey = {{0.0, down, 0.0}, {100.0, down, 0.0}, {100.0 + 150.0 * pi, level, 0.0}};  // a quarter of a circle of 300 m
  scene.well.sections = {{60.0, 0.3, 0.2}, {900.0, 0.25, 0.2}};
  const RigDescription m = described(scene);
  ASSERT_EQ(3u, m.station.size());
  EXPECT_EQ(100.0, m.station_md[1]);
  EXPECT_NEAR(300.0, m.station[2].y, 1e-9);
  EXPECT_NEAR(-400.0, m.station[2].z, 1e-9);
  EXPECT_EQ(11u + 48u, m.plan.size());
  for (std::size_t i = 11; i < m.plan.size(); ++i)
    EXPECT_NEAR(300.0, std::hypot(m.plan[i].y - 300.0, m.plan[i].z + 100.0), 1e-9) << i;
  EXPECT_EQ((std::vector<double>{60.0, 900.0}), m.section_bottom);
  EXPECT_EQ((std::vector<double>{0.3, 0.25}), m.section_diameter);
  EXPECT_EQ(scene.formation.size(), m.layer_base.size());
}

}  // namespace drill_rig_sim::test_ros_rig_description
