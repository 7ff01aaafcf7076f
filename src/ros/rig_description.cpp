// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/rig_description.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/well/survey.h"

namespace drill_rig_sim
{
namespace
{
constexpr double plan_spacing = 10.0;  // most between points of the planned path [m]

std::uint8_t to_type(PartType type)
{
  switch (type)
  {
    case PartType::bit:
      return RigDescription::BIT;
    case PartType::mud_motor:
      return RigDescription::MUD_MOTOR;
    case PartType::collar:
      return RigDescription::COLLAR;
    case PartType::stabilizer:
      return RigDescription::STABILIZER;
    case PartType::mwd:
      return RigDescription::MWD;
    case PartType::pipe:
      return RigDescription::PIPE;
    case PartType::rotary_steerable:
      return RigDescription::ROTARY_STEERABLE;
  }
  return RigDescription::COLLAR;
}

double widest(const PartSpec& part)
{
  double diameter = part.outer_diameter;
  if (part.bit) diameter = part.bit->diameter;
  if (part.motor) diameter = std::max(diameter, part.motor->sleeve_diameter);
  if (part.stabilizer) diameter = std::max(diameter, part.stabilizer->blade_diameter);
  if (part.pipe) diameter = std::max(diameter, part.pipe->tool_joint_diameter);
  return diameter;
}

void add_part(const PartSpec& part, RigDescription& m)
{
  m.part_name.push_back(part.name);
  m.part_type.push_back(to_type(part.type));
  m.part_length.push_back(part.joints == 0 ? 0.0 : part.joints == 1 ? part.length : part.joints * part.joint_length);
  m.part_joint_length.push_back(part.joint_length > 0.0 ? part.joint_length : part.length);
  m.part_diameter.push_back(part.bit ? part.bit->diameter : part.outer_diameter);
  m.part_bore.push_back(part.bit ? 0.0 : part.inner_diameter);
  m.part_widest.push_back(widest(part));
  if (!part.motor) return;
  m.bend = part.motor->bend;
  m.bit_to_bend = part.motor->bit_to_bend;
  m.bit_to_sleeve = part.motor->sleeve_diameter > 0.0 ? part.motor->bit_to_sleeve : 0.0;
}

void add_plan(const WellSpec& well, RigDescription& m)
{
  const Survey survey(well.survey);
  for (int i = 0; i < survey.size(); ++i)
  {
    const PathPoint& station = survey.station(i);
    if (i > 0)
    {
      const double from = survey.station(i - 1).md, length = station.md - from;
      const int pieces = std::max(1, static_cast<int>(std::ceil(length / plan_spacing)));
      for (int k = 1; k < pieces; ++k) m.plan.push_back(to_point(survey.at(from + length * k / pieces).position));
    }
    m.plan.push_back(to_point(station.position));
    m.station.push_back(to_point(station.position));
    m.station_md.push_back(station.md);
  }
}
}  // namespace

RigDescription to_rig_description(const Scene& scene, const std_msgs::Header& header)
{
  RigDescription m;
  m.header = header;
  for (const PartSpec& part : scene.string) add_part(part, m);
  for (const HoleSection& section : scene.well.sections)
  {
    m.section_bottom.push_back(section.to);
    m.section_diameter.push_back(section.diameter);
  }
  for (const FormationLayer& layer : scene.formation)
  {
    m.layer_base.push_back(layer.to_tvd);
    m.layer_drillability.push_back(layer.drillability);
  }
  add_plan(scene.well, m);
  m.crown_height = scene.rig.hoisting.crown_height;
  m.sheaves = scene.rig.hoisting.sheaves;
  return m;
}

}  // namespace drill_rig_sim
