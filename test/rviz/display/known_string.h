// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_RVIZ_DISPLAY_KNOWN_STRING_H
#define DRILL_RIG_SIM_TEST_RVIZ_DISPLAY_KNOWN_STRING_H

#include <nav_msgs/Path.h>

#include <cmath>

#include "drill_rig_sim/DrillstringState.h"
#include "drill_rig_sim/RigDescription.h"

/// A string whose numbers are known: vertical, hung at the table, its bit at 1000 m; along it every number grows steadily with
/// the distance from the bit.
namespace known_string
{
using drill_rig_sim::DrillstringState;
using drill_rig_sim::RigDescription;

constexpr double depth = 1000.0, spacing = 10.0, rpm = 2.0 * M_PI / 60.0;

/// `deeper`: than 1000 m [m].
inline DrillstringState string(double deeper)
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

inline RigDescription description()
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

inline nav_msgs::Path path()
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

}  // namespace known_string

#endif
