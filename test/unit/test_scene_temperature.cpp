// SPDX-License-Identifier: BSD-3-Clause
// mud.temperature: read, written back, hashed; refused without a rheology.
#include <gtest/gtest.h>

#include "drill_rig_sim/scene/scene_hash.h"
#include "drill_rig_sim/scene/write_scene.h"
#include "mud_scene.h"

namespace test_scene_temperature
{
using namespace drill_rig_sim;
using namespace mud_scene;

namespace
{
std::string refusal(const std::string& text)
{
  return refusal_of(text, "t.yaml");
}
}  // namespace

TEST(SceneTemperature, isReadAndWrittenBack)
{
  const std::string temperature =
      ", temperature: {inlet: 21, surface: 11, gradient: 0.025, heat_capacity: 3100, pipe_coefficient: 160, wall_coefficient: "
      "150, rock_conductivity: 2.1, rock_diffusivity: 1.1e-6, expansion: 5.1e-4, compressibility: 4.1e-10, activation: 1900, "
      "rheology_temperature: 48 degC, circulated: 4 h}";
  const Scene scene = parse_scene(scene_text(rheology + temperature), "t.yaml");
  ASSERT_TRUE(scene.temperature);
  const MudTemperatureSpec& spec = *scene.temperature;
  EXPECT_EQ(spec.inlet, 21.0);
  EXPECT_EQ(spec.surface, 11.0);
  EXPECT_EQ(spec.gradient, 0.025);
  EXPECT_EQ(spec.heat_capacity, 3100.0);
  EXPECT_EQ(spec.pipe_coefficient, 160.0);
  EXPECT_EQ(spec.wall_coefficient, 150.0);
  EXPECT_EQ(spec.rock_conductivity, 2.1);
  EXPECT_EQ(spec.rock_diffusivity, 1.1e-6);
  EXPECT_EQ(spec.expansion, 5.1e-4);
  EXPECT_EQ(spec.compressibility, 4.1e-10);
  EXPECT_EQ(spec.activation, 1900.0);
  EXPECT_EQ(spec.rheology_temperature, 48.0);
  EXPECT_EQ(spec.circulated, 14400.0);
  EXPECT_EQ(scene_hash(parse_scene(write_scene(scene), "again.yaml")), scene_hash(scene));
  const Scene defaults = parse_scene(scene_text(rheology + ", temperature: {}"), "t.yaml");
  ASSERT_TRUE(defaults.temperature);
  EXPECT_EQ(defaults.temperature->inlet, MudTemperatureSpec().inlet);
  EXPECT_TRUE(parse_scene(write_scene(defaults), "again.yaml").temperature);
  EXPECT_NE(scene_hash(defaults), scene_hash(scene));
  const Scene without = parse_scene(scene_text(rheology), "t.yaml");
  EXPECT_FALSE(without.temperature);
  EXPECT_NE(scene_hash(without), scene_hash(defaults));
}

TEST(SceneTemperature, isRefusedWithOneLine)
{
  const auto expect = [](const std::string& text, const std::string& line)
  {
    EXPECT_NE(refusal(text).find(line), std::string::npos) << refusal(text);
    EXPECT_EQ(refusal(text).find('\n'), std::string::npos) << refusal(text);
  };
  expect(scene_text(", temperature: {}", ""), "t.yaml:4: mud.temperature: has no effect without mud.rheology");
  expect(scene_text(rheology + ", temperature: {inlet: 150}"),
         "t.yaml:4: mud.temperature.inlet: 150 is out of range, allowed: -20 to 100 degC");
  expect(scene_text(rheology + ", temperature: {inlet: 86 degF}"), "t.yaml:4: mud.temperature.inlet: unknown unit; allowed: ");
  expect(scene_text(rheology + ", temperature: {rock_conductivity: 0}"), "mud.temperature.rock_conductivity");
  expect(scene_text(rheology + ", temperature: {outlet: 40}"), "mud.temperature.outlet");
}
}  // namespace test_scene_temperature
