// SPDX-License-Identifier: BSD-3-Clause
#include "unlikely_numbers.h"

#include <cmath>
#include <cstdio>

#include "drill_rig_sim/hydraulics/rheology.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/problem.h"
#include "sized_number.h"
#include "unlikely_parts.h"

namespace drill_rig_sim
{
namespace
{
constexpr double usual_weight = 100e3,
                 usual_speed = 10.0;  // on the bit and of it, at which rates of rocks are compared [N], [rad/s]
constexpr double slowest = 0.001 / 3600.0, fastest = 2e4 / 3600.0;  // that rocks drill so [m/s]
constexpr double most_flow = 0.15;                                  // of the pumps of a rig [m3/s]
constexpr double rate_at_300_rpm = 300.0 * shear_rate_per_rpm;      // of a viscometer [1/s]
constexpr double most_stress = 300.0 * stress_per_dial_degree;      // that it shows [Pa]
constexpr double least_weight = 500.0, least_flow = 5e-4;           // [N], [m3/s]
constexpr double widest_hole = 2.5;                                 // over the bit's diameter
constexpr double most_strokes = 15.0;                               // of several triplex pumps [1/s]

std::string line_of(const SizedNumber& one)
{
  const std::string unit = one.unit;
  return one.key + ": " + plain(one.value) + (unit.empty() ? "" : " " + unit) +
         (one.value < one.least ? " is less than " : " is more than ") + one.usual +
         (unit.empty() ? "; is it right?" : "; is its unit right?");
}

void add_rig(const RigSpec& rig, std::vector<SizedNumber>& all)
{
  const std::string hoisting = "rig.hoisting.", drive = "rig.top_drive.", pump = "rig.mud_pump.";
  all.push_back({hoisting + "block_mass", rig.hoisting.block_mass, 300.0, any_size, "kg", "blocks weigh (1 to 60 t)"});
  all.push_back({hoisting + "max_hook_load", rig.hoisting.max_hook_load, 2e4, any_size, "N", "rigs lift (50 kN to 10 MN)"});
  all.push_back({hoisting + "sheaves", 1.0 * rig.hoisting.sheaves, 0.0, 8.0, "",
                 "travelling blocks have (3 to 8, with twice as many lines)"});
  all.push_back({hoisting + "line_ea", rig.hoisting.line_ea, 5e6, any_size, "N", "drill lines have (20 to 80 MN)"});
  all.push_back({hoisting + "max_speed", rig.hoisting.max_speed, 0.0, 5.0, "m/s", "blocks move with (up to 2.5 m/s)"});
  all.push_back({hoisting + "crown_height", rig.hoisting.crown_height, 0.0, 90.0, "m", "masts are high (10 to 65 m)"});
  all.push_back({drive + "max_torque", rig.top_drive.max_torque, 500.0, any_size, "N m", "drives turn with (2 to 150 kN m)"});
  all.push_back({drive + "max_power", rig.top_drive.max_power, 5e3, any_size, "W", "drives have (50 kW to 2 MW)"});
  all.push_back({drive + "inertia", rig.top_drive.inertia, 50.0, 5e4, "kg m2", "rotors have at the shaft (500 to 6000 kg m2)"});
  all.push_back({pump + "max_flow", rig.mud_pump.max_flow, 0.0, most_flow, "m3/s", "pumps of a rig deliver (up to 0.13 m3/s)"});
  all.push_back(
      {pump + "relief_pressure", rig.mud_pump.relief_pressure, 1e6, any_size, "Pa", "relief valves open at (10 to 50 MPa)"});
  if (rig.mud_pump.trip_pressure > 0.0)
    all.push_back(
        {pump + "trip_pressure", rig.mud_pump.trip_pressure, 1e6, any_size, "Pa", "pumps are stopped at (10 to 50 MPa)"});
  all.push_back({pump + "stroke_volume", rig.mud_pump.stroke_volume, std::fmin(rig.mud_pump.max_flow, most_flow) / most_strokes,
                 any_size, "m3", "a stroke delivers at max_flow and 900 strokes a minute"});
  all.push_back({"rig.heave.amplitude", rig.heave.amplitude, 0.0, 4.0, "m", "rigs heave by while they drill (up to 3 m)"});
}

void add_mud(const Scene& scene, std::vector<SizedNumber>& all)
{
  if (scene.mud.density > 0.0)
    all.push_back({"mud.density", scene.mud.density, 0.0, 2550.0, "kg/m3", "muds weigh (800 to 2400 kg/m3)"});
  all.push_back(
      {"mud.gel_strength", scene.mud.gel_strength, 0.0, 60.0, "Pa", "muds have (2 to 15 Pa; 1 lb/100 ft2 is 0.479 Pa)"});
  if (!scene.rheology)
    all.push_back(
        {"mud.viscosity", scene.mud.viscosity, 0.0, most_stress / rate_at_300_rpm, "Pa s", "muds have (0.005 to 0.06 Pa s)"});
  else
    all.push_back({"mud.rheology", shear_stress(curve_of(*scene.rheology, scene.mud.viscosity), rate_at_300_rpm), 0.0,
                   most_stress, "Pa at 300 rpm of a viscometer", "it can show (muds have 3 to 70 Pa)"});
}

void add_waves(const PressureWavesSpec& waves, std::vector<SizedNumber>& all)
{
  const std::string key = "mud.pressure_waves.";
  if (waves.pulse_height > 0.0)
    all.push_back({key + "pulse_height", waves.pulse_height, 1e4, any_size, "Pa", "pulsers make (0.3 to 3 MPa)"});
  if (waves.dampener_pressure > 0.0)
    all.push_back(
        {key + "dampener_pressure", waves.dampener_pressure, 1e5, any_size, "Pa", "dampeners are charged with (2 to 15 MPa)"});
}

void add_rock(const std::vector<FormationLayer>& rock, std::vector<SizedNumber>& all)
{
  for (std::size_t i = 0; i < rock.size(); ++i)
    if (rock[i].threshold > 0.0)
      all.push_back(
          {item_key("formation", i, "threshold"), rock[i].threshold, 100.0, 2.5e5, "N", "rocks break at (1 to 100 kN)"});
}

void add_loads(const Scene& scene, std::vector<SizedNumber>& all)
{
  const char* usual = "bits drill with (5 to 300 kN)";
  if (scene.start.weight_on_bit > 0.0)
    all.push_back({"start.weight_on_bit", scene.start.weight_on_bit, least_weight, any_size, "N", usual});
  for (std::size_t i = 0; i < scene.operations.size(); ++i)
    if (traits_of(scene.operations[i].kind).drills)
      all.push_back({item_key("operations", i, "weight"), scene.operations[i].weight, least_weight, any_size, "N", usual});
  for (std::size_t i = 0; i < scene.program.size(); ++i)
    if (scene.program[i].flow > 0.0)
      all.push_back({item_key("program", i, "flow"), scene.program[i].flow, least_flow, any_size, "m3/s",
                     "pumps of a rig deliver (0.005 to 0.1 m3/s)"});
}

void add_hole(const Scene& scene, std::vector<SizedNumber>& all)
{
  const std::vector<HoleSection>& sections = scene.well.sections;
  for (std::size_t i = 0; i < sections.size(); ++i)
    all.push_back({item_key("well.sections", i, "friction"), sections[i].friction, 0.0, 1.0, "",
                   "steel has on rock or casing (0.05 to 0.5)"});
  all.push_back({item_key("well.sections", sections.size() - 1, "diameter"), sections.back().diameter, 0.0,
                 widest_hole * scene.string.front().bit->diameter, "m", "the bit and washouts make"});
}

void add_temperatures(const MudTemperatureSpec& spec, std::vector<SizedNumber>& all)
{
  const std::string key = "mud.temperature.";
  all.push_back({key + "inlet", spec.inlet, -any_size, 75.0, "degC", "mud is pumped in at (10 to 60 degC; 80 degF are 27 degC)"});
  all.push_back({key + "surface", spec.surface, -any_size, 40.0, "degC", "the ground has (60 degF are 16 degC)"});
  if (spec.gradient > 0.0)
    all.push_back({key + "gradient", spec.gradient, 0.005, any_size, "K/m", "the ground has (0.015 to 0.06 K/m)"});
  // others are those of tests at high temperature and pressure
  if (spec.rheology_temperature == 120.0 || spec.rheology_temperature == 150.0)
    all.push_back({key + "rheology_temperature", spec.rheology_temperature, -any_size, 99.0, "degC",
                   "muds are usually tested at (120 and 150 degF are 49 and 66 degC)"});
  if (spec.circulated > 0.0)
    all.push_back({key + "circulated", spec.circulated, 60.0, any_size, "s", "changes a temperature (6 h are 21600 s)"});
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
  std::vector<SizedNumber> all = part_sizes(scene);
  add_rig(scene.rig, all);
  add_mud(scene, all);
  add_rock(scene.formation, all);
  add_loads(scene, all);
  add_hole(scene, all);
  if (scene.pressure_waves) add_waves(*scene.pressure_waves, all);
  if (scene.temperature) add_temperatures(*scene.temperature, all);
  std::vector<std::string> lines;
  for (const SizedNumber& one : all)
    if (one.value < one.least || one.value > one.most) lines.push_back(line_of(one));
  for (std::size_t i = 0; i < scene.formation.size(); ++i)
    if (const std::string line = rate_of(scene.formation[i], i); !line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace drill_rig_sim
