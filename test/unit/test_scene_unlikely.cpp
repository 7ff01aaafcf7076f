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
      {"rig.hoisting.block_mass=20", "20 kg is less than blocks weigh"},  // t
      {"rig.hoisting.sheaves=10",
       "10 is more than travelling blocks have (2 to 8); lines strung are twice as many; is it right?"},  // lines
      {"rig.hoisting.crown_height=150", "150 m is more than masts are high"},                             // ft
      {"rig.top_drive.max_torque=50", "50 N m is less than drives turn with"},                            // kN m
      {"rig.top_drive.max_power=1000", "1000 W is less than drives have"},                                // hp
      {"rig.mud_pump.max_flow=0.6", "0.6 m3/s is more than pumps of a rig deliver"},                      // 600 gpm
      {"rig.mud_pump.relief_pressure=350000", "350000 Pa is less than relief valves open at"},            // hundreds of kPa
      {"rig.mud_pump.stroke_volume=0.00016", "0.00016 m3 is less than a stroke delivers"},                // a hundredth
      {"string[0].length=30", "30 m is more than bits are long"},                                         // cm
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
