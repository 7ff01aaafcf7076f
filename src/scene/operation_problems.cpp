// SPDX-License-Identifier: BSD-3-Clause
#include "operation_problems.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
/// One operation of the list.
class OperationCheck
{
public:
  OperationCheck(const Scene& scene, std::size_t i, ProblemList& problems)
      : scene_(scene), o_(scene.operations[i]), i_(i), problems_(problems)
  {
  }

  void limits()
  {
    limit("speed", o_.speed, scene_.rig.hoisting.max_speed, "m/s", 1.0);
    limit("speed_rpm", o_.rotary_speed, scene_.rig.top_drive.max_speed, "rpm", rpm);
    limit("flow", o_.flow, scene_.rig.mud_pump.max_flow, "m3/s", 1.0);
  }

  void end()
  {
    const bool anywhere = !std::isnan(o_.to_depth) || !std::isnan(o_.distance) || !std::isnan(o_.time);
    const bool drills = traits_of(o_.kind).drills;
    if (drills && !anywhere) add("", "has no end condition, needed: to_depth, distance or time");
    if (o_.kind == OperationKind::pick_up && !anywhere && std::isnan(o_.overpull))
      add("", "has no end condition, needed: to_depth, distance, time or overpull");
    if (o_.kind == OperationKind::slack_off && !anywhere && std::isnan(o_.weight))
      add("", "has no end condition, needed: to_depth, distance, time or weight");
  }

  /// With the stand that hangs there at the start.
  void reach()
  {
    const double deepest = scene_.start.bit_depth + scene_.start.block_height - scene_.rig.hoisting.lowest_block_height;
    const double highest = scene_.start.bit_depth + scene_.start.block_height - scene_.rig.hoisting.highest_block_height;
    if (o_.kind == OperationKind::trip) return trip();
    if (scene_.connections == Connections::automatic || std::isnan(o_.to_depth)) return;
    if (o_.to_depth > deepest + nothing)
      add("to_depth", metres(o_.to_depth) + " is deeper than the block can lower the bit, allowed: up to " + metres(deepest));
    if (o_.kind == OperationKind::pick_up && o_.to_depth < highest - nothing)
      add("to_depth",
          metres(o_.to_depth) + " is shallower than the block can raise the bit, allowed: from " + metres(highest) + " on");
  }

  void needs()
  {
    const auto tells = [](const PartSpec& part) { return part.type == PartType::mwd; };
    if (o_.kind == OperationKind::slide && std::none_of(scene_.string.begin(), scene_.string.end(), tells))
      add("do", "slide needs a part of type mwd in `string`, which measures the toolface");
    const auto steers = [](const PartSpec& part) { return part.steerable.has_value(); };
    if (o_.kind == OperationKind::steer && std::none_of(scene_.string.begin(), scene_.string.end(), steers))
      add("do", "steer needs a part of type rotary_steerable in `string`");
    if (o_.kind == OperationKind::oscillate && o_.amplitude_right + o_.amplitude_left == 0.0)
      add("", "both amplitudes are 0, needed: amplitude_right_deg or amplitude_left_deg above 0");
    const std::string lacking = needs_crew(o_.kind) ? what_the_crew_lacks(scene_) : "";
    if (!lacking.empty()) add("do", std::string(word_of(o_.kind)) + ": " + lacking);
    const bool angles = o_.kind == OperationKind::slide || o_.kind == OperationKind::oscillate;
    if (angles && o_.rotary_speed < 0.0) add("speed_rpm", plain(o_.rotary_speed / rpm) + " rpm is given, allowed: 0 or more");
  }

private:
  /// As long as nothing has made the hole deeper.
  void trip()
  {
    const auto drills = [](const Operation& before) { return traits_of(before.kind).drills; };
    const auto end = scene_.operations.begin() + static_cast<std::ptrdiff_t>(i_);
    if (scene_.program.empty() && std::none_of(scene_.operations.begin(), end, drills) &&
        o_.to_depth > scene_.well.hole_depth + nothing)
      add("to_depth", metres(o_.to_depth) + " is below the hole's bottom, allowed: down to " + metres(scene_.well.hole_depth));
  }

  static constexpr double nothing = 1e-6;  // [m]

  void add(const char* key, const std::string& text)
  {
    problems_.emplace_back(*key ? item_key("operations", i_, key) : item_key("operations", i_), text);
  }

  void limit(const char* key, double value, double most, const char* unit, double scale)
  {
    if (std::abs(value) <= most * (1.0 + 1e-12)) return;
    add(key,
        plain(value / scale) + " " + unit + " is beyond the rig's limit, allowed: up to " + plain(most / scale) + " " + unit);
  }

  const Scene& scene_;
  const Operation& o_;
  std::size_t i_;
  ProblemList& problems_;
};
}  // namespace

std::string what_the_crew_lacks(const Scene& scene)
{
  if (scene.string.empty()) return "";
  if (scene.numerics.integrator == IntegratorKind::ida) return "not available with the reference (ida)";
  const HoistingSpec& h = scene.rig.hoisting;
  const double travel = h.highest_block_height - h.lowest_block_height,
               needed = room_for_stand(h.stand_joints * scene.string.back().joint_length + lift_over_waves(scene.rig.heave));
  return travel < needed ? "the block travels " + metres(travel) + ", needed for a stand: " + metres(needed) : "";
}

ProblemList operation_problems(const Scene& scene)
{
  ProblemList problems;
  for (std::size_t i = 0; i < scene.operations.size(); ++i)
  {
    OperationCheck check(scene, i, problems);
    check.limits();
    check.end();
    check.reach();
    check.needs();
  }
  return problems;
}

}  // namespace drill_rig_sim
