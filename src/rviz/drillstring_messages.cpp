// SPDX-License-Identifier: BSD-3-Clause
#include "drillstring_messages.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
Eigen::Vector3d to_vector(const geometry_msgs::Point& p)
{
  return {p.x, p.y, p.z};
}

std::vector<Eigen::Vector3d> to_vectors(const std::vector<geometry_msgs::Point>& points)
{
  std::vector<Eigen::Vector3d> result;
  result.reserve(points.size());
  for (const geometry_msgs::Point& p : points) result.push_back(to_vector(p));
  return result;
}

Eigen::Quaterniond to_eigen(const geometry_msgs::Quaternion& q)
{
  return {q.w, q.x, q.y, q.z};
}

double entry(const std::vector<double>& values, std::size_t i)
{
  return i < values.size() ? values[i] : std::nan("");
}
}  // namespace

StringData to_string_data(const DrillstringState& m)
{
  StringData d;
  d.md = m.md;
  d.from_bit = m.from_bit;
  d.tension = m.tension;
  d.torque = m.torque;
  d.bending_moment = m.bending_moment;
  d.bending_stress = m.bending_stress;
  d.contact_force = m.contact_force;
  d.contact_side = m.contact_side;
  d.spin_speed = m.spin_speed;
  d.buckling = m.buckling_factor;
  d.guided.assign(m.guided.begin(), m.guided.end());
  d.position = to_vectors(m.position);
  return d;
}

RigData to_rig_data(const RigDescription& m)
{
  RigData d;
  for (std::size_t i = 0; i < m.part_name.size(); ++i)
  {
    PartData part;
    part.name = m.part_name[i];
    part.kind = i < m.part_type.size() ? static_cast<PartKind>(m.part_type[i]) : PartKind::collar;
    part.length = entry(m.part_length, i);
    part.joint_length = entry(m.part_joint_length, i);
    part.radius = 0.5 * entry(m.part_diameter, i);
    part.widest = 0.5 * entry(m.part_widest, i);
    d.parts.push_back(part);
  }
  d.bend = m.bend;
  d.bit_to_bend = m.bit_to_bend;
  d.bit_to_sleeve = m.bit_to_sleeve;
  d.section_bottom = m.section_bottom;
  for (const double diameter : m.section_diameter) d.section_radius.push_back(0.5 * diameter);
  d.layer_base = m.layer_base;
  d.station_md = m.station_md;
  d.stations = to_vectors(m.station);
  d.plan = to_vectors(m.plan);
  d.crown_height = m.crown_height;
  d.sheaves = m.sheaves;
  return d;
}

std::vector<DrawnRig::Fault> to_faults(const RigTruth& m)
{
  std::vector<DrawnRig::Fault> faults;
  for (std::size_t i = 0; i < m.active_faults.size(); ++i)
  {
    std::string name = m.active_faults[i];
    std::replace(name.begin(), name.end(), '_', ' ');
    faults.push_back({name, i < m.active_fault_depths.size() ? m.active_fault_depths[i] : NAN});
  }
  return faults;
}

std::optional<DrawnRig::Law> to_law(const ControllerStatus& m)
{
  if (!m.running) return std::nullopt;
  DrawnRig::Law law{m.law, m.phase, m.leads, {}, to_vectors(m.plan)};
  std::replace(law.name.begin(), law.name.end(), '_', ' ');
  for (std::size_t i = 0; i < std::min(m.set_point.size(), m.value.size()); ++i)
    law.set_points.emplace_back(m.set_point[i], m.value[i]);
  if (!std::all_of(law.plan.begin(), law.plan.end(), [](const Eigen::Vector3d& p) { return p.allFinite(); })) law.plan.clear();
  return law;
}

std::string problem_of(const nav_msgs::Path& m)
{
  if (m.poses.empty()) return "the path has no place";
  for (const geometry_msgs::PoseStamped& p : m.poses)
  {
    const double norm = to_eigen(p.pose.orientation).norm();
    if (!to_vector(p.pose.position).allFinite() || !std::isfinite(norm) || norm < 1e-6)
      return "the path holds a pose that is not finite";
  }
  return {};
}

HoleAxis to_hole_axis(const nav_msgs::Path& m)
{
  std::vector<Eigen::Vector3d> points, tangents;
  for (const geometry_msgs::PoseStamped& p : m.poses)
  {
    points.push_back(to_vector(p.pose.position));
    tangents.push_back(to_eigen(p.pose.orientation).normalized() * Eigen::Vector3d::UnitX());
  }
  return {points, tangents};
}

}  // namespace drill_rig_sim
