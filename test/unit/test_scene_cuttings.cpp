// SPDX-License-Identifier: BSD-3-Clause
// mud.cuttings: read, written back, hashed; refused without a rheology and where they are lighter than the mud.
#include <gtest/gtest.h>

#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/scene_hash.h"
#include "drill_rig_sim/scene/write_scene.h"

namespace test_scene_cuttings
{
using namespace drill_rig_sim;

namespace
{
const std::string rheology = ", rheology: {law: bingham, plastic_viscosity: 20 cP, yield_point: 15 lb/100ft2}";

/// The mud's own keys stand at line 4.
std::string scene_text(const std::string& mud, const std::string& bit = ", nozzles: [12, 12, 13]")
{
  return "name: c\nwell: {stations: [[0, 0, 0], [1000, 0, 0]], hole_depth: 1000, sections: [{to: 1000, diameter: 0.2159, "
         "friction: 0.2}]}\n"
         "formation: [{to_tvd: 5000, drillability: 1.0e-8}]\nmud: {density: 1200" +
         mud + "}\nstring:\n  - {name: bit, type: bit, length: 0.3, mass: 50, diameter: 0.2159" + bit +
         "}\n  - {name: p, type: pipe, joints: fill, joint_length: 9.5, outer_diameter: 0.127, inner_diameter: 0.1086, "
         "linear_mass: 32}\n"
         "start: {bit_depth: 990}\n";
}

std::string refusal(const std::string& text)
{
  try
  {
    parse_scene(text, "c.yaml");
  }
  catch (const SceneError& error)
  {
    return error.what();
  }
  return "";
}
}  // namespace

TEST(SceneCuttings, areReadAndWrittenBack)
{
  const std::string text = scene_text(rheology + ", cuttings: {density: 21.7 ppg, size: 0.25 in, porosity: 0.36, friction: 0.4}");
  const Scene scene = parse_scene(text, "c.yaml");
  ASSERT_TRUE(scene.cuttings);
  EXPECT_NEAR(scene.cuttings->density, 2600.23, 0.01);
  EXPECT_NEAR(scene.cuttings->size, 0.00635, 1e-12);
  EXPECT_EQ(scene.cuttings->porosity, 0.36);
  EXPECT_EQ(scene.cuttings->friction, 0.4);
  const Scene again = parse_scene(write_scene(scene), "again.yaml");
  EXPECT_EQ(scene_hash(again), scene_hash(scene));
  const Scene defaults = parse_scene(scene_text(rheology + ", cuttings: {}"), "c.yaml");
  ASSERT_TRUE(defaults.cuttings);
  EXPECT_EQ(defaults.cuttings->density, CuttingsSpec().density);
  const Scene defaults_again = parse_scene(write_scene(defaults), "again.yaml");
  EXPECT_TRUE(defaults_again.cuttings);
  EXPECT_NE(scene_hash(defaults), scene_hash(scene));
  const Scene clean = parse_scene(scene_text(rheology), "c.yaml");
  EXPECT_FALSE(clean.cuttings);
  EXPECT_NE(scene_hash(clean), scene_hash(defaults));
}

TEST(SceneCuttings, areRefusedWithOneLine)
{
  EXPECT_NE(refusal(scene_text(", cuttings: {}", "")).find("c.yaml:4: mud.cuttings: has no effect without mud.rheology"),
            std::string::npos)
      << refusal(scene_text(", cuttings: {}", ""));
  const std::string light = refusal(scene_text(rheology + ", cuttings: {density: 1100}"));
  EXPECT_NE(light.find("c.yaml:4: mud.cuttings.density: must be above mud.density"), std::string::npos) << light;
  const std::string large = refusal(scene_text(rheology + ", cuttings: {size: 0.1}"));
  EXPECT_NE(large.find("mud.cuttings.size"), std::string::npos) << large;
  const std::string unknown = refusal(scene_text(rheology + ", cuttings: {shape: 1}"));
  EXPECT_NE(unknown.find("mud.cuttings.shape"), std::string::npos) << unknown;
}
}  // namespace test_scene_cuttings
