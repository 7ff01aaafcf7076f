// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "drill_command.h"
#include "drill_eigenmodes.h"
#include "drill_options.h"
#include "drill_output.h"
#include "drill_rig_sim/math/units.h"
#include "drill_scene.h"

namespace drill_rig_sim
{
namespace
{
using Json = nlohmann::ordered_json;

struct ModesOptions
{
  std::string scene;
  std::vector<std::string> settings;
  std::string family = "apart";
  std::optional<double> count;
  std::optional<double> assembly;
  std::string json;
};

struct NamedFamily
{
  const char* name;
  ModeFamily family;
};
constexpr NamedFamily families[] = {{"axial", ModeFamily::axial},
                                    {"torsional", ModeFamily::torsional},
                                    {"lateral", ModeFamily::lateral},
                                    {"coupled", ModeFamily::coupled}};
constexpr double usual_count = 6.0;

/// What `--family` asks for.
std::vector<NamedFamily> wanted(const std::string& word)
{
  if (word == "apart") return {families[0], families[1], families[2]};
  for (const NamedFamily& f : families)
    if (word == f.name) return {f};
  throw UsageError("--family: '" + word + "' is not known, allowed: apart, axial, torsional, lateral or coupled");
}

struct FamilyModes
{
  const char* name;
  std::vector<Mode> modes;
};

/// The node that is clamped.
int clamp_of(const ModesOptions& options, const Mesh& mesh)
{
  const int top = static_cast<int>(mesh.nodes.size()) - 1;
  return options.assembly ? std::min(node_at(mesh, *options.assembly), top) : top;
}

void print_modes(const FamilyModes& family)
{
  for (std::size_t k = 0; k < family.modes.size(); ++k)
  {
    const Mode& m = family.modes[k];
    if (m.eigenvalue > 0.0)
      std::printf("%-10s %4zu %12.4f %12.2f", family.name, k + 1, m.frequency(), 60.0 * m.frequency());
    else
      std::printf("%-10s %4zu %12s %12s", family.name, k + 1, "unstable", "-");
    std::printf(" %8.1f %8.1f %8.1f\n", 100.0 * m.axial, 100.0 * m.torsional, 100.0 * m.lateral);
  }
}

Json json_of(const Mode& m)
{
  Json shape;
  for (const NodeShape& s : m.shape)
  {
    shape["axial"].push_back(s.axial);
    shape["high_side"].push_back(s.high_side);
    shape["right"].push_back(s.right);
    shape["spin"].push_back(s.spin);
  }
  const bool stable = m.eigenvalue > 0.0;
  return {{"frequency_hz", stable ? Json(m.frequency()) : Json()},
          {"critical_speed_rpm", stable ? Json(60.0 * m.frequency()) : Json()},
          {"eigenvalue", m.eigenvalue},
          {"axial_share", m.axial},
          {"torsional_share", m.torsional},
          {"lateral_share", m.lateral},
          {"shape", shape}};
}

Json json_of(const Scene& scene, const RigAtRest& rig, int clamp, const std::vector<FamilyModes>& found)
{
  Json from_bit;
  for (int i = 0; i <= clamp; ++i) from_bit.push_back(rig.model->mesh().nodes[static_cast<std::size_t>(i)].from_bit);
  Json json = {{"scene", scene.name},
               {"clamped_at_m", rig.model->mesh().nodes[static_cast<std::size_t>(clamp)].from_bit},
               {"weight_on_bit", rig.statics.forces.wob},
               {"torque_on_bit", scene.start.torque_on_bit},
               {"from_bit_m", from_bit}};
  for (const FamilyModes& family : found)
    for (const Mode& m : family.modes) json["modes"][family.name].push_back(json_of(m));
  return json;
}

std::vector<FamilyModes> find_all(const RigAtRest& rig, const std::vector<NamedFamily>& asked, int clamp, int count)
{
  std::vector<FamilyModes> found;
  found.reserve(asked.size());
  for (const NamedFamily& f : asked) found.push_back({f.name, find_modes(rig, f.family, clamp, count)});
  return found;
}

void print_all(const ModesOptions& options)
{
  const std::vector<NamedFamily> asked = wanted(options.family);
  Scene scene = open_scene(options.scene, options.settings);
  scene.numerics.level = Level::beam3d;  // modes are of the beams
  if (is_same_file(options.json, options.scene))
    throw UsageError("--json: " + options.json + " is the scene file, needed: another file");
  File json = open_output("--json", options.json);
  try
  {
    const RigAtRest rig = build_at_rest(scene);
    const int clamp = clamp_of(options, rig.model->mesh());
    const std::vector<FamilyModes> found = find_all(rig, asked, clamp, static_cast<int>(options.count.value_or(usual_count)));
    std::printf("clamped %.2f m above the bit's face, %.1f kN on the bit, %.2f kN m at it\n",
                rig.model->mesh().nodes[static_cast<std::size_t>(clamp)].from_bit, 1e-3 * rig.statics.forces.wob,
                1e-3 * scene.start.torque_on_bit);
    std::printf("%-10s %4s %12s %12s %8s %8s %8s\n", "family", "mode", "frequency/Hz", "critical/rpm", "axial/%", "turn/%",
                "side/%");
    for (const FamilyModes& family : found) print_modes(family);
    if (json) std::fprintf(json.get(), "%s\n", json_of(scene, rig, clamp, found).dump(2).c_str());
  }
  catch (const std::runtime_error& e)
  {
    throw ComputationError(scene.file + ": " + e.what());
  }
  if (json) close_output(std::move(json), options.json);
}
}  // namespace

Command add_modes_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("modes", "natural frequencies of the string in its equilibrium, and critical speeds");
  const auto options = std::make_shared<ModesOptions>();
  add_file(*words, "SCENE", options->scene, "the scene's file");
  add_text(
      *words, "--family", options->family, "F",
      "apart (axial, torsional and lateral motions each by itself, the default), one of those three, or coupled (all together)");
  add_number(*words, "--modes", options->count, 1, 100, "N", "how many of each family, the lowest; default: 6");
  add_number(*words, "--assembly", options->assembly, 0.1, 20000, "M",
             "only the lowest M metres, clamped at the node nearest there; default: the whole string");
  add_text(*words, "--json", options->json, "FILE", "writes frequencies and shapes");
  add_settings(*words, options->settings);
  return {words, [options] { print_all(*options); }};
}

}  // namespace drill_rig_sim
