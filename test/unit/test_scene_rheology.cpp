// SPDX-License-Identifier: BSD-3-Clause
// mud.rheology, nozzles and surface lines: read, written back, hashed; what lacks, contradicts or has no effect is refused with
// its place.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/scene_hash.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/scene/write_scene.h"

namespace test_scene_rheology
{
using namespace drill_rig_sim;

namespace
{
const std::string bingham = "{law: bingham, plastic_viscosity: 20 cP, yield_point: 15 lb/100ft2}";

/// The mud's and the bit's own keys stand at line 4 and 5.
std::string scene_text(const std::string& mud, const std::string& bit = ", nozzles: [12, 12, 13]", const std::string& pump = "")
{
  return "name: r\nwell: {stations: [[0, 0, 0], [1000, 0, 0]], hole_depth: 1000, sections: [{to: 1000, diameter: 0.2159, "
         "friction: 0.2}]}\n"
         "formation: [{to_tvd: 5000, drillability: 1.0e-8}]\nmud: {density: 1200" +
         mud + "}\nstring:\n  - {name: bit, type: bit, length: 0.3, mass: 50, diameter: 0.2159" + bit +
         "}\n  - {name: p, type: pipe, joints: fill, joint_length: 9.5, outer_diameter: 0.127, inner_diameter: 0.1086, "
         "linear_mass: 32}\n"
         "start: {bit_depth: 990}\nrig: {mud_pump: {max_flow: 0.05" +
         pump + "}}\n";
}

Scene parsed(const std::string& text)
{
  return parse_scene(text, "r.yaml");
}

std::string refusal(const std::string& text)
{
  try
  {
    parsed(text);
  }
  catch (const SceneError& error)
  {
    return error.what();
  }
  return "";
}
}  // namespace

TEST(SceneRheology, numbersAreReadWithTheirUnits)
{
  const Scene scene = parsed(
      scene_text(", rheology: " + bingham, ", nozzles: [12, 12, 9.5 mm]", ", surface_lines: [[40 ft, 3.5 in], [20, 0.0762]]"));
  ASSERT_TRUE(scene.rheology);
  const Rheology curve = curve_of(*scene.rheology, scene.mud.viscosity);
  EXPECT_NEAR(curve.consistency, 0.020, 1e-15);
  EXPECT_NEAR(curve.yield_stress, 15.0 * 0.4788026, 1e-6);
  const std::vector<double>& nozzles = scene.string[0].bit->nozzles;
  ASSERT_EQ(nozzles.size(), 3u);
  EXPECT_NEAR(nozzles[0], 12.0 / 32.0 * 0.0254, 1e-15);
  EXPECT_NEAR(nozzles[2], 0.0095, 1e-15);
  ASSERT_EQ(scene.rig.mud_pump.surface_lines.size(), 2u);
  EXPECT_NEAR(scene.rig.mud_pump.surface_lines[0].diameter, 0.0889, 1e-15);
  const Scene thick = parsed(scene_text(
      ", rheology: {law: herschel_bulkley, yield_stress: 3, consistency: 0.8 lb s^n/100ft2, index: 0.7, eccentricity: 0.5}"));
  EXPECT_NEAR(thick.rheology->consistency, 0.8 * 0.4788026, 1e-6);
  EXPECT_EQ(thick.rheology->eccentricity, 0.5);
}

// drillingformulas.com: three nozzles of 10/32 in and two of 12/32 in: 0.451 in2.
TEST(SceneRheology, areaIsThatOfAllNozzles)
{
  const Scene scene = parsed(scene_text(", rheology: " + bingham, ", nozzles: [10, 10, 10, 12, 12]"));
  EXPECT_NEAR(scene.string[0].bit->flow_area() / (0.0254 * 0.0254), 0.451, 5e-4);
  EXPECT_NEAR(parsed(scene_text(", rheology: " + bingham, ", nozzle_area: 0.451 in2")).string[0].bit->flow_area(),
              0.451 * 0.0254 * 0.0254, 1e-12);
}

TEST(SceneRheology, readingsAreFitted)
{
  const Scene scene = parsed(scene_text(", rheology: {law: bingham, readings: [[600, 60], [300, 40]]}"));
  EXPECT_NEAR(curve_of(*scene.rheology, 0.0).consistency, 0.020, 1e-5);
  const Scene newtonian = parsed(scene_text(", viscosity: 0.03, rheology: {law: newtonian}"));
  EXPECT_EQ(curve_of(*newtonian.rheology, newtonian.mud.viscosity).consistency, 0.03);
}

TEST(SceneRheology, itIsWrittenBackAndPartOfTheHash)
{
  const std::string laws[] = {bingham,
                              "{law: herschel_bulkley, readings: [[600, 65], [300, 39], [6, 7], [3, 5]], eccentricity: 0.3}",
                              "{law: power_law, consistency: 0.5, index: 0.63}", "{law: newtonian}"};
  std::vector<std::uint64_t> hashes = {scene_hash(parsed(scene_text("", "")))};
  for (const std::string& law : laws)
  {
    const Scene scene = parsed(scene_text(", rheology: " + law, ", nozzles: [11, 12, 13]", ", surface_lines: [[20, 0.09]]"));
    const Scene back = parse_scene(write_scene(scene), "back.yaml");
    EXPECT_EQ(scene_hash(back), scene_hash(scene)) << write_scene(scene);
    for (const std::uint64_t other : hashes) EXPECT_NE(scene_hash(scene), other);
    hashes.push_back(scene_hash(scene));
  }
}

// The waves' damping is that of the mud's plastic viscosity.
TEST(SceneRheology, plasticViscosityDamps)
{
  const Scene with = parsed(scene_text(", rheology: {law: bingham, plastic_viscosity: 0.035, yield_point: 9}")),
              without = parsed(scene_text(", viscosity: 0.035", ""));
  const Mesh a = build_mesh(with, 1020.0), b = build_mesh(without, 1020.0);
  EXPECT_NEAR(a.nodes[5].mud_along, b.nodes[5].mud_along, 1e-9 * b.nodes[5].mud_along);
}

TEST(SceneRheology, refusals)
{
  const auto rheology = [](const std::string& inside) { return scene_text(", rheology: {" + inside + "}"); };
  EXPECT_EQ(refusal(rheology("law: bingham, plastic_viscosity: 0.02")),
            "r.yaml:4: mud.rheology.yield_point: is missing: yield point YP; 1 lb/100 ft2 is 0.479 Pa; or give readings");
  EXPECT_EQ(refusal(rheology("plastic_viscosity: 0.02")),
            "r.yaml:4: mud.rheology.law: is missing, allowed: newtonian, bingham, power_law or herschel_bulkley");
  EXPECT_EQ(
      refusal(rheology("law: bingham, plastic_viscosity: 0.02, yield_point: 5, readings: [[600, 60], [300, 40]]")),
      "r.yaml:4: mud.rheology.plastic_viscosity: is given together with readings, which define it, allowed: one of the two\n"
      "r.yaml:4: mud.rheology.yield_point: is given together with readings, which define it, allowed: one of the two");
  EXPECT_NE(refusal(rheology("law: bingham, consistency: 0.4, index: 0.7")).find("unknown key"), std::string::npos);
  EXPECT_EQ(refusal(rheology("law: bingham, readings: [[600, 60]]")),
            "r.yaml:4: mud.rheology.readings: 1 readings are too few for this law, needed: 2");
  EXPECT_EQ(refusal(rheology("law: bingham, readings: 60")),
            "r.yaml:4: mud.rheology.readings: text is given, allowed: a list of rows [speed rpm, dial reading deg]");
  EXPECT_EQ(refusal(rheology("law: bingham, readings: [[600, 60], [300]]")),
            "r.yaml:4: mud.rheology.readings[1]: a list is given, allowed: [speed rpm, dial reading deg]");
  EXPECT_EQ(refusal(rheology("law: bingham, plastic_viscosity: 20, yield_point: 5")),
            "r.yaml:4: mud.rheology.plastic_viscosity: 20 is out of range, allowed: 0.0001 to 1 Pa s");
  EXPECT_EQ(refusal(scene_text(", viscosity: 0.03, rheology: " + bingham)),
            "r.yaml:4: mud.viscosity: is given together with mud.rheology, which defines the viscosity, allowed: one of the two");
  EXPECT_EQ(refusal(scene_text(", rheology: " + bingham, "")),
            "r.yaml:6: string[0].nozzles: is missing; mud.rheology needs nozzles or nozzle_area of the bit");
  EXPECT_EQ(refusal(scene_text(", rheology: " + bingham, ", nozzles: [12], nozzle_area: 1.0e-4")),
            "r.yaml:6: string[0].nozzle_area: is given together with nozzles, allowed: one of the two");
  EXPECT_EQ(refusal(scene_text(", rheology: " + bingham, ", nozzles: [0.375]")),
            "r.yaml:6: string[0].nozzles[0]: 0.375 is out of range, allowed: 4 to 64 1/32 in");
  EXPECT_EQ(refusal(scene_text(", rheology: " + bingham, ", nozzles: [12, 11.1]")),
            "r.yaml:6: string[0].nozzles[1]: 11.1 is not a whole number of 1/32 in; if it is in another unit, write it: 11.1 mm");
  EXPECT_EQ(refusal(scene_text(", rheology: " + bingham, ", nozzles: [12, 11.1 mm]")), "");
  EXPECT_EQ(
      refusal(scene_text(", rheology: " + bingham, ", nozzles: []")),
      "r.yaml:6: string[0].nozzles: an empty list is given, allowed: a list of diameters in 1/32 in, 4 to 64, or with a unit");
  EXPECT_EQ(refusal(scene_text(", rheology: " + bingham, ", nozzles: [12]", ", pressure_coefficient: 4.0e9")),
            "r.yaml:9: rig.mud_pump.pressure_coefficient: is given together with mud.rheology, which computes the losses, "
            "allowed: one of the two");
  EXPECT_EQ(refusal(scene_text("", ", nozzles: [12]")),
            "r.yaml:6: string[0].nozzles: has no effect without mud.rheology, allowed: leave it out, or give mud.rheology");
  EXPECT_EQ(
      refusal(scene_text("", "", ", surface_lines: [[20, 0.09]]")),
      "r.yaml:9: rig.mud_pump.surface_lines: has no effect without mud.rheology, allowed: leave it out, or give mud.rheology");
}
}  // namespace test_scene_rheology
