// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/scene/scene_problems.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/string/string_checks.h"
#include "drill_rig_sim/well/projection.h"
#include "drill_rig_sim/well/well_checks.h"
#include "operation_problems.h"
#include "program_problems.h"

namespace drill_rig_sim
{
namespace
{
constexpr const char* not_a_name = "is not a valid name, allowed: 1 to 64 letters, digits and _";

void check_formation(const std::vector<FormationLayer>& layers, ProblemList& problems)
{
  if (layers.empty()) problems.emplace_back("formation", "the list is empty, needed: at least one layer");
  for (std::size_t i = 1; i < layers.size(); ++i)
  {
    if (layers[i].to_tvd > layers[i - 1].to_tvd) continue;
    problems.emplace_back(
        item_key("formation", i, "to_tvd"),
        metres(layers[i].to_tvd) + " is not below the layer above it, which ends at " + metres(layers[i - 1].to_tvd));
  }
}

/// A drag bit's torque and the rock's law must be about one rock: its energy, its cutters' inclination and its drillability are
/// two numbers, not three, and the weight on its flats breaks none.
void check_drag_bit(const BitSpec& bit, const std::vector<FormationLayer>& layers, ProblemList& problems)
{
  constexpr double least = 0.4, most = 1.0;  // about the measured 0.5 to 0.8
  const BitTorqueSpec& torque = bit.torque;
  const BitLawTraits law = traits_of(torque.model);
  if (!law.drag) return;
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    const FormationLayer& rock = layers[i];
    const std::string layer = "formation[" + std::to_string(i) + "]";
    if (torque.wear_weight > rock.threshold)
      problems.emplace_back("string[0].torque.wear_weight", plain(torque.wear_weight) + " N is more than the threshold of " +
                                                                layer + ", allowed: up to " + plain(rock.threshold) + " N");
    if (law.by_cut && (rock.weight_exponent != 1.0 || rock.speed_exponent != 1.0))
    {
      problems.emplace_back("string[0].torque.model",
                            std::string(law.word) + " needs weight_exponent 1 and speed_exponent 1 in " + layer);
      continue;
    }
    if (torque.cutting_energy == 0.0) continue;
    if (rock.weight_exponent != 1.0 || rock.speed_exponent != 1.0)
    {
      problems.emplace_back("string[0].torque.cutting_energy",
                            "needs weight_exponent 1 and speed_exponent 1 in " + layer + ", or leave it out");
      continue;
    }
    const double zeta = implied_inclination(bit.diameter, rock.drillability, torque.cutting_energy);
    if (zeta >= least && zeta <= most) continue;
    const double own = torque.cutting_energy * zeta / cutter_inclination;
    problems.emplace_back("string[0].torque.cutting_energy",
                          plain(torque.cutting_energy) + " J/m3 contradicts the drillability of " + layer +
                              ", which corresponds to about " + plain(own) +
                              " J/m3, allowed: " + plain(torque.cutting_energy * zeta / most) + " to " +
                              plain(torque.cutting_energy * zeta / least) + " J/m3; or leave it out");
  }
}

// names become frames of the transform tree
void check_part_names(const std::vector<PartSpec>& parts, ProblemList& problems)
{
  const std::set<std::string> reserved = {"rig_floor", "world", "map", "traveling_block", "top_drive"};
  std::set<std::string> seen;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const std::string& name = parts[i].name;
    const std::string path = item_key("string", i, "name");
    if (!is_name(name))
      problems.emplace_back(path, not_a_name);
    else if (reserved.count(name) || name.rfind("pipe_", 0) == 0)
      problems.emplace_back(path, "is the name of a frame of the rig, choose another name");
    else if (!seen.insert(name).second)
      problems.emplace_back(path, "is the name of two parts, needed: unique names");
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
  for (const Width& other : {Width{"tool_joint_diameter", part.pipe ? part.pipe->tool_joint_diameter : 0.0},
                             Width{"sleeve_diameter", part.motor ? part.motor->sleeve_diameter : 0.0},
                             Width{"blade_diameter", part.stabilizer ? part.stabilizer->blade_diameter : 0.0},
                             Width{"diameter", part.bit ? part.bit->diameter : 0.0}})
  {
    if (other.diameter > width.diameter) width = other;
  }
  return width;
}

// of the sections that begin above a depth [m]
double narrowest_above(const std::vector<HoleSection>& sections, double depth)
{
  double narrowest = 1e9, top = 0.0;
  for (const HoleSection& section : sections)
  {
    if (top < depth) narrowest = std::min(narrowest, section.diameter);
    top = section.to;
  }
  return narrowest;
}

std::string laws_that_ream()
{
  std::string words;
  for (const BitLawTraits& law : bit_laws)
    if (!law.by_cut) words += (words.empty() ? "" : " or ") + std::string(law.word);
  return words;
}

void check_reaming(const Scene& scene, ProblemList& problems)
{
  constexpr double most = 0.95;  // of the bit's diameter: what is left of less is no ring that a law of drilling holds for
  if (scene.well.pilot_depth == 0.0 || !scene.string[0].bit) return;
  const BitSpec& bit = *scene.string[0].bit;
  if (scene.well.pilot_diameter > most * bit.diameter)
    problems.emplace_back("well.pilot_diameter", metres(scene.well.pilot_diameter) +
                                                     " is too wide to be reamed by this bit, allowed: up to " +
                                                     metres(most * bit.diameter));
  const BitLawTraits law = traits_of(bit.torque.model);
  if (law.by_cut)
    problems.emplace_back("string[0].torque.model", std::string("reaming with the ") + law.word +
                                                        " law is not available yet, allowed: " + laws_that_ream() +
                                                        ", or no well.pilot_depth");
}

/// Whether part `i`, whose lower end is `from_bit` [m] above the bit's face, passes all sections on its way down, with the bit as
/// deep as a run may drill.
void check_passage(const Scene& scene, std::size_t i, double from_bit, ProblemList& problems)
{
  const double drilled = scene.rig.hoisting.highest_block_height;
  const PartSpec& part = scene.string[i];
  const Width width = widest(part);
  const bool into_drilled = from_bit < drilled;
  const double deepest = scene.well.hole_depth + (into_drilled ? 0.0 : drilled - from_bit);
  const double narrowest = narrowest_above(scene.well.sections, deepest);
  const std::string key = item_key("string", i, width.key);
  if (width.diameter > narrowest)
  {
    problems.emplace_back(
        key, metres(width.diameter) + " does not pass the hole, allowed: up to its narrowest section above " + metres(deepest) +
                 ": " + metres(narrowest) +
                 (part.type == PartType::bit ? "; if the bit reams a narrower hole, set well.pilot_depth" : ""));
    return;
  }
  const std::optional<BitSpec>& bit = scene.string[0].bit;
  if (i > 0 && into_drilled && bit && width.diameter > bit->diameter)
    problems.emplace_back(
        key, metres(width.diameter) + " does not fit the hole that the bit drills, allowed: up to " + metres(bit->diameter));
}

/// Diameters of one part against each other.
void check_thickness(const PartSpec& part, std::size_t i, ProblemList& problems)
{
  const std::string body = "outer_diameter, " + metres(part.outer_diameter);
  if (part.inner_diameter >= part.outer_diameter)
    problems.emplace_back(item_key("string", i, "inner_diameter"),
                          metres(part.inner_diameter) + " leaves no wall thickness, allowed: below " + body);
  const auto check_wider = [&](const char* key, double diameter, const char* or_else)
  {
    if (diameter < part.outer_diameter)
      problems.emplace_back(item_key("string", i, key),
                            metres(diameter) + " is thinner than the body, allowed: at least " + body + or_else);
  };
  if (part.pipe && part.pipe->tool_joint_diameter > 0.0) check_wider("tool_joint_diameter", part.pipe->tool_joint_diameter, "");
  if (part.motor && part.motor->sleeve_diameter > 0.0) check_wider("sleeve_diameter", part.motor->sleeve_diameter, ", or 0");
  if (part.stabilizer) check_wider("blade_diameter", part.stabilizer->blade_diameter, "");
}

void check_diameters(const Scene& scene, ProblemList& problems)
{
  double from_bit = 0.0;
  for (std::size_t i = 0; i < scene.string.size(); ++i)
  {
    const PartSpec& part = scene.string[i];
    check_passage(scene, i, from_bit, problems);
    from_bit += part.length;
    if (part.type != PartType::bit) check_thickness(part, i, problems);
  }
}

/// The force of a shaking tool does not shorten the steps: in twenty a period BDF2 has its rates to 3 %.
void check_oscillation(const Scene& scene, ProblemList& problems)
{
  constexpr double least_steps = 20.0;  // a period
  for (std::size_t i = 0; i < scene.string.size(); ++i)
  {
    const PartSpec& part = scene.string[i];
    const double most = 1.0 / (least_steps * part.oscillation_frequency), step = scene.numerics.step;
    if (part.oscillation_force == 0.0 || (step > 0.0 && step <= most * (1.0 + 1e-9))) continue;
    problems.emplace_back(
        "string[" + std::to_string(i) + "].oscillation_frequency",
        plain(part.oscillation_frequency) + " Hz needs a fixed numerics.step, allowed: up to " + plain(most) + " s");
  }
}

void check_hoisting(const HoistingSpec& h, ProblemList& problems)
{
  if (h.lowest_block_height >= h.highest_block_height)
  {
    problems.emplace_back(
        "rig.hoisting.lowest_block_height",
        metres(h.lowest_block_height) + " is not below highest_block_height, " + metres(h.highest_block_height));
  }
  if (h.highest_block_height >= h.crown_height)
  {
    problems.emplace_back("rig.hoisting.highest_block_height",
                          metres(h.highest_block_height) + " is not below crown_height, " + metres(h.crown_height));
  }
}

void check_heave(const HeaveSpec& heave, ProblemList& problems)
{
  constexpr double most = 3.0;  // of a rig in any sea [m/s2]
  if (heave_acceleration(heave) <= most) return;
  problems.emplace_back("rig.heave.amplitude", metres(heave.amplitude) + " in " + plain(heave.period) + " s is " +
                                                   plain(heave_acceleration(heave)) +
                                                   " m/s2 of acceleration, allowed: up to 3 m/s2");
}

void check_connections(const Scene& scene, ProblemList& problems)
{
  const std::string lacking = scene.connections == Connections::automatic ? what_the_crew_lacks(scene) : "";
  if (!lacking.empty()) problems.emplace_back("connections", "auto: " + lacking);
}

void check_start(const Scene& scene, ProblemList& problems)
{
  const StartSpec& start = scene.start;
  const HoistingSpec& h = scene.rig.hoisting;
  if (start.bit_depth > scene.well.hole_depth)
  {
    const bool can_project = scene.well.project == Projection::none && !scene.well.survey.empty() &&
                             start.bit_depth <= scene.well.survey.back().md + longest_projection;
    problems.emplace_back("start.bit_depth",
                          metres(start.bit_depth) + " is below the hole's bottom, allowed: up to " +
                              metres(scene.well.hole_depth) +
                              (can_project ? "; well.hole_depth and well.project: straight or curvature extend it" : ""));
  }
  const bool can_travel = h.lowest_block_height < h.highest_block_height;
  if (can_travel && (start.block_height < h.lowest_block_height || start.block_height > h.highest_block_height))
  {
    problems.emplace_back("start.block_height", metres(start.block_height) + " is outside the block's travel, allowed: " +
                                                    plain(h.lowest_block_height) + " to " + metres(h.highest_block_height));
  }
  const bool on_bottom = start.bit_depth >= scene.well.hole_depth;
  if (start.weight_on_bit > 0.0 && !on_bottom)
    problems.emplace_back("start.weight_on_bit", plain(start.weight_on_bit) +
                                                     " N with the bit off bottom, allowed: 0, or bit_depth equal to hole_depth");
  const auto bent = [](const PartSpec& part) { return part.motor && part.motor->bend != 0.0; };
  if (start.toolface != 0.0 && std::none_of(scene.string.begin(), scene.string.end(), bent))
    problems.emplace_back("start.toolface_deg", "the string has no bend, allowed: 0, or a mud_motor with bend_deg");
  if (start.torque_on_bit > 0.0 && !on_bottom)
    problems.emplace_back(
        "start.torque_on_bit",
        plain(start.torque_on_bit) + " N m with the bit off bottom, allowed: 0, or bit_depth equal to hole_depth");
}

void check_element_length(const char* key, double length, const char* none, ProblemList& problems)
{
  if (length > 0.0 && length < 0.1)
    problems.emplace_back(key, metres(length) + " is given, allowed: 0.1 m to 50 m, or 0 (" + none + ")");
}

void check_step(const NumericsSpec& numerics, ProblemList& problems)
{
  if (numerics.step > 0.0 && numerics.step < 1e-5)
    problems.emplace_back("numerics.step", plain(numerics.step) + " s is given, allowed: 1e-5 s to 0.05 s, or 0 (variable)");
}

/// Telemetry that would be saturated for good: readings would be lost one after the other.
void check_telemetry(const char* key, double period, double latency, ProblemList& problems)
{
  if (period <= 0.0 || latency <= most_on_the_way * period) return;
  problems.emplace_back(key, plain(latency) + " s is more than " + std::to_string(most_on_the_way) + " periods, allowed: up to " +
                                 plain(most_on_the_way * period) + " s");
}

void append(ProblemList& all, const ProblemList& more)
{
  all.insert(all.end(), more.begin(), more.end());
}
}  // namespace

bool is_name(const std::string& text)
{
  constexpr std::size_t longest = 64;
  return !text.empty() && text.size() <= longest &&
         std::all_of(text.begin(), text.end(),
                     [](char c)
                     { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; });
}

ProblemList unavailable(const Scene& scene)
{
  ProblemList problems;
  const NumericsSpec& numerics = scene.numerics;
  const std::string cut = numerics.level == Level::hybrid ? what_it_cuts(scene, numerics.free_length) : std::string();
  if (!cut.empty()) problems.emplace_back("numerics.free_length", cut);
  const bool guided = all_guided(numerics.level) || numerics.level == Level::hybrid;
  if (guided && has_no_levels(numerics.integrator))
    problems.emplace_back("numerics.integrator", "this method is available only for level beam3d");
  if (numerics.has_variable_steps() && !varies_steps(numerics.integrator))
    problems.emplace_back("numerics.integrator", "steps of variable length (step 0) are available only for bdf2 and auto");
  if (scene.rig.heave.amplitude > 0.0 && numerics.integrator == IntegratorKind::ida)
    problems.emplace_back("rig.heave", "not available with the reference (ida)");
  if (scene.rig.heave.amplitude > 0.0 && numerics.level == Level::rigid)
    problems.emplace_back("rig.heave", "not available at level rigid, whose string neither stretches nor swings");
  const bool asked = numerics.companion == CompanionKind::finer || numerics.companion == CompanionKind::coarser;
  if (asked && numerics.integrator == IntegratorKind::ida)
    problems.emplace_back("numerics.companion", "not available with the reference (ida)");
  const bool fixed_step = numerics.step > 0.0 || (numerics.step == step_by_level && numerics.level != Level::automatic);
  if (numerics.companion == CompanionKind::coarser && fixed_step)
    problems.emplace_back("numerics.companion", "coarser needs variable steps (numerics.step: 0)");
  if (!has_kernel(numerics.kernel))
    problems.emplace_back(
        "numerics.kernel",
        std::string(name_of(numerics.kernel)) + " is not available on this machine or in this build, allowed: " + kernels_here());
  return problems;
}

ProblemList scene_problems(const Scene& scene)
{
  ProblemList problems;
  if (!is_name(scene.name)) problems.emplace_back("name", not_a_name);
  append(problems, well_problems(scene.well));
  append(problems, trajectory_problems(scene.trajectory));
  append(problems, unavailable(scene));
  check_formation(scene.formation, problems);
  if (!scene.string.empty() && scene.string[0].bit) check_drag_bit(*scene.string[0].bit, scene.formation, problems);
  check_part_names(scene.string, problems);
  check_element_length("numerics.element_length", scene.numerics.element_length, "chosen from the hole", problems);
  check_element_length("numerics.pushed_element_length", scene.numerics.pushed_element_length, "as element_length", problems);
  check_step(scene.numerics, problems);
  append(problems, string_problems(scene.string, scene.start.bit_depth + scene.start.block_height, element_lengths(scene)));
  check_reaming(scene, problems);
  check_diameters(scene, problems);
  check_hoisting(scene.rig.hoisting, problems);
  check_heave(scene.rig.heave, problems);
  check_oscillation(scene, problems);
  check_connections(scene, problems);
  check_start(scene, problems);
  append(problems, program_problems(scene));
  append(problems, operation_problems(scene));
  check_telemetry("instruments.mwd.latency", scene.instruments.mwd.period, scene.instruments.mwd.latency, problems);
  check_telemetry("instruments.mwd.latency", scene.instruments.mwd.inclination_period, scene.instruments.mwd.latency, problems);
  check_telemetry("instruments.dynamics.latency", scene.instruments.dynamics.period, scene.instruments.dynamics.latency,
                  problems);
  if (scene.instruments.dynamics.from_bit > scene.start.bit_depth)
    problems.emplace_back("instruments.dynamics.from_bit", metres(scene.instruments.dynamics.from_bit) +
                                                               " is above the rotary table, allowed: up to start.bit_depth, " +
                                                               metres(scene.start.bit_depth));
  const auto check_outliers = [&](const char* gauge, const SensorSpec& spec)
  {
    if (spec.outlier_interval > 0.0 && spec.outlier_size == 0.0)
      problems.emplace_back(std::string("instruments.surface.") + gauge + ".outlier_size",
                            "is needed with outlier_interval, allowed: above 0");
  };
#define GAUGE(type, name, ...) check_outliers(#name, scene.instruments.name);
#include "drill_rig_sim/scene/signal_list.h"
  check_telemetry("instruments.toolface.latency", scene.instruments.toolface.period, scene.instruments.toolface.latency,
                  problems);
  return problems;
}

}  // namespace drill_rig_sim
