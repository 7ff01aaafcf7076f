// SPDX-License-Identifier: BSD-3-Clause
// mud.temperature: read, written back, hashed; refused without a rheology.
#include <gtest/gtest.h>

#include <utility>

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
  expect(scene_text(rheology + ", temperature: {inlet: 86 psi}"),
         "t.yaml:4: mud.temperature.inlet: psi is a pressure; allowed: degC, degF, K");
  expect(scene_text(rheology + ", temperature: {inlet: 300 degF}"),
         "t.yaml:4: mud.temperature.inlet: 300 degF is out of range, allowed: -4 to 212 degF");
  expect(scene_text(rheology + ", temperature: {rock_conductivity: 0}"), "mud.temperature.rock_conductivity");
  expect(scene_text(rheology + ", temperature: {outlet: 40}"), "mud.temperature.outlet");
}

TEST(SceneTemperature, UnitsHaveTheirZero)
{
  const auto inlet = [](const std::string& number)
  { return parse_scene(scene_text(rheology + ", temperature: {inlet: " + number + "}"), "t.yaml").temperature->inlet; };
  for (const char* eighty_six : {"86 degF", "86F", "86 \u00b0F", "86 deg F", "303.15 K", "30 C", "30 \u00b0C", "30"})
    EXPECT_NEAR(30.0, inlet(eighty_six), 1e-13) << eighty_six;
  EXPECT_EQ(0.0, inlet("32 degF"));
  EXPECT_NEAR(-20.0, inlet("-4 degF"), 1e-14) << "the least that is allowed";
  const auto gradient = [](const std::string& number)
  { return parse_scene(scene_text(rheology + ", temperature: {gradient: " + number + "}"), "t.yaml").temperature->gradient; };
  for (const char* geothermal :
       {"0.03", "0.03 K/m", "30 K/km", "3 degC/100 m", "3 K/100m", "1.645920 degF/100 ft", "0.0164592 degF/ft"})
    EXPECT_NEAR(0.03, gradient(geothermal), 1e-15) << geothermal;
}

// In a vertical hole of 4000 m.
TEST(SceneTemperature, RockThatNoMudStandsIsReported)
{
  const auto remarks = [](const std::string& temperature)
  {
    std::string text = scene_text(rheology + ", temperature: {" + temperature + "}");
    for (const auto& [shallow, deep] :
         {std::pair("1000,", "4000,"), std::pair("to: 1000", "to: 4000"), std::pair(": 990", ": 3990")})
      for (std::size_t at = text.find(shallow); at != std::string::npos; at = text.find(shallow, at + 1))
        text.replace(at, std::string(shallow).size(), deep);
    return parse_scene(text, "t.yaml").remarks;
  };
  EXPECT_TRUE(remarks("").empty());
  EXPECT_TRUE(remarks("surface: 20, gradient: 0.0699").empty()) << "299.6 degC";
  const auto steep = remarks("surface: 20, gradient: 0.071");
  ASSERT_EQ(1u, steep.size());
  EXPECT_EQ(0u,
            steep[0].rfind("t.yaml: mud.temperature.gradient: 0.071 K/m makes the rock 304 degC at 4000 m of true vertical", 0))
      << steep[0];
}
}  // namespace test_scene_temperature
