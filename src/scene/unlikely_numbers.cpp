// SPDX-License-Identifier: BSD-3-Clause
#include "unlikely_numbers.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/problem.h"

namespace drill_rig_sim
{
namespace
{
constexpr double any = std::numeric_limits<double>::infinity();
constexpr double usual_weight = 100e3,
                 usual_speed = 10.0;  // on the bit and of it, at which rates of rocks are compared [N], [rad/s]
constexpr double slowest = 0.001 / 3600.0, fastest = 2e4 / 3600.0;  // that rocks drill so [m/s]
constexpr double most_flow = 0.15;                                  // of the pumps of a rig [m3/s]
constexpr double most_strokes = 15.0;                               // of several triplex pumps [1/s]

/// A number and the sizes that it has on rigs.
struct Sized
{
  std::string key;
  double value;
  double least, most;
  const char* unit;
  const char* usual;  ///< what has such sizes, for the line
};

std::string line_of(const Sized& one)
{
  const std::string unit = one.unit;
  return one.key + ": " + plain(one.value) + (unit.empty() ? "" : " " + unit) +
         (one.value < one.least ? " is less than " : " is more than ") + one.usual +
         (unit.empty() ? "; is it right?" : "; is its unit right?");
}

void add_rig(const RigSpec& rig, std::vector<Sized>& all)
{
  const std::string hoisting = "rig.hoisting.", drive = "rig.top_drive.", pump = "rig.mud_pump.";
  all.push_back({hoisting + "block_mass", rig.hoisting.block_mass, 300.0, any, "kg", "blocks weigh (1 to 60 t)"});
  all.push_back({hoisting + "sheaves", static_cast<double>(rig.hoisting.sheaves), 0.0, 8.0, "",
                 "travelling blocks have (2 to 8); lines strung are twice as many"});
  all.push_back({hoisting + "max_hook_load", rig.hoisting.max_hook_load, 2e4, any, "N", "rigs lift (50 kN to 10 MN)"});
  all.push_back({hoisting + "crown_height", rig.hoisting.crown_height, 0.0, 90.0, "m", "masts are high (10 to 65 m)"});
  all.push_back({drive + "max_torque", rig.top_drive.max_torque, 500.0, any, "N m", "drives turn with (2 to 150 kN m)"});
  all.push_back({drive + "max_power", rig.top_drive.max_power, 5e3, any, "W", "drives have (50 kW to 2 MW)"});
  all.push_back({pump + "max_flow", rig.mud_pump.max_flow, 0.0, most_flow, "m3/s", "pumps of a rig deliver (up to 0.13 m3/s)"});
  all.push_back({pump + "relief_pressure", rig.mud_pump.relief_pressure, 1e6, any, "Pa", "relief valves open at (10 to 50 MPa)"});
  all.push_back({pump + "stroke_volume", rig.mud_pump.stroke_volume, std::fmin(rig.mud_pump.max_flow, most_flow) / most_strokes,
                 any, "m3", "a stroke delivers at max_flow and 900 strokes a minute"});
}

void add_string(const std::vector<PartSpec>& string, std::vector<Sized>& all)
{
  for (std::size_t i = 0; i < string.size(); ++i)
  {
    const PartSpec& part = string[i];
    const std::string key = "string[" + std::to_string(i) + "].";
    if (part.bit) all.push_back({key + "length", part.length, 0.0, 3.0, "m", "bits are long (up to 1 m)"});
    if (part.type != PartType::pipe) continue;
    all.push_back({key + "yield_strength", part.yield_strength, 5e7, any, "Pa", "pipe stands (200 MPa to 1.2 GPa)"});
    if (part.make_up_torque > 0.0 && part.outer_diameter > 0.06)
      all.push_back({key + "make_up_torque", part.make_up_torque, 300.0, any, "N m", "joints are made up with (2 to 100 kN m)"});
  }
}

void add_hole(const Scene& scene, std::vector<Sized>& all)
{
  for (std::size_t i = 0; i < scene.well.sections.size(); ++i)
    all.push_back({"well.sections[" + std::to_string(i) + "].friction", scene.well.sections[i].friction, 0.0, 1.0, "",
                   "steel has on rock or casing (0.05 to 0.5)"});
}

void add_temperatures(const MudTemperatureSpec& spec, std::vector<Sized>& all)
{
  const std::string key = "mud.temperature.";
  all.push_back({key + "inlet", spec.inlet, -any, 75.0, "degC", "mud is pumped in at (10 to 60 degC; 80 degF are 27 degC)"});
  all.push_back({key + "surface", spec.surface, -any, 40.0, "degC", "the ground has (60 degF are 16 degC)"});
  // others are those of tests at high temperature and pressure
  if (spec.rheology_temperature == 120.0 || spec.rheology_temperature == 150.0)
    all.push_back({key + "rheology_temperature", spec.rheology_temperature, -any, 99.0, "degC",
                   "muds are usually tested at (120 and 150 degF are 49 and 66 degC)"});
  if (spec.circulated > 0.0)
    all.push_back({key + "circulated", spec.circulated, 60.0, any, "s", "changes a temperature (6 h are 21600 s)"});
}

std::string rate_of(const FormationLayer& layer, std::size_t place)
{
  const double rate = layer.drillability * std::pow(std::fmax(usual_weight - layer.threshold, 0.0), layer.weight_exponent) *
                      std::pow(usual_speed, layer.speed_exponent);
  if (usual_weight <= layer.threshold || (rate >= slowest && rate <= fastest)) return "";
  char text[200];
  std::snprintf(text, sizeof text,
                "formation[%zu].drillability: %g drills %.3g m/h with %g kN at %.0f rpm; is it in m/s, N and rad/s?", place,
                layer.drillability, 3600.0 * rate, 1e-3 * usual_weight, usual_speed / rpm);
  return text;
}
}  // namespace

std::vector<std::string> unlikely_numbers(const Scene& scene)
{
  std::vector<Sized> all;
  add_rig(scene.rig, all);
  add_string(scene.string, all);
  add_hole(scene, all);
  if (scene.temperature) add_temperatures(*scene.temperature, all);
  std::vector<std::string> lines;
  for (const Sized& one : all)
    if (one.value < one.least || one.value > one.most) lines.push_back(line_of(one));
  for (std::size_t i = 0; i < scene.formation.size(); ++i)
    if (const std::string line = rate_of(scene.formation[i], i); !line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace drill_rig_sim
