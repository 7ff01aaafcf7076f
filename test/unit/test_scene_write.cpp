// SPDX-License-Identifier: BSD-3-Clause
// A scene that is written out is the same scene when it is read again.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/scene_hash.h"
#include "drill_rig_sim/scene/write_scene.h"
#include "in_source.h"
#include "scene_of_all_keys.h"

namespace drill_rig_sim::test_scene_write
{
namespace
{
void expect_back(const Scene& scene)
{
  const std::string text = write_scene(scene);
  try
  {
    const Scene again = parse_scene(text, "written.yaml");
    EXPECT_EQ(scene_hash(scene), scene_hash(again)) << scene.file << "\n" << text;
    EXPECT_EQ(scene.numerics.kernel, again.numerics.kernel) << scene.file;
    EXPECT_EQ(text, write_scene(again)) << scene.file;
  }
  catch (const SceneError& error)
  {
    FAIL() << scene.file << "\n" << error.what() << "\n" << text;
  }
}
}  // namespace

TEST(WriteScene, givesEveryKeyBackToTheLastBit)
{
  expect_back(parse_scene(scene_of_all_keys, "all_keys.yaml"));
}

TEST(WriteScene, givesSettingsAndUnitsBack)
{
  expect_back(parse_scene(scene_of_all_keys, "all_keys.yaml",
                          {"mud.density=10.1 ppg", "numerics.integrator=auto", "numerics.level=auto", "numerics.step=0",
                           "string[2].oscillation_force=0"}));
  expect_back(parse_scene(scene_of_all_keys, "all_keys.yaml",
                          {"string[0].torque={model: detournay, wear_friction: 0.3}", "trajectory={stage_two_steps: 7}"}));
}

TEST(WriteScene, givesTheHoleOfATieInBackToRounding)
{
  const Scene scene = parse_scene(scene_of_all_keys, "all_keys.yaml",
                                  {"well.stations=[[400, 3, 4], [900, 5, 6]]", "well.tie_in={north: 12, east: -9, tvd: 399}"});
  const Scene again = parse_scene(write_scene(scene), "written.yaml");
  ASSERT_EQ(scene.well.survey.size(), again.well.survey.size());
  for (std::size_t i = 0; i < scene.well.survey.size(); ++i)
  {
    EXPECT_EQ(scene.well.survey[i].md, again.well.survey[i].md);
    EXPECT_DOUBLE_EQ(scene.well.survey[i].inclination, again.well.survey[i].inclination);
    EXPECT_DOUBLE_EQ(scene.well.survey[i].azimuth, again.well.survey[i].azimuth);
  }
}

TEST(WriteScene, givesReadyScenesBack)
{
  int scenes = 0;
  for (const char* folder : {"config/scenes", "test/scenes"})
    for (const auto& entry : std::filesystem::directory_iterator(in_source(folder)))
    {
      if (entry.path().extension() != ".yaml") continue;
      expect_back(read_scene(entry.path().string()));
      ++scenes;
    }
  EXPECT_GT(scenes, 15);
}

TEST(WriteScene, leavesDefaultsOut)
{
  const std::string text = write_scene(read_scene(in_source("config/scenes/quick.yaml")));
  EXPECT_EQ(text.find("heave"), std::string::npos) << text;
  EXPECT_EQ(text.find("young_modulus"), std::string::npos);
  EXPECT_NE(text.find("name: \"quick"), std::string::npos);
}
}  // namespace drill_rig_sim::test_scene_write
