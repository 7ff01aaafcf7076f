// SPDX-License-Identifier: BSD-3-Clause
// mud.pressure_waves: read, written back, hashed; refused without a rheology and beside what it excludes.
#include <gtest/gtest.h>

#include "drill_rig_sim/scene/scene_hash.h"
#include "drill_rig_sim/scene/write_scene.h"
#include "mud_scene.h"

namespace test_scene_pressure_waves
{
using namespace drill_rig_sim;
using namespace mud_scene;

namespace
{
std::string refusal(const std::string& text)
{
  return refusal_of(text, "w.yaml");
}
}  // namespace

TEST(ScenePressureWaves, areReadAndWrittenBack)
{
  const std::string waves =
      ", pressure_waves: {cylinders: 5, dampener_volume: 0.05, dampener_pressure: 30 bar, pulse_height: 10 bar, pulse_period: 3}";
  const Scene scene = parse_scene(scene_text(rheology + waves), "w.yaml");
  ASSERT_TRUE(scene.pressure_waves);
  EXPECT_EQ(scene.pressure_waves->cylinders, 5);
  EXPECT_EQ(scene.pressure_waves->dampener_volume, 0.05);
  EXPECT_NEAR(scene.pressure_waves->dampener_pressure, 3e6, 1e-6);
  EXPECT_NEAR(scene.pressure_waves->pulse_height, 1e6, 1e-6);
  EXPECT_EQ(scene.pressure_waves->pulse_period, 3.0);
  EXPECT_EQ(scene_hash(parse_scene(write_scene(scene), "again.yaml")), scene_hash(scene));
  const Scene defaults = parse_scene(scene_text(rheology + ", pressure_waves: {}"), "w.yaml");
  ASSERT_TRUE(defaults.pressure_waves);
  EXPECT_EQ(defaults.pressure_waves->cylinders, 3);
  EXPECT_TRUE(parse_scene(write_scene(defaults), "again.yaml").pressure_waves);
  EXPECT_NE(scene_hash(defaults), scene_hash(scene));
  const Scene without = parse_scene(scene_text(rheology), "w.yaml");
  EXPECT_FALSE(without.pressure_waves);
  EXPECT_NE(scene_hash(without), scene_hash(defaults));
}

TEST(ScenePressureWaves, areRefusedWithOneLine)
{
  const auto expect = [](const std::string& text, const std::string& line)
  { EXPECT_NE(refusal(text).find(line), std::string::npos) << refusal(text); };
  expect(scene_text(", pressure_waves: {}", ""), "w.yaml:4: mud.pressure_waves: has no effect without mud.rheology");
  expect(scene_text(rheology + ", pressure_waves: {}, fill: 300"),
         "w.yaml:4: mud.pressure_waves: is given together with mud.fill, allowed: one of the two");
  expect(scene_text(rheology + ", pressure_waves: {}", nozzles,
                    "instruments: {surface: {stand_pipe_pressure: {pump_noise: 0.03}}}\n"),
         "stand_pipe_pressure.pump_noise: is given together with mud.pressure_waves");
  expect(scene_text(rheology + ", pressure_waves: {cylinders: 13}"), "mud.pressure_waves.cylinders");
  expect(scene_text(rheology + ", pressure_waves: {speed: 1300}"), "mud.pressure_waves.speed");
}
}  // namespace test_scene_pressure_waves
