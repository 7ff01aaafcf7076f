// SPDX-License-Identifier: BSD-3-Clause
// Numbers of the string that are in range and of a size that no part has, as of a missing unit: reported by key.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "drill_rig_sim/scene/read_scene.h"

namespace test_scene_unlikely_parts
{
using namespace drill_rig_sim;

namespace
{
const char* const text = R"(name: parts
well: {stations: [[0, 0, 0], [1000, 0, 0]], sections: [{to: 1000, diameter: 0.2159, friction: 0.2}]}
formation: [{to_tvd: 5000, drillability: 1.0e-8}]
mud: {density: 1200, rheology: {law: bingham, plastic_viscosity: 0.02, yield_point: 7}}
string:
  - {name: bit, type: bit, length: 0.3, mass: 50, diameter: 0.2159, nozzle_area: 3.0e-4}
  - {name: motor, type: mud_motor, length: 8, outer_diameter: 0.171, inner_diameter: 0.08, linear_mass: 150, bit_to_bend: 2,
     bend_deg: 1.2, displacement_per_rev: 0.0135, stall_torque: 12000}
  - {name: stab, type: stabilizer, length: 1.5, outer_diameter: 0.171, inner_diameter: 0.0714, linear_mass: 150,
     blade_diameter: 0.2127}
  - {name: collar, type: collar, joints: 6, joint_length: 9.4, outer_diameter: 0.165, inner_diameter: 0.0714, linear_mass: 136}
  - {name: pipe, type: pipe, joints: fill, joint_length: 9.6, outer_diameter: 0.127, inner_diameter: 0.1086, linear_mass: 32.6,
     tool_joint_diameter: 0.168}
start: {bit_depth: 990}
)";

std::vector<std::string> remarks(const std::vector<std::string>& settings)
{
  return parse_scene(text, "s.yaml", settings).remarks;
}
}  // namespace

TEST(SceneUnlikelyParts, SlipsOfUnitsAreReported)
{
  const std::vector<std::pair<std::string, std::string>> slips = {
      {"string[0].mass=4000",
       "4000 kg is more than a bit of its diameter and length weighs"},  // more than twice as much as steel
      {"string[0].mass=4", "4 kg is less than a bit of its diameter and length weighs"},
      {"string[0].nozzle_area=0.09", "0.09 m2 is more than a bit of its diameter has open"},  // the face has 0.0366 m2
      {"string[0].torque={static: 4, kinetic: 3}", "4 is more than bits have"},
      {"string[1].length=26", "26 m is more than motors are long"},                       // ft
      {"string[1].bit_to_bend=6.56", "6.56 m is more than the bend of motors"},           // ft
      {"string[1].bend_deg=0.0209", "0.0209 deg is less than motors are bent by"},        // rad
      {"string[1].stall_torque=12", "12 N m is less than a motor of its displacement"},   // kN m: 5.6 kPa across it
      {"string[1].displacement_per_rev=0.00135", "0.00135 m3/rev is less than a motor"},  // a tenth
      {"string[4].yield_strength=135 MPa", "1.35e+08 Pa is less than pipe stands"},       // ksi
      {"string[2].length=15", "15 m is more than stabilizers are long"},
      {"string[3].joint_length=29.5", "29.5 m is more than joints are long"},  // ft
      {"string[4].joint_length=30", "30 m is more than joints are long"},
      {"string[4].tool_joint_diameter=0.2155", "0.2155 m is more than leaves the mud a way up"}};
  for (const auto& [setting, said] : slips)
  {
    const std::vector<std::string> lines = remarks({setting});
    ASSERT_FALSE(lines.empty()) << setting;
    EXPECT_NE(std::string::npos, lines[0].find(said)) << lines[0];
  }
}

TEST(SceneUnlikelyParts, WhatTheTradeHasIsNot)
{
  // rev/gal of power sections: 9 5/8 in 0.09, 6 3/4 in 1.0 and 0.26, 4 3/4 in 0.55; with their stall torques [ft.lbf]
  struct Motor
  {
    double diameter, revolutions, stall;
  };
  for (const Motor& m : {Motor{0.2445, 0.09, 40e3}, {0.1715, 1.0, 4.5e3}, {0.1715, 0.26, 15e3}, {0.1207, 0.55, 4.5e3}})
    EXPECT_TRUE(remarks({"string[0].diameter=0.311", "well.sections[0].diameter=0.311", "string[0].mass=120",
                         "string[1].outer_diameter=" + std::to_string(m.diameter),
                         "string[1].linear_mass=" + std::to_string(0.8 * 7850.0 * m.diameter * m.diameter),
                         "string[1].inner_diameter=" + std::to_string(0.2 * m.diameter),
                         "string[1].displacement_per_rev=" + std::to_string(1.0 / m.revolutions) + " galUS/rev",
                         "string[1].stall_torque=" + std::to_string(m.stall) + " ft.lbf"})
                    .empty())
        << m.diameter << ' ' << m.revolutions;
  for (const char* setting :
       {"name=s", "string[0].mass=90", "string[0].mass=20", "string[0].nozzle_area=2.5e-3", "string[1].bend_deg=0",
        "string[1].bend_deg=3", "string[4].joint_length=14.5", "string[3].joint_length=13.5"})
    EXPECT_TRUE(remarks({setting}).empty()) << setting << ": " << remarks({setting}).front();
}

// Coiled tubing has no joints: its elements may be as long as they are allowed to be.
TEST(SceneUnlikelyParts, PipeWithoutToolJointsMayBeInLongPieces)
{
  EXPECT_TRUE(remarks({"string[4].joint_length=30", "string[4].tool_joint_diameter=0.127", "string[4].linear_mass=27"}).empty());
}
}  // namespace test_scene_unlikely_parts
