// SPDX-License-Identifier: BSD-3-Clause
// A string that hangs in mud: its weight on the hook, its stretch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "drill_rig_sim/sim/simulator.h"
#include "playing.h"
#include "test_scenes.h"

namespace test_sim_hanging
{
using namespace drill_rig_sim;

namespace
{
/// Weight in mud of the hanging parts, from the scene alone: `total` unstretched metres of bit, collars and fill pipe, `in_air`
/// of them above the rotary table.
double buoyant_weight(const Scene& scene, double total, double in_air)
{
  double mass = scene.string[0].bit->mass, volume = scene.string[0].bit->mass / scene.string[0].density;
  double length = scene.string[0].length;
  for (std::size_t p = 1; p < scene.string.size(); ++p)
  {
    const PartSpec& part = scene.string[p];
    const double part_length = part.joints > 0 ? part.joints * part.joint_length : total - length;
    mass += part.linear_mass * part_length;
    volume += part.linear_mass / part.density * (part_length - (part.joints == 0 ? in_air : 0.0));
    length += part_length;
  }
  return standard_gravity * (mass - scene.mud.density * volume);
}

/// Integral of the tension over E A up a pipe that hangs with `below` [N] at its foot: (below L + w L^2/2)/(E A).
double stretch(double length, double weight_per_length, double below, double stiffness)
{
  return (below * length + 0.5 * weight_per_length * length * length) / stiffness;
}

/// Hook load [N], every frame, of 2.35 km that come down at 0.5 m/s, are stopped after 6 s by the brake and ring for a minute:
/// nothing damps it.
std::vector<double> load_that_rings(double tolerance)
{
  Scene scene = vertical_scene(2400.0, 2350.0);
  scene.string = {bit_part(0.2159), collar_part(10, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
  scene.start.block_height = 25.0;
  scene.numerics.level = Level::automatic;
  scene.numerics.companion = CompanionKind::none;
  scene.numerics.step = step_by_level;
  scene.numerics.tolerance = tolerance;
  Simulator rig(scene);
  std::vector<double> load;
  rig.command(WinchSetpoint{-0.5, false});
  play(rig, 6.0);
  rig.command(WinchSetpoint{0.0, true});
  play(rig, 60.0, [&load](const Truth& t) { load.push_back(t.hook_load); });
  return load;
}
}  // namespace

// The stretch (0.2 per mille) moves steel across the rotary table and nothing else: 1e-3 leaves room for that alone.
TEST(HangingString, hookLoadIsTheBuoyantWeight)
{
  for (double depth : {300.0, 990.0})
  {
    Scene scene = vertical_scene(1000.0, depth);
    scene.string = {bit_part(0.2159), collar_part(6, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
    Simulator rig(scene);
    StringProfile profile;
    rig.profile(profile);
    const double weight = buoyant_weight(scene, profile.from_bit.back(), scene.start.block_height);
    EXPECT_NEAR(rig.truth().hook_load_string, weight, 1e-3 * weight);
    EXPECT_NEAR(rig.truth().hook_load, weight + 17500.0 * standard_gravity, 1e-3 * weight);

    for (int k = 0; k < 200; ++k) ASSERT_EQ(rig.frame(0.01), FrameStatus::running);
    EXPECT_NEAR(rig.truth().hook_load_string, weight, 1e-3 * weight) << "after 2 s with the brake set";
    EXPECT_NEAR(rig.truth().bit_depth, depth, 1e-4);
  }
}

// By the effective tension alone: the side pressure's Poisson term is not modelled. The bit's ball is rigid, the pipe's weight in
// air above the table is counted exactly: what is left is the mesh, which carries weight evenly over each element: exact at
// nodes.
TEST(HangingString, stretchIsThatOfItsTension)
{
  const Scene scene = vertical_scene(1000.0, 990.0);
  Simulator rig(scene);
  StringProfile profile;
  rig.profile(profile);
  const double total = profile.from_bit.back();
  const double stiffness = 206e9 * pipe_area;
  const double in_air = scene.start.block_height;
  const double buoyancy = 1.0 - scene.mud.density / steel_density;
  const double bit = standard_gravity * 40.0 * buoyancy;
  const double wet = standard_gravity * tool_jointed_mass * buoyancy;
  const double wet_length = total - in_air - scene.string[0].length;
  const double dry = standard_gravity * tool_jointed_mass;
  const double expected = stretch(wet_length, wet, bit, stiffness) + stretch(in_air, dry, bit + wet * wet_length, stiffness);
  const double measured = scene.start.block_height + 990.0 - total;
  EXPECT_GT(expected, 0.15);
  EXPECT_NEAR(measured, expected, 1e-3 * expected);
}

// Errors of waves that nothing damps add up: what a minute makes of them counts, in root mean square over the load's range.
TEST(HangingString, loadRingsWithinTheToleranceForAMinute)
{
  const std::vector<double> reference = load_that_rings(0.001);
  const auto [low, high] = std::minmax_element(reference.begin(), reference.end());
  for (double tolerance : {0.05, 0.02})
  {
    const std::vector<double> load = load_that_rings(tolerance);
    ASSERT_EQ(load.size(), reference.size());
    double square = 0.0;
    for (std::size_t k = 0; k < load.size(); ++k)
      square += std::pow(load[k] - reference[k], 2) / static_cast<double>(load.size());
    EXPECT_LT(std::sqrt(square), tolerance * (*high - *low)) << tolerance;
  }
}
}  // namespace test_sim_hanging
