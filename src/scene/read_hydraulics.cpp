// SPDX-License-Identifier: BSD-3-Clause
#include "read_hydraulics.h"

#include <cmath>
#include <map>

#include "drill_rig_sim/hydraulics/rheology.h"
#include "drill_rig_sim/math/units.h"
#include "number_with_unit.h"
#include "read_fill.h"
#include "scene_keys.h"
#include "yaml_reader.h"

namespace drill_rig_sim
{
namespace
{
constexpr double nozzle_unit = 0.0254 / 32.0;  // [m]

/// Calls read(row, path) for each row of a list that is not empty, and notes its line.
template <class Read>
void read_rows(const YAML::Node& node, const std::string& path, const std::string& allowed, Problems& problems, const Read& read)
{
  if (!node.IsSequence() || node.size() == 0)
    return problems.add(
        path, (node.IsSequence() ? std::string("an empty list") : describe(node)) + " is given, allowed: a list of " + allowed);
  for (std::size_t i = 0; i < node.size(); ++i)
  {
    problems.note(item_key(path, i), line_of(node[i]));
    read(node[i], item_key(path, i));
  }
}

/// Two numbers of a row; false where they are none.
bool read_pair(const YAML::Node& node, const std::string& path, const std::string& allowed, const Range (&ranges)[2],
               const char* const (&units)[2], double (&values)[2], Problems& problems)
{
  if (!node.IsSequence() || node.size() != 2)
  {
    problems.add(path, describe(node) + " is given, allowed: " + allowed);
    return false;
  }
  const bool first = read_number(node[0], path, ranges[0], units[0], values[0], problems);
  return read_number(node[1], path, ranges[1], units[1], values[1], problems) && first;
}

void read_readings(const YAML::Node& node, const std::string& path, RheologySpec& rheology, Problems& problems)
{
  const std::string allowed = "[speed rpm, dial reading deg]";
  bool good = true;
  read_rows(node, path, "rows " + allowed, problems,
            [&](const YAML::Node& row, const std::string& at)
            {
              double values[2] = {};
              good = read_pair(row, at, allowed, {above(0.0, 1000.0), above(0.0, 1000.0)}, {"rpm", ""}, values, problems) && good;
              rheology.readings.push_back({values[0], values[1]});
            });
  const std::string problem = good && !rheology.readings.empty() ? readings_problem(rheology.law, rheology.readings) : "";
  if (!problem.empty()) problems.add(path, problem);
}

/// Either readings or all numbers of the law.
void check_numbers(const YAML::Node& node, const std::string& path, RheologyLaw law, Problems& problems)
{
  const bool has_readings = node["readings"].IsDefined();
  for (const Key<RheologySpec>& key : rheology_keys.keys)
  {
    if (key.kinds == every_kind || !(key.kinds & kind(law))) continue;
    const bool given = node[key.name].IsDefined();
    if (has_readings && given)
      problems.add(join(path, key.name), "is given together with readings, which define it, allowed: one of the two");
    if (!has_readings && !given)
      problems.add(join(path, key.name), std::string("is missing: ") + key.meaning + "; or give readings");
  }
}

/// Rows of length and diameter.
void read_surface_lines(const YAML::Node& node, const std::string& path, std::vector<SurfaceLine>& lines, Problems& problems)
{
  const std::string allowed = "[length m, diameter m]";
  read_rows(node, path, "rows " + allowed, problems,
            [&](const YAML::Node& row, const std::string& at)
            {
              double values[2] = {};
              if (read_pair(row, at, allowed, {above(0.0, 1000.0), between(0.02, 0.5)}, {"m", "m"}, values, problems))
                lines.push_back({values[0], values[1]});
            });
}

void read_rheology(const YAML::Node& node, const std::string& path, RheologySpec& rheology, Problems& problems)
{
  int word = 0;
  if (!node.IsMap() || !node["law"].IsDefined())
    return problems.add(join(path, "law"), "is missing, allowed: " + to_text(rheology_words));
  if (!read_word(node["law"], join(path, "law"), rheology_words, word, problems)) return;
  const std::map<std::string, YAML::Node> entries = read_block(node, path, rheology_keys, 1u << word, rheology, problems);
  const auto readings = entries.find("readings");
  if (readings != entries.end()) read_readings(readings->second, join(path, "readings"), rheology, problems);
  check_numbers(node, path, static_cast<RheologyLaw>(word), problems);
}

void refuse_without_rheology(const char* key, Problems& problems)
{
  if (problems.has(key)) problems.add(key, "has no effect without mud.rheology, allowed: leave it out, or give mud.rheology");
}

void refuse_beside_rheology(const char* key, const char* instead, Problems& problems)
{
  if (problems.has(key))
    problems.add(key, std::string("is given together with mud.rheology, ") + instead + ", allowed: one of the two");
}

/// Whether its viscosity is mud.viscosity.
bool is_by_viscosity(const RheologySpec& rheology)
{
  return rheology.law == RheologyLaw::newtonian && rheology.readings.empty();
}
}  // namespace

void read_mud(const YAML::Node& node, const std::string& path, Scene& scene, Problems& problems)
{
  const std::map<std::string, YAML::Node> entries = read_block(node, path, mud_keys, every_kind, scene.mud, problems);
  const auto fill = entries.find("fill"), rheology = entries.find("rheology"), cuttings = entries.find("cuttings"),
             waves = entries.find("pressure_waves"), temperature = entries.find("temperature");
  if (fill != entries.end()) read_fill(fill->second, join(path, "fill"), scene.mud.fill, problems);
  if (cuttings != entries.end())
    read_block(cuttings->second, join(path, "cuttings"), cuttings_keys, every_kind, scene.cuttings.emplace(), problems);
  if (waves != entries.end())
    read_block(waves->second, join(path, "pressure_waves"), pressure_waves_keys, every_kind, scene.pressure_waves.emplace(),
               problems);
  if (temperature != entries.end())
    read_block(temperature->second, join(path, "temperature"), temperature_keys, every_kind, scene.temperature.emplace(),
               problems);
  if (rheology == entries.end()) return;
  scene.rheology.emplace();
  read_rheology(rheology->second, join(path, "rheology"), *scene.rheology, problems);
}

void read_mud_pump(const YAML::Node& node, const std::string& path, MudPumpSpec& pump, Problems& problems)
{
  const std::map<std::string, YAML::Node> entries = read_block(node, path, mud_pump_keys, every_kind, pump, problems);
  const auto lines = entries.find("surface_lines");
  if (lines != entries.end()) read_surface_lines(lines->second, join(path, "surface_lines"), pump.surface_lines, problems);
}

void read_nozzles(const YAML::Node& node, const std::string& path, std::vector<double>& nozzles, Problems& problems)
{
  read_rows(node, path, "diameters in 1/32 in, 4 to 64, or with a unit", problems,
            [&](const YAML::Node& item, const std::string& at)
            {
              WrittenNumber given;
              const bool has_unit = item.IsScalar() && split_number(item.Scalar(), given) && !given.unit.empty();
              const double unit = has_unit ? 1.0 : nozzle_unit;
              const Range allowed = has_unit ? between(4.0 * nozzle_unit, 64.0 * nozzle_unit) : between(4.0, 64.0);
              double value = 0.0;
              if (!read_number(item, at, allowed, has_unit ? "m" : "1/32 in", value, problems)) return;
              if (!has_unit && value != std::floor(value))
                problems.add(at, plain(value) + " is not a whole number of 1/32 in; if it is in another unit, write it: " +
                                     plain(value) + " mm");
              nozzles.push_back(unit * value);
            });
}

void check_hydraulics(const Scene& scene, Problems& problems)
{
  if (problems.has("string[0].nozzles") && problems.has("string[0].nozzle_area"))
    problems.add("string[0].nozzle_area", "is given together with nozzles, allowed: one of the two");
  if (!scene.rheology)
  {
    for (const char* key : {"string[0].nozzles", "string[0].nozzle_area", "rig.mud_pump.surface_lines", "mud.cuttings",
                            "mud.pressure_waves", "mud.temperature"})
      refuse_without_rheology(key, problems);
    return;
  }
  for (const char* key : {"rig.mud_pump.pressure_coefficient", "rig.mud_pump.loss_exponent"})
    refuse_beside_rheology(key, "which computes the losses", problems);
  if (!is_by_viscosity(*scene.rheology)) refuse_beside_rheology("mud.viscosity", "which defines the viscosity", problems);
  if (is_by_viscosity(*scene.rheology) && scene.mud.viscosity <= 0.0)
    problems.add("mud.viscosity", "0 is given together with a newtonian mud.rheology, allowed: above 0");
  if (scene.mud.density <= 0.0) problems.add("mud.density", "0 is given with a mud.rheology, allowed: above 0");
  if (scene.cuttings && scene.cuttings->density <= scene.mud.density)
    problems.add("mud.cuttings.density", "must be above mud.density");
  if (scene.pressure_waves && !scene.mud.fill.empty())
    problems.add("mud.pressure_waves", "is given together with mud.fill, allowed: one of the two, waves need a full string");
  if (scene.pressure_waves && scene.instruments.stand_pipe_pressure.pump_noise > 0.0)
    problems.add("instruments.surface.stand_pipe_pressure.pump_noise",
                 "is given together with mud.pressure_waves, which computes the pump's strokes, allowed: one of the two");
  if (!scene.string.empty() && scene.string[0].bit && scene.string[0].bit->flow_area() <= 0.0)
    problems.add("string[0].nozzles", "is missing; mud.rheology needs nozzles or nozzle_area of the bit");
}

}  // namespace drill_rig_sim
