// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/string/string_checks.h"

#include <algorithm>
#include <cmath>

#include "cuts.h"
#include "drill_rig_sim/math/units.h"
#include "section_checks.h"

namespace drill_rig_sim
{
namespace
{
void check_kinds(const std::vector<PartSpec>& parts, ProblemList& problems)
{
  if (parts.front().type != PartType::bit)
    problems.emplace_back("string[0].type", "the first part is not a bit, needed: parts from the bit up");
  if (parts.back().type == PartType::bit)
    problems.emplace_back("string", "there is nothing above the bit, needed: at least one pipe or collar");
  int motors = 0, surveyors = 0, steerers = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const PartType type = parts[i].type;
    motors += type == PartType::mud_motor ? 1 : 0;
    surveyors += type == PartType::mwd ? 1 : 0;
    steerers += type == PartType::rotary_steerable ? 1 : 0;
    if (i > 0 && type == PartType::bit) problems.emplace_back(item_key("string", i, "type"), "a second bit, allowed: one");
    if (type == PartType::mud_motor && motors == 2)
      problems.emplace_back(item_key("string", i, "type"), "a second mud motor, allowed: one");
    if (type == PartType::mud_motor && motors == 1 && i > 1)
      problems.emplace_back(item_key("string", i, "type"),
                            "the mud motor is not next to the bit, allowed: directly above the bit");
    if (type == PartType::rotary_steerable && steerers == 2)
      problems.emplace_back(item_key("string", i, "type"), "a second rotary_steerable, allowed: one");
    if (type == PartType::mwd && surveyors == 2)
      problems.emplace_back(item_key("string", i, "type"), "a second mwd, allowed: one");
    if (parts[i].joints == 0 && i + 1 < parts.size())
      problems.emplace_back(item_key("string", i, "joints"),
                            "`fill` is not the string's last part, allowed: on the last part only");
  }
}

void check_gauge(const PartSpec& part, const std::string& key, ProblemList& problems)
{
  const double length = part.bit->gauge_length, most = part.length - 0.5 * part.bit->diameter;
  if (length == 0.0) return;
  if (length > most * (1.0 + 1e-9))
    problems.emplace_back(key, metres(length) +
                                   " ends above the bit (it begins half the bit's diameter above its face); allowed: " +
                                   (most >= least_element_length ? "up to " + metres(most) : "0, or a longer bit"));
  else if (length < least_element_length)
    problems.emplace_back(key, metres(length) + " is too short, allowed: 0, or " + metres(least_element_length) + " or more");
}

/// Pipe lighter than the tube of its material is a slip: of units, or without it of the material. Tools are no plain tubes.
void check_mass(const PartSpec& part, const std::string& key, ProblemList& problems)
{
  constexpr double least = 0.9;  // pipe worn, diameters rounded
  if (part.type != PartType::pipe || part.stiffness.axial > 0.0) return;
  const double tube =
      part.density * 0.25 * pi * (part.outer_diameter * part.outer_diameter - part.inner_diameter * part.inner_diameter);
  if (part.linear_mass < least * tube)
    problems.emplace_back(key, plain(part.linear_mass) + " kg/m is less than a tube of its diameters with density " +
                                   plain(part.density) + " kg/m3, " + plain(tube) + " kg/m, allowed: " + plain(least * tube) +
                                   " or more, or the material's own density");
}

const char* place_key(const SteerableSpec& tool)
{
  return tool.tilt > 0.0 ? "bit_to_pivot" : "bit_to_pads";
}

/// What cuts a part into elements.
const char* key_of_places(const PartSpec& part)
{
  if (part.steerable) return place_key(*part.steerable);
  return part.motor ? "bit_to_bend" : "length";
}

/// It pushes or points, by what it says.
void check_steerable(const SteerableSpec& tool, std::size_t i, double bottom, double top, ProblemList& problems)
{
  const bool pushes = tool.pad_force > 0.0, points = tool.tilt > 0.0;
  if (pushes == points)
    return void(problems.emplace_back(item_key("string", i),
                                      "both or neither of `pad_force` and `tilt_deg` are given, needed: one of them"));
  if (pushes && tool.bit_to_pivot > 0.0)
    problems.emplace_back(item_key("string", i, "bit_to_pivot"), "is given, allowed with `tilt_deg`");
  if (points && tool.bit_to_pads > 0.0)
    problems.emplace_back(item_key("string", i, "bit_to_pads"), "is given, allowed with `pad_force`");
  if (tool.place() <= bottom || tool.place() >= top)
    problems.emplace_back(
        item_key("string", i, place_key(tool)),
        metres(tool.place()) + " is outside the tool, allowed: between " + plain(bottom) + " and " + metres(top));
}

void check_inside(const std::vector<PartSpec>& parts, ProblemList& problems)
{
  double bottom = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const PartSpec& part = parts[i];
    const double top = bottom + part.length;
    if (part.motor && (part.motor->bit_to_bend <= bottom || part.motor->bit_to_bend >= top))
      problems.emplace_back(
          item_key("string", i, "bit_to_bend"),
          metres(part.motor->bit_to_bend) + " is outside the motor, allowed: between " + plain(bottom) + " and " + metres(top));
    if (part.motor && part.motor->sleeve_diameter > 0.0 &&
        (part.motor->bit_to_sleeve <= bottom || part.motor->bit_to_sleeve >= top))
      problems.emplace_back(
          item_key("string", i, "bit_to_sleeve"),
          metres(part.motor->bit_to_sleeve) + " is outside the motor, allowed: between " + plain(bottom) + " and " + metres(top));
    if (part.steerable) check_steerable(*part.steerable, i, bottom, top, problems);
    if (part.mwd && part.mwd->sensor_offset > part.length)
      problems.emplace_back(item_key("string", i, "sensor_offset"),
                            metres(part.mwd->sensor_offset) + " is outside the part, allowed: 0 to " + metres(part.length));
    if (part.bit && !traits_of(part.bit->torque.model).drag &&
        part.bit->torque.kinetic_friction > part.bit->torque.static_friction)
      problems.emplace_back(item_key("string", i, "torque.kinetic"), plain(part.bit->torque.kinetic_friction) +
                                                                         " exceeds static, allowed: up to " +
                                                                         plain(part.bit->torque.static_friction));
    check_mass(part, item_key("string", i, "linear_mass"), problems);
    if (part.bit) check_gauge(part, item_key("string", i, "gauge_length"), problems);
    bottom = top;
  }
}

void check_length(const std::vector<PartSpec>& parts, double needed, ProblemList& problems)
{
  double length = 0.0;
  for (const PartSpec& part : parts) length += part.length;
  const PartSpec& last = parts.back();
  const std::string ending = metres(needed) + " from the bit to the top drive (bit_depth + block_height)";
  if (last.joints == 0)
  {
    if (length + shortest_joint > needed)
      problems.emplace_back("string", "the parts below `fill` are " + metres(length) + " long, allowed: up to " +
                                          metres(shortest_joint) + " less than the " + ending);
    return;
  }
  if (length < 0.99 * needed)
    problems.emplace_back(
        "string", "the string is " + metres(length) + " long, needed: " + ending + "; or give the last part `joints: fill`");
  else if (length - last.joint_length > needed)
    problems.emplace_back("string", "the string is " + metres(length) + " long, needed: " + ending);
  else
    problems.emplace_back(item_key("string", parts.size() - 1),
                          "the last part has a fixed length, needed: `joints: fill`, because the string stretches under load");
}

/// The cuts of the whole string; none if they would be more than are allowed. `count`: how many they are [-].
std::vector<Cut> cuts_of(const std::vector<PartSpec>& parts, double length, const ElementLengths& longest, double& count)
{
  std::vector<Cut> cuts;
  if (parts.front().bit->gauge_length > 0.0) cuts.push_back(cut_gauge(*parts.front().bit));
  count = 0.0;
  double lower = parts.front().length;
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    const PartSpec& part = parts[i];
    const double joints = part.joints > 0 ? part.joints : std::ceil((length - lower) / part.joint_length);
    count += joints * std::ceil(part.joint_length / std::min(longest.lower, longest.upper)) + 1.0;
    if (count > most_mesh_nodes) continue;
    const std::vector<double> lengths = joint_lengths(part, length - lower);
    cut_part(part, static_cast<int>(i), lower, lengths, longest, Pairs(), cuts);
    for (double joint : lengths) lower += joint;
  }
  return cuts;
}

void check_mesh(const std::vector<PartSpec>& parts, double length, const ElementLengths& longest, ProblemList& problems)
{
  double count = 0.0;
  const std::vector<Cut> cuts = cuts_of(parts, length, longest, count);
  if (count > most_mesh_nodes)
  {
    problems.emplace_back("numerics.element_length", metres(std::min(longest.lower, longest.upper)) + " gives about " +
                                                         plain(count) + " nodes, allowed: up to " +
                                                         std::to_string(most_mesh_nodes));
    return;
  }
  // node 0 is the bit's centre
  double below = 0.5 * parts.front().bit->diameter;
  if (cuts.front().from_bit - below < least_element_length)
    return void(problems.emplace_back("string[0].length", "the next node is " + metres(cuts.front().from_bit) +
                                                              " above the bit's face and the bit's centre " + metres(below) +
                                                              ", needed: a longer bit, so that the centre lies " +
                                                              metres(least_element_length) + " or more below that node"));
  for (const Cut& cut : cuts)
  {
    const PartSpec& part = parts[static_cast<std::size_t>(cut.part)];
    if (cut.from_bit - below < least_element_length * (1.0 - 1e-6))
      return void(problems.emplace_back(item_key("string", static_cast<std::size_t>(cut.part), key_of_places(part)),
                                        "an element of this part is " + metres(cut.from_bit - below) +
                                            " long, allowed: " + metres(least_element_length) + " or more"));
    below = cut.from_bit;
  }
}
}  // namespace

ProblemList string_problems(const std::vector<PartSpec>& parts, double length, const ElementLengths& longest)
{
  ProblemList problems;
  if (parts.empty())
  {
    problems.emplace_back("string", "the list is empty, needed: at least a bit and a pipe");
    return problems;
  }
  check_kinds(parts, problems);
  check_inside(parts, problems);
  check_sections(parts, problems);
  if (parts.size() > 1) check_length(parts, length, problems);
  // where parts stand wrongly the mesh makes no sense
  if (problems.empty()) check_mesh(parts, length, longest, problems);
  return problems;
}

}  // namespace drill_rig_sim
