// SPDX-License-Identifier: BSD-3-Clause
#include "drill_margins.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/well/problem.h"

namespace drill_rig_sim
{
namespace
{
constexpr double surely = 0.9;  // of the turning torque, which the frictionless equilibrium gives within some per cent
constexpr double much = 0.8;    // of the string's hook load: as much as collars of a usual string weigh at most

constexpr Printed::InSI tenth_kilonewton{"%.1f", "kN", 1e-3}, tenth_kilonewton_metre{"%.1f", "kN m", 1e-3};

void print_torque(double limit, double torque, const std::string& key, const Printed& printed)
{
  std::printf(
      "torque      %s: %s does not turn the string, whose wall friction at the start takes about %s off bottom; use a larger "
      "limit\n",
      key.c_str(), printed(limit, Dimension::torque, tenth_kilonewton_metre).c_str(),
      printed(torque, Dimension::torque, tenth_kilonewton_metre).c_str());
}

/// @param most  hook load of the string off bottom [N]
void print_weight(double weight, double most, const std::string& key, const Printed& printed)
{
  if (weight <= much * most) return;
  std::printf(
      "weight      %s: %s is %.0f %% of the string's hook load off bottom, %s: pipe under compression may buckle; use a smaller "
      "weight or more collars\n",
      key.c_str(), printed(weight, Dimension::force, tenth_kilonewton).c_str(), 100.0 * weight / most,
      printed(most, Dimension::force, tenth_kilonewton).c_str());
}

/// @param threshold  of the rock at the hole's bottom [N]
void print_threshold(double weight, double threshold, const std::string& key, const Printed& printed)
{
  if (weight > threshold) return;
  std::printf(
      "weight      %s: %s is not above the threshold of the rock at the bottom, %s: the bit does not drill there; use a larger "
      "weight\n",
      key.c_str(), printed(weight, Dimension::force, tenth_kilonewton).c_str(),
      printed(threshold, Dimension::force, tenth_kilonewton).c_str());
}

/// Limits of the winch that act with nothing but the string on the hook.
void print_winch(const HoistingSpec& hoisting, double hook_load, const Printed& printed)
{
  const auto line = [&](const char* key, double limit, const char* side, const char* so)
  {
    std::printf("winch       rig.hoisting.%s: %s is %s the hook load at the start, %s: %s; is its unit right?\n", key,
                printed(limit, Dimension::force, tenth_kilonewton).c_str(), side,
                printed(hook_load, Dimension::force, tenth_kilonewton).c_str(), so);
  };
  if (hoisting.trip_hook_load > 0.0 && hoisting.trip_hook_load <= hook_load)
    line("trip_hook_load", hoisting.trip_hook_load, "below", "the brake is set whenever the string is raised");
  if (hoisting.min_hook_load >= hook_load)
    line("min_hook_load", hoisting.min_hook_load, "above", "the winch does not lower the string");
}
}  // namespace

void print_bits_that_stand(const Scene& scene)
{
  const bool motor =
      std::any_of(scene.string.begin(), scene.string.end(), [](const PartSpec& part) { return part.motor.has_value(); });
  bool rotates = false, pumps = false;
  for (std::size_t i = 0; i < scene.operations.size(); ++i)
  {
    const Operation& o = scene.operations[i];
    if (o.kind == OperationKind::rotate) rotates = o.rotary_speed != 0.0;
    if (o.kind == OperationKind::flow) pumps = o.flow > 0.0;
    const bool turns = (rotates && o.kind != OperationKind::slide) || (motor && pumps);
    if (!traits_of(o.kind).drills || turns || o.rotary_speed != 0.0) continue;
    std::printf("bit         operations[%zu]: nothing turns the bit when it begins to %s; needed before it: %s\n", i,
                word_of(o.kind),
                motor                            ? "flow, for the motor"
                : o.kind == OperationKind::slide ? "a motor in the string, and flow"
                                                 : "rotate");
  }
}

double turning_torque(const RigAtRest& rig)
{
  const Scene& scene = rig.model->scene();
  const Mesh& mesh = rig.model->mesh();
  const RigForces& forces = rig.statics.forces;
  double torque = 0.0;
  const auto add = [&](double force, double from_bit, double friction_radius, double radius)
  {
    const HoleSection& section = scene.well.sections[section_at(scene.well.sections, scene.start.bit_depth - from_bit)];
    torque += section.friction * force * (friction_radius > 0.0 ? friction_radius : radius);
  };
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    add(forces.contact[i], mesh.nodes[i].from_bit, mesh.nodes[i].friction_radius, mesh.nodes[i].contact_radius);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    add(forces.span_contact[e], mesh.middle(e), mesh.elements[e].friction_radius, 0.5 * mesh.elements[e].outer_diameter);
  return torque;
}

void print_margins(const RigAtRest& rig, const Printed& printed)
{
  const Scene& scene = rig.model->scene();
  const double torque = turning_torque(rig), most_torque = scene.rig.top_drive.max_torque;
  if (most_torque < surely * torque) print_torque(most_torque, torque, "rig.top_drive.max_torque", printed);
  for (std::size_t i = 0; i < scene.program.size(); ++i)
    if (const double limit = scene.program[i].torque_limit; limit > 0.0 && limit < surely * torque)
      print_torque(limit, torque, item_key("program", i, "top_drive_torque_limit"), printed);

  if (scene.program.empty()) print_bits_that_stand(scene);
  print_winch(scene.rig.hoisting, rig.statics.top_force + standard_gravity * scene.rig.hoisting.block_mass, printed);

  const double most_weight = rig.statics.top_force + rig.statics.forces.wob;
  if (most_weight <= 0.0) return;  // friction or the block pushes the string in
  print_weight(scene.start.weight_on_bit, most_weight, "start.weight_on_bit", printed);
  const double threshold = rig.model->rock_under(rig.state.well).threshold;
  for (std::size_t i = 0; i < scene.operations.size(); ++i)
    if (traits_of(scene.operations[i].kind).drills)
    {
      print_weight(scene.operations[i].weight, most_weight, item_key("operations", i, "weight"), printed);
      print_threshold(scene.operations[i].weight, threshold, item_key("operations", i, "weight"), printed);
    }
}

}  // namespace drill_rig_sim
