// SPDX-License-Identifier: BSD-3-Clause
// Numbers of a scene that are in range and of a size that no rig has: reported by key; those of rigs are not.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "mud_scene.h"

namespace test_scene_unlikely
{
using namespace drill_rig_sim;
using namespace mud_scene;

namespace
{
std::vector<std::string> remarks(const std::string& setting)
{
  return parse_scene(scene_text(rheology + ", temperature: {}"), "s.yaml", {setting}).remarks;
}
}  // namespace

TEST(SceneUnlikely, SlipsOfUnitsAreReported)
{
  const std::vector<std::pair<std::string, std::string>> slips = {
      {"rig.hoisting.block_mass=20", "20 kg is less than blocks weigh"},                        // t
      {"rig.hoisting.crown_height=150", "150 m is more than masts are high"},                   // ft
      {"rig.top_drive.max_torque=50", "50 N m is less than drives turn with"},                  // kN m
      {"rig.top_drive.max_power=1000", "1000 W is less than drives have"},                      // hp
      {"rig.mud_pump.max_flow=0.6", "0.6 m3/s is more than pumps of a rig deliver"},            // 600 gpm
      {"rig.mud_pump.relief_pressure=350000", "350000 Pa is less than relief valves open at"},  // hundreds of kPa
      {"rig.mud_pump.stroke_volume=0.00016", "0.00016 m3 is less than a stroke delivers"},      // a hundredth
      {"rig.hoisting.sheaves=12", "12 is more than travelling blocks have"},                    // lines
      {"rig.hoisting.line_ea=400000", "400000 N is less than drill lines have"},                // a hundredth
      {"rig.hoisting.max_speed=15", "15 m/s is more than blocks move with"},                    // m/min
      {"rig.top_drive.inertia=60000", "60000 kg m2 is more than rotors have"},                  // lb ft2
      {"rig.mud_pump.trip_pressure=30000", "30000 Pa is less than pumps are stopped"},          // kPa
      {"rig.heave.amplitude=6.5", "6.5 m is more than rigs heave"},                             // ft
      {"mud.density=2900", "2900 kg/m3 is more than muds weigh"},                               // a wrong digit
      {"mud.gel_strength=90", "90 Pa is more than muds have"},                                  // lb/100 ft2
      {"mud.temperature.gradient=0.0003", "0.0003 K/m is less than the ground has"},
      {"formation[0].threshold=5", "5 N is less than rocks break at"},  // kN
      {"formation[0].threshold=500000", "500000 N is more than rocks break at"},
      {"well.sections[0].diameter=1.5", "1.5 m is more than the bit and washouts make"},
      {"string[0].length=30", "30 m is more than bits are long"},  // cm
      {"string[1].yield_strength=9.3e6", "9.3e+06 Pa is less than pipe stands"},
      {"string[1].make_up_torque=25", "25 N m is less than joints are made up with"},  // kft.lbf
      {"well.sections[0].friction=2.5", "2.5 is more than steel has on rock or casing (0.05 to 0.5); is it right?"},
      {"formation[0].drillability=1.0e-4", "drills 3.6e+05 m/h with 100 kN at 95 rpm"},
      {"formation[0].drillability=1.0e-14", "drills 3.6e-05 m/h"},
      {"mud.temperature.inlet=80", "80 degC is more than mud is pumped in at"},  // degF
      {"mud.temperature.surface=60", "60 degC is more than the ground has"},
      {"mud.temperature.rheology_temperature=120", "120 degC is more than muds are usually tested at"},
      {"mud.temperature.circulated=6", "6 s is less than changes a temperature"}};  // h
  for (const auto& [setting, said] : slips)
  {
    const std::vector<std::string> lines = remarks(setting);
    const std::string key = setting.substr(0, setting.find('='));
    ASSERT_EQ(1u, lines.size()) << setting << (lines.empty() ? "" : lines[0]);
    EXPECT_EQ(0u, lines[0].rfind("s.yaml: " + key + ": ", 0)) << lines[0];
    EXPECT_NE(std::string::npos, lines[0].find(said)) << lines[0];
  }
}

TEST(SceneUnlikely, WhatRigsHaveIsNot)
{
  for (const char* setting : {"name=s",
                              "rig.hoisting.block_mass=500",
                              "rig.hoisting.sheaves=8",
                              "rig.hoisting.crown_height=65",
                              "rig.top_drive.max_torque=2000",
                              "rig.top_drive.max_power=50e3",
                              "rig.mud_pump.max_flow=0.13",
                              "rig.mud_pump.relief_pressure=3e6",
                              "rig.mud_pump.stroke_volume=0.0053",
                              "rig.hoisting.sheaves=8",
                              "rig.hoisting.line_ea=15e6",
                              "rig.hoisting.max_speed=3",
                              "rig.top_drive.inertia=300",
                              "rig.mud_pump.trip_pressure=5e6",
                              "rig.heave.amplitude=3",
                              "mud.density=2400",
                              "mud.gel_strength=30",
                              "mud.temperature.gradient=0.01",
                              "mud.temperature.gradient=0",
                              "formation[0].threshold=1000",
                              "formation[0].threshold=100e3",
                              "well.sections[0].diameter=0.4",
                              "string[0].length=1.2",
                              "string[1].yield_strength=276e6",
                              "string[1].make_up_torque=3000",
                              "well.sections[0].friction=0.8",
                              "formation[0].drillability=1e-7",
                              "formation[0].drillability=1e-10",
                              "mud.temperature.inlet=65",
                              "mud.temperature.surface=35",
                              "mud.temperature.surface=-10",
                              "mud.temperature.rheology_temperature=65",
                              "mud.temperature.rheology_temperature=177",
                              "mud.temperature.circulated=1 h"})
    EXPECT_TRUE(remarks(setting).empty()) << setting << ": " << remarks(setting).front();
}

// 300 rpm of a viscometer are 511 1/s, 300 deg of its dial 153 Pa.
TEST(SceneUnlikely, MudThatNoViscometerShowsIsReported)
{
  const auto said = [](const std::string& mud)
  {
    const std::vector<std::string> lines = parse_scene(scene_text(mud), "s.yaml", {}).remarks;
    return lines.empty() ? "" : lines.front();
  };
  EXPECT_EQ(
      said(", rheology: {law: bingham, plastic_viscosity: 0.9, yield_point: 7}"),
      "s.yaml: mud.rheology: 466.81 Pa at 300 rpm of a viscometer is more than it can show (muds have 3 to 70 Pa); is its unit "
      "right?");
  EXPECT_NE(said(", rheology: {law: herschel_bulkley, readings: [[600, 650], [300, 390], [6, 70], [3, 50]]}"), "");
  EXPECT_NE(said(", rheology: {law: power_law, consistency: 50, index: 0.7}"), "");
  for (const char* law : {"{law: bingham, plastic_viscosity: 120 cP, yield_point: 60 lb/100ft2}",
                          "{law: herschel_bulkley, readings: [[600, 290], [300, 190], [6, 20], [3, 15]]}"})
    EXPECT_EQ(said(std::string(", rheology: ") + law), "") << law;
  const auto without = [](const char* viscosity)
  { return parse_scene(scene_text("", ""), "s.yaml", {std::string("mud.viscosity=") + viscosity}).remarks.size(); };
  EXPECT_EQ(without("0.9"), 1u);
  EXPECT_EQ(without("60 cP"), 0u);
}

TEST(SceneUnlikely, LoadsAndFlowsOfTheProgramAre)
{
  const auto said = [](const std::string& end)
  {
    const std::vector<std::string> lines = parse_scene(scene_text(rheology, nozzles, end), "s.yaml", {}).remarks;
    return lines.empty() ? "" : lines.front();
  };
  EXPECT_NE(said("operations: [{do: flow, flow: 0.03, ramp: 1}, {do: drill, weight: 20, distance: 5}]\n")
                .find("operations[1].weight: 20 N is less than bits drill with"),
            std::string::npos);
  EXPECT_NE(said("program: [{at: 0, flow: 0.00035}]\n").find("program[0].flow: 0.00035 m3/s is less than pumps of a rig deliver"),
            std::string::npos);
  EXPECT_EQ(said("operations: [{do: drill, weight: 2000, distance: 5}]\n"), "");
  EXPECT_EQ(said("program: [{at: 0, flow: 0}, {at: 5, flow: 0.001}]\n"), "");
}

TEST(SceneUnlikely, PlansInRadiansAre)
{
  const auto said = [](const std::string& stations)
  {
    const std::vector<std::string> lines =
        parse_scene(
            "name: m\nwell: {stations: [" + stations +
                "], sections: [{to: 3500, diameter: 0.2159, friction: 0.2}]}\n"
                "formation: [{to_tvd: 5000, drillability: 1.0e-8}]\nstring:\n  - {name: bit, type: bit, length: 0.3, mass: 50, "
                "diameter: 0.2159}\n  - {name: p, type: pipe, joints: fill, joint_length: 9.5, outer_diameter: 0.127, "
                "inner_diameter: 0.1086, linear_mass: 32}\nstart: {bit_depth: 990}\n",
            "s.yaml", {})
            .remarks;
    return lines.empty() ? "" : lines.front();
  };
  EXPECT_EQ(said("[0, 0, 0], [1500, 0, 0.7854], [2200, 0.7854, 0.7854], [3500, 0.7854, 0.7854]"),
            "s.yaml: well.stations: inclinations such as 0.7854 deg look like radians (45 deg); is the unit right? As degrees "
            "the hole is "
            "vertical within 0.7854 deg");
  for (const char* in_degrees : {"[0, 0, 0], [1500, 0, 45], [2200, 0.79, 45], [3500, 0.79, 45]",
                                 "[0, 0, 0], [2200, 1, 45], [3500, 0.5, 45]", "[0, 0, 0], [2200, 0.5236, 45], [3500, 0.6, 45]"})
    EXPECT_EQ(said(in_degrees), "") << in_degrees;
  EXPECT_NE(said("[0, 90, 0], [3500, 89, 0]").find("the hole begins with 90 deg of inclination at the rotary table"),
            std::string::npos);
}

TEST(SceneUnlikely, PressuresOfWavesAre)
{
  const auto said = [](const std::string& waves)
  { return parse_scene(scene_text(rheology + ", pressure_waves: {" + waves + "}"), "s.yaml", {}).remarks.size(); };
  EXPECT_EQ(said(""), 0u);
  EXPECT_EQ(said("pulse_height: 20"), 1u);        // bar
  EXPECT_EQ(said("dampener_pressure: 650"), 1u);  // psi
  EXPECT_EQ(said("pulse_height: 20 bar, dampener_pressure: 650 psi"), 0u);
}

// API RP 7G, drill pipe with the joints of its grades: nominal weights of 19.5, 16.6 and 21.9 lb/ft; with tool joints 20.9
// to 26.2.
TEST(SceneUnlikely, NominalWeightsOfPipeAreReported)
{
  struct Pipe
  {
    double outer, inner, tool_joint;  // [in]
    double nominal;                   // [lb/ft]
    std::vector<double> with_joints;
  };
  const std::vector<Pipe> pipes = {{5.0, 4.276, 6.375, 19.5, {20.89, 21.40, 22.58}},
                                   {4.5, 3.826, 6.25, 16.6, {18.14, 18.37, 18.79}},
                                   {5.5, 4.778, 7.0, 21.9, {23.77, 24.41, 26.2}}};
  const auto said = [](const Pipe& pipe, double tool_joint, double weight)
  {
    const auto set = [](const char* key, double value, const char* unit)
    { return "string[1]." + std::string(key) + "=" + std::to_string(value) + " " + unit; };
    return parse_scene(scene_text(rheology), "s.yaml",
                       {set("outer_diameter", pipe.outer, "in"), set("inner_diameter", pipe.inner, "in"),
                        set("tool_joint_diameter", tool_joint, "in"), set("linear_mass", weight, "lbm/ft")})
        .remarks;
  };
  for (const Pipe& pipe : pipes)
  {
    const std::vector<std::string> lines = said(pipe, pipe.tool_joint, pipe.nominal);
    ASSERT_EQ(1u, lines.size()) << pipe.outer;
    EXPECT_NE(std::string::npos, lines[0].find("is it the nominal weight, without them?")) << lines[0];
    EXPECT_TRUE(said(pipe, pipe.outer, pipe.nominal).empty()) << "flush pipe";
    for (const double weight : pipe.with_joints) EXPECT_TRUE(said(pipe, pipe.tool_joint, weight).empty()) << weight;
  }
}
}  // namespace test_scene_unlikely
