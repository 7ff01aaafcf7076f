#include "check_scene.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace drill_rig_sim
{
namespace
{
std::string item(const char* list, std::size_t index, const char* key = "")
{
  return std::string(list) + "[" + std::to_string(index) + "]" + (key[0] ? "." : "") + key;
}

std::string metres(double value)
{
  return plain(value) + " m";
}

void check_well(const WellSpec& well, Problems& problems)
{
  const double last = well.survey.back().md;
  if (well.hole_depth > last)
  {
    problems.add("well.hole_depth",
                 metres(well.hole_depth) + " is deeper than the survey, allowed: up to its last station, " + metres(last));
  }
  if (well.sections.empty()) return problems.add("well.sections", "the list is empty, needed: at least one section");
  for (std::size_t i = 1; i < well.sections.size(); ++i)
  {
    if (well.sections[i].to > well.sections[i - 1].to) continue;
    problems.add(item("well.sections", i, "to"), metres(well.sections[i].to) + " does not exceed the " +
                                                     metres(well.sections[i - 1].to) + " of the section above it");
  }
  if (well.sections.back().to < std::min(well.hole_depth, last))
  {
    problems.add(item("well.sections", well.sections.size() - 1, "to"),
                 "the last section ends at " + metres(well.sections.back().to) + ", needed: down to hole_depth, " +
                     metres(well.hole_depth));
  }
}

void check_formation(const std::vector<FormationLayer>& layers, Problems& problems)
{
  if (layers.empty()) problems.add("formation", "the list is empty, needed: at least one layer");
  for (std::size_t i = 1; i < layers.size(); ++i)
  {
    if (layers[i].to_tvd > layers[i - 1].to_tvd) continue;
    problems.add(item("formation", i, "to_tvd"),
                 metres(layers[i].to_tvd) + " does not exceed the " + metres(layers[i - 1].to_tvd) + " of the layer above it");
  }
}

// names become frames of the transform tree
void check_part_names(const std::vector<PartSpec>& parts, Problems& problems)
{
  const std::set<std::string> reserved = {"rig_floor", "world", "map", "traveling_block", "top_drive"};
  std::set<std::string> seen;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const std::string& name = parts[i].name;
    const std::string path = item("string", i, "name");
    const bool spelled = std::all_of(
        name.begin(), name.end(),
        [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; });
    if (!spelled) problems.add(path, "'" + name + "' is no name, allowed: letters, digits and _");
    if (reserved.count(name) || name.rfind("pipe_", 0) == 0)
      problems.add(path, "'" + name + "' is taken by a frame of the rig, choose another");
    if (!seen.insert(name).second) problems.add(path, "'" + name + "' names two parts, needed: unique names");
  }
}

void check_part_kinds(const std::vector<PartSpec>& parts, Problems& problems)
{
  if (parts.empty()) return problems.add("string", "the list is empty, needed: at least a bit and a pipe");
  if (parts.front().type != PartType::bit)
    problems.add(item("string", 0, "type"), "the first part is no bit, needed: parts from the bit up");
  if (parts.back().type == PartType::bit)
    problems.add("string", "there is nothing above the bit, needed: at least one pipe or collar");
  int motors = 0, surveyors = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    motors += parts[i].type == PartType::mud_motor ? 1 : 0;
    surveyors += parts[i].type == PartType::mwd ? 1 : 0;
    if (i > 0 && parts[i].type == PartType::bit) problems.add(item("string", i, "type"), "a second bit, allowed: one");
    if (parts[i].type == PartType::mud_motor && motors == 2)
      problems.add(item("string", i, "type"), "a second mud motor, allowed: one");
    if (parts[i].type == PartType::mwd && surveyors == 2) problems.add(item("string", i, "type"), "a second mwd, allowed: one");
    if (parts[i].joints == 0 && i + 1 < parts.size())
    {
      problems.add(item("string", i, "joints"), "`fill` is not the string's last part, allowed: on the last part only");
    }
  }
}

struct Width
{
  const char* key;
  double diameter;
};

// the widest place of a part
Width widest(const PartSpec& part)
{
  Width width{"outer_diameter", part.outer_diameter};
  for (const Width& other : {Width{"tool_joint_diameter", part.tool_joint_diameter}, Width{"blade_diameter", part.blade_diameter},
                             Width{"diameter", part.diameter}})
  {
    if (other.diameter > width.diameter) width = other;
  }
  return width;
}

void check_diameters(const Scene& scene, Problems& problems)
{
  // every part passes the sections above the bit on its way down
  double narrowest = 1e9;
  double top = 0.0;
  for (const HoleSection& section : scene.well.sections)
  {
    if (top < scene.start.bit_depth) narrowest = std::min(narrowest, section.diameter);
    top = section.to;
  }
  for (std::size_t i = 0; i < scene.string.size(); ++i)
  {
    const PartSpec& part = scene.string[i];
    const Width width = widest(part);
    if (width.diameter > narrowest)
    {
      problems.add(
          item("string", i, width.key),
          metres(width.diameter) + " does not pass the hole, allowed: up to its narrowest section, " + metres(narrowest));
    }
    else if (i > 0 && scene.string[0].type == PartType::bit && width.diameter > scene.string[0].diameter)
    {
      problems.add(item("string", i, width.key), metres(width.diameter) +
                                                     " does not fit the hole that the bit drills, allowed: up to " +
                                                     metres(scene.string[0].diameter));
    }
    if (part.type == PartType::bit) continue;
    if (part.inner_diameter >= part.outer_diameter)
    {
      problems.add(
          item("string", i, "inner_diameter"),
          metres(part.inner_diameter) + " leaves no wall, allowed: below outer_diameter, " + metres(part.outer_diameter));
    }
    if (part.tool_joint_diameter > 0.0 && part.tool_joint_diameter < part.outer_diameter)
    {
      problems.add(item("string", i, "tool_joint_diameter"), metres(part.tool_joint_diameter) +
                                                                 " is thinner than the body, allowed: at least outer_diameter, " +
                                                                 metres(part.outer_diameter));
    }
    if (part.type == PartType::stabilizer && part.blade_diameter < part.outer_diameter)
    {
      problems.add(item("string", i, "blade_diameter"), metres(part.blade_diameter) +
                                                            " is thinner than the body, allowed: at least outer_diameter, " +
                                                            metres(part.outer_diameter));
    }
  }
}

void check_part_inside(const std::vector<PartSpec>& parts, Problems& problems)
{
  double bottom = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const PartSpec& part = parts[i];
    const double top = bottom + part.length;
    if (part.type == PartType::mud_motor && (part.bit_to_bend <= bottom || part.bit_to_bend >= top))
    {
      problems.add(item("string", i, "bit_to_bend"),
                   metres(part.bit_to_bend) + " is outside the motor, allowed: between " + plain(bottom) + " and " + metres(top));
    }
    if (part.type == PartType::mwd && part.sensor_offset > part.length)
    {
      problems.add(item("string", i, "sensor_offset"),
                   metres(part.sensor_offset) + " is outside the part, allowed: 0 to " + metres(part.length));
    }
    if (part.type == PartType::bit && part.torque.model == BitTorqueModel::stribeck &&
        part.torque.kinetic_friction > part.torque.static_friction)
    {
      problems.add(item("string", i, "torque.kinetic"),
                   plain(part.torque.kinetic_friction) + " exceeds static, allowed: up to " + plain(part.torque.static_friction));
    }
    bottom = top;
  }
}

void check_string_length(const Scene& scene, Problems& problems)
{
  if (scene.string.size() < 2) return;
  const double needed = scene.start.bit_depth + scene.start.block_height;
  double length = 0.0;
  for (const PartSpec& part : scene.string) length += part.length;
  const PartSpec& last = scene.string.back();
  const std::string ending = metres(needed) + " from the bit to the top drive (bit_depth + block_height)";
  if (last.joints == 0)
  {
    if (length >= needed)
      problems.add("string", "the parts below `fill` are " + metres(length) + " long, more than the " + ending);
    return;
  }
  // a last short joint makes the length exact; elastic stretch stays far below 1 %
  if (length < 0.99 * needed)
    problems.add("string", "the string is " + metres(length) + " long, needed: " + ending + "; or let the last part `fill`");
  if (length - last.joint_length > needed) problems.add("string", "the string is " + metres(length) + " long, needed: " + ending);
}

void check_hoisting(const HoistingSpec& h, Problems& problems)
{
  if (h.lowest_block_height >= h.highest_block_height)
  {
    problems.add("rig.hoisting.lowest_block_height",
                 metres(h.lowest_block_height) + " is not below highest_block_height, " + metres(h.highest_block_height));
  }
  if (h.highest_block_height >= h.crown_height)
  {
    problems.add("rig.hoisting.highest_block_height",
                 metres(h.highest_block_height) + " is not below crown_height, " + metres(h.crown_height));
  }
}

void check_start(const Scene& scene, Problems& problems)
{
  const StartSpec& start = scene.start;
  const HoistingSpec& h = scene.rig.hoisting;
  if (start.bit_depth > scene.well.hole_depth)
  {
    problems.add("start.bit_depth",
                 metres(start.bit_depth) + " is below the hole's bottom, allowed: up to " + metres(scene.well.hole_depth));
  }
  const bool can_travel = h.lowest_block_height < h.highest_block_height;
  if (can_travel && (start.block_height < h.lowest_block_height || start.block_height > h.highest_block_height))
  {
    problems.add("start.block_height", metres(start.block_height) + " is outside the block's travel, allowed: " +
                                           plain(h.lowest_block_height) + " to " + metres(h.highest_block_height));
  }
  const bool on_bottom = start.bit_depth >= scene.well.hole_depth;
  if (start.weight_on_bit > 0.0 && !on_bottom)
    problems.add("start.weight_on_bit",
                 plain(start.weight_on_bit) + " N with the bit off bottom, allowed: 0, or bit_depth equal to hole_depth");
  if (start.torque_on_bit > 0.0 && !on_bottom)
    problems.add("start.torque_on_bit",
                 plain(start.torque_on_bit) + " N m with the bit off bottom, allowed: 0, or bit_depth equal to hole_depth");
}

void check_program(const Scene& scene, Problems& problems)
{
  const auto limit = [&](std::size_t i, const char* key, double value, double most, const char* unit, double scale)
  {
    if (std::isnan(value) || std::abs(value) <= most * (1.0 + 1e-12)) return;
    problems.add(item("program", i, key), plain(value / scale) + " " + unit + " is beyond the rig's limit, allowed: up to " +
                                              plain(most / scale) + " " + unit);
  };
  for (std::size_t i = 0; i < scene.program.size(); ++i)
  {
    const ProgramStep& step = scene.program[i];
    if (i > 0 && step.at <= scene.program[i - 1].at)
    {
      problems.add(item("program", i, "at"),
                   plain(step.at) + " s is not after the " + plain(scene.program[i - 1].at) + " s of the line before it");
    }
    if (!std::isnan(step.top_drive_speed) && !std::isnan(step.top_drive_torque))
    {
      problems.add(item("program", i), "both top_drive_speed_rpm and top_drive_torque are given, allowed: one of them");
    }
    if (step.brake == 1.0 && !std::isnan(step.block_velocity) && step.block_velocity != 0.0)
    {
      problems.add(item("program", i), "the brake is set and the block moves, allowed: one of them");
    }
    limit(i, "block_velocity", step.block_velocity, scene.rig.hoisting.max_speed, "m/s", 1.0);
    limit(i, "top_drive_speed_rpm", step.top_drive_speed, scene.rig.top_drive.max_speed, "rpm", rpm);
    limit(i, "top_drive_torque", step.top_drive_torque, scene.rig.top_drive.max_torque, "N m", 1.0);
    limit(i, "flow", step.flow, scene.rig.mud_pump.max_flow, "m3/s", 1.0);
  }
}
}  // namespace

void check_scene(const Scene& scene, Problems& problems)
{
  check_well(scene.well, problems);
  check_formation(scene.formation, problems);
  check_part_names(scene.string, problems);
  check_part_kinds(scene.string, problems);
  check_diameters(scene, problems);
  check_part_inside(scene.string, problems);
  check_string_length(scene, problems);
  check_hoisting(scene.rig.hoisting, problems);
  check_start(scene, problems);
  check_program(scene, problems);
  if (problems.has("trajectory.stage_two_length") && problems.has("trajectory.stage_two_steps"))
  {
    problems.add("trajectory.stage_two_steps", "is given beside stage_two_length, allowed: one of them");
  }
}

}  // namespace drill_rig_sim
