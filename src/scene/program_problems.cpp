// SPDX-License-Identifier: BSD-3-Clause
#include "program_problems.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/string/string_checks.h"

namespace drill_rig_sim
{
namespace
{
/// Amplitudes of OSCILLATE that a program has given so far [rad].
struct Amplitudes
{
  double right = 0.0, left = 0.0;
};

/// The modes with such a goal, "angle or oscillate".
std::string modes_that(bool (*have)(DriveGoal))
{
  std::string words;
  for (const TopDriveModeTraits& mode : top_drive_modes)
    if (have(mode.goal)) words += (words.empty() ? "" : " or ") + std::string(mode.word);
  return words;
}

// keys of different modes in one line
void check_drive_modes(const ProgramStep& step, std::size_t i, Amplitudes& amplitudes, ProblemList& problems)
{
  const bool turns = !std::isnan(step.top_drive_speed), twists = !std::isnan(step.top_drive_torque),
             aims = !std::isnan(step.top_drive_angle);
  const bool rocks = !std::isnan(step.amplitude_right) || !std::isnan(step.amplitude_left), named = step.top_drive_mode >= 0;
  const DriveGoal goal = named ? goal_of(static_cast<TopDriveMode>(step.top_drive_mode)) : DriveGoal::speed;
  const auto problem = [&](const std::string& text) { problems.emplace_back(item_key("program", i), text); };
  const auto not_in = [&](const char* key, const std::string& modes)
  { problem(std::string(key) + " has no effect in this top_drive_mode, allowed: with " + modes); };
  if (turns && twists) problem("both top_drive_speed_rpm and top_drive_torque are given, allowed: one of them");
  if (twists && (aims || rocks)) problem("both top_drive_torque and an angle or an amplitude are given, allowed: one of them");
  const auto by_torque = [](DriveGoal g) { return g == DriveGoal::torque; };
  const auto to_angle = [](DriveGoal g) { return turns_to_angle(g); };
  const auto swings = [](DriveGoal g) { return g == DriveGoal::swing; };
  if (named && turns && by_torque(goal)) not_in("top_drive_speed_rpm", "any but " + modes_that(by_torque));
  if (named && twists && !by_torque(goal)) not_in("top_drive_torque", modes_that(by_torque));
  if (named && aims && !to_angle(goal)) not_in("top_drive_angle_deg", modes_that(to_angle));
  if (named && rocks && !swings(goal)) not_in("an amplitude", modes_that(swings));
  if (!std::isnan(step.amplitude_right)) amplitudes.right = step.amplitude_right;
  if (!std::isnan(step.amplitude_left)) amplitudes.left = step.amplitude_left;
  if ((rocks || swings(goal)) && amplitudes.right + amplitudes.left == 0.0)
    problem("both amplitudes of oscillate are 0, needed: amplitude_right_deg or amplitude_left_deg above 0");
}

// what a line of the program says beside its set points
void check_ramp_and_faults(const ProgramStep& step, std::size_t i, ProblemList& problems)
{
  const bool leads_somewhere = !std::isnan(step.block_velocity) || !std::isnan(step.top_drive_speed) ||
                               !std::isnan(step.top_drive_torque) || !std::isnan(step.flow);
  if (step.ramp > 0.0 && !leads_somewhere)
    problems.emplace_back(
        item_key("program", i, "ramp"),
        "there is no set point to ramp to, needed: block_velocity, top_drive_speed_rpm, top_drive_torque or flow");
  if (step.ramp > 0.0 && step.top_drive_brake == 1.0 && (!std::isnan(step.top_drive_speed) || !std::isnan(step.top_drive_torque)))
    problems.emplace_back(item_key("program", i), "the top drive's brake is set and its set point ramps, allowed: one of them");
  if (step.free == 0.0) problems.emplace_back(item_key("program", i, "free"), "false is given, allowed: true");
  if (step.free == 1.0 && !std::isnan(step.stuck_at))
    problems.emplace_back(item_key("program", i), "both stuck_at and free are given, allowed: one of them");
  if (step.connection == 0.0 || (!std::isnan(step.connection) && step.connection != std::round(step.connection)))
    problems.emplace_back(item_key("program", i, "connection"),
                          plain(step.connection) + " joints are given, allowed: a whole number, not 0");
}

void check_fault(const ProgramStep& step, std::size_t i, ProblemList& problems)
{
  const auto problem = [&](const char* key, const std::string& text)
  { problems.emplace_back(item_key("program", i, key), text); };
  const auto of_gauge = [](int kind) { return kind >= 0 && is_of_gauge(static_cast<FaultKind>(kind)); };
  if ((of_gauge(step.fault) || of_gauge(step.clear_fault)) != (step.fault_gauge >= 0))
    problem("fault_target", step.fault_gauge < 0 ? "a gauge is needed with this fault"
                                                 : "has no effect without a sensor fault, allowed: only with one");
  if (step.fault < 0) return;
  const Fault fault{static_cast<FaultKind>(step.fault), step.fault_depth, step.fault_magnitude};
  if (traits_of(fault.kind).place == FaultPlace::nowhere && step.fault_depth != 0.0)
    problem("fault_depth", "has no effect on this fault, allowed: none");
  if (!has_magnitude(fault.kind) && step.fault_magnitude != 0.0)
    problem("fault_magnitude", "has no effect on this fault, allowed: none");
  if (needs_pipe(fault.kind) && step.fault_depth <= 0.0)
    problem("fault_depth", "is needed with this fault, allowed: above 0 (the rotary table)");
  if (const char* wrong = what_is_wrong_with_magnitude(fault))
    problem("fault_magnitude", wrong + std::string("magnitude: ").size());
}

/// Of a tool that points the bit, above the bit's face; 0: there is none [m].
double pivot_of(const std::vector<PartSpec>& parts)
{
  for (const PartSpec& part : parts)
    if (part.steerable && part.steerable->tilt > 0.0) return part.steerable->bit_to_pivot;
  return 0.0;
}
}  // namespace

std::string what_it_cuts(const Scene& scene, double free_length)
{
  if (!(free_length > 0.0)) return {};
  const double bit = scene.string.empty() ? 0.0 : scene.string.front().length;
  if (free_length < bit) return metres(free_length) + " ends within the bit, allowed: 0 or from " + metres(bit) + " on";
  const double pivot = pivot_of(scene.string);
  if (free_length < pivot)
    return metres(free_length) + " ends below the pivot of a tool that points the bit, allowed: 0 or from " + metres(pivot) +
           " on";
  return {};
}

ProblemList program_problems(const Scene& scene)
{
  ProblemList problems;
  const auto limit = [&](std::size_t i, const char* key, double value, double most, const char* unit, double scale)
  {
    if (std::isnan(value) || std::abs(value) <= most * (1.0 + 1e-12)) return;
    problems.emplace_back(
        item_key("program", i, key),
        plain(value / scale) + " " + unit + " is beyond the rig's limit, allowed: up to " + plain(most / scale) + " " + unit);
  };
  const bool steerable =
      std::any_of(scene.string.begin(), scene.string.end(), [](const PartSpec& part) { return part.steerable.has_value(); });
  double free = free_length(scene);
  Amplitudes amplitudes;
  for (std::size_t i = 0; i < scene.program.size(); ++i)
  {
    const ProgramStep& step = scene.program[i];
    if (i > 0 && step.at <= scene.program[i - 1].at)
    {
      problems.emplace_back(item_key("program", i, "at"), plain(step.at) + " s is not after the " +
                                                              plain(scene.program[i - 1].at) + " s of the line before it");
    }
    check_drive_modes(step, i, amplitudes, problems);
    if (step.brake == 1.0 && !std::isnan(step.block_velocity) && (step.block_velocity != 0.0 || step.ramp > 0.0))
    {
      problems.emplace_back(item_key("program", i), "the brake is set and the block moves, allowed: one of them");
    }
    check_ramp_and_faults(step, i, problems);
    if ((!std::isnan(step.steering_toolface) || !std::isnan(step.steering_ratio)) && !steerable)
      problems.emplace_back(item_key("program", i), "steering needs a part of type rotary_steerable in `string`");
    check_fault(step, i, problems);
    if (!std::isnan(step.free_length) && (scene.numerics.level == Level::rigid || has_no_levels(scene.numerics.integrator)))
      problems.emplace_back(item_key("program", i, "free_length"),
                            "cannot change with level rigid or with this integrator; leave it out");
    else if (step.free_length > free)
      problems.emplace_back(item_key("program", i, "free_length"),
                            metres(step.free_length) + " is longer than before, allowed: up to " + metres(free));
    else if (const std::string cut = what_it_cuts(scene, step.free_length); !cut.empty())
      problems.emplace_back(item_key("program", i, "free_length"), cut);
    if (!std::isnan(step.free_length)) free = step.free_length;
    limit(i, "block_velocity", step.block_velocity, scene.rig.hoisting.max_speed, "m/s", 1.0);
    limit(i, "top_drive_speed_rpm", step.top_drive_speed, scene.rig.top_drive.max_speed, "rpm", rpm);
    limit(i, "top_drive_torque", step.top_drive_torque, scene.rig.top_drive.max_torque, "N m", 1.0);
    limit(i, "top_drive_torque_limit", step.torque_limit, scene.rig.top_drive.max_torque, "N m", 1.0);
    limit(i, "flow", step.flow, scene.rig.mud_pump.max_flow, "m3/s", 1.0);
  }
  return problems;
}

}  // namespace drill_rig_sim
