// SPDX-License-Identifier: BSD-3-Clause
// mud.cuttings: read, written back, hashed; refused without a rheology and where they are lighter than the mud.
#include <gtest/gtest.h>

#include "drill_rig_sim/scene/scene_hash.h"
#include "drill_rig_sim/scene/write_scene.h"
#include "mud_scene.h"

namespace test_scene_cuttings
{
using namespace drill_rig_sim;
using namespace mud_scene;

namespace
{
std::string refusal(const std::string& text)
{
  return refusal_of(text, "c.yaml");
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
