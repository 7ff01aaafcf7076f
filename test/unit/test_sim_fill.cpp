// SPDX-License-Identifier: BSD-3-Clause
// A string that is not full of mud: its weight and forces by hand, its level by the bit's depth and by the pump, the energy
// account.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/bore_fill.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/profile.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/solve/start.h"
#include "test_scenes.h"

namespace test_sim_fill
{
using namespace drill_rig_sim;

namespace
{
constexpr double collars_from = 0.3, collars_to = 0.3 + 4 * 9.4;  // above the bit's face [m]
constexpr double collar_inner = 0.0714;

/// Bit, four collars and pipe that hang in a vertical hole, empty inside from the rotary table down to a level.
Scene tapered(double bit_depth, double level)
{
  Scene scene = vertical_scene(bit_depth + 20.0, bit_depth);
  scene.string = {bit_part(0.2159), collar_part(4, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
  if (level > 0.0) scene.mud.fill = {{0.0, level}};
  return scene;
}

double circle(double diameter)
{
  return 0.25 * pi * diameter * diameter;
}

/// Inside, from a level down to the bit, by where it is along the string [m3].
double volume_below(double level, double bit_depth)
{
  const double top = std::max(0.0, bit_depth - level);
  const double in_collars = std::clamp(top, collars_from, collars_to) - collars_from, in_pipe = std::max(0.0, top - collars_to);
  return circle(collar_inner) * in_collars + circle(pipe_inner) * in_pipe;
}

/// Of air, from the rotary table down to a level [m3].
double air_above(double level, double bit_depth)
{
  return volume_below(0.0, bit_depth) - volume_below(level, bit_depth);
}

double string_load(const Scene& scene)
{
  return build_at_rest(scene).statics.top_force;
}

void run_for(Simulator& rig, double seconds)
{
  for (long k = 0; k < std::lround(seconds / 0.01); ++k) ASSERT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
}
}  // namespace

// What the steel weighs in air, less what its outside displaces, and what is inside: bit of steel, tool joints and all by their
// mass.
TEST(Fill, hookLoadOfATaperedStringByHand)
{
  constexpr double bit_depth = 990.0;
  const Scene full = tapered(bit_depth, 0.0);
  const double rho = full.mud.density, steel = 1.0 - rho / steel_density, length = bit_depth + full.start.block_height;
  const double pipe = length - collars_to, above = full.start.block_height;
  const double of_full = standard_gravity * (40.0 * steel + 136.0 * 4 * 9.4 * steel +
                                             tool_jointed_mass * (pipe * steel + above * rho / steel_density));
  EXPECT_NEAR(string_load(full), of_full, 100.0) << "by a quarter of a metre, which it stretches, there is less of it";
  for (const double level : {50.0, 495.0, 960.0, 985.0, 990.0, 2000.0})
  {
    const double lighter = standard_gravity * rho * air_above(level, bit_depth);
    EXPECT_GT(lighter, 4e3);
    EXPECT_NEAR(string_load(full) - string_load(tapered(bit_depth, level)), lighter, 2e-3 * lighter) << level;
  }
  Scene air = tapered(bit_depth, 500.0);
  air.mud.density = 0.0;
  Scene none = air;
  none.mud.fill.clear();
  EXPECT_EQ(string_load(air), string_load(none)) << "without mud there is none to be missing";
}

TEST(Fill, levelGoesByTheBitsDepth)
{
  MudSpec mud;
  EXPECT_EQ(fill_level(mud, 500.0), 0.0);
  mud.fill = {{100.0, 20.0}, {300.0, 120.0}, {300.5, 0.0}, {400.0, 10.0}};
  for (const auto& [bit_depth, level] : std::vector<std::pair<double, double>>{
           {0.0, 20.0}, {100.0, 20.0}, {200.0, 70.0}, {300.0, 120.0}, {300.25, 60.0}, {300.5, 0.0}, {400.0, 10.0}, {900.0, 10.0}})
    EXPECT_NEAR(fill_level(mud, bit_depth), level, 1e-12) << bit_depth;
  Scene scene = tapered(990.0, 0.0);
  scene.mud.fill = {{900.0, 0.0}, {1000.0, 500.0}};
  EXPECT_NEAR(string_load(scene), string_load(tapered(990.0, 450.0)), 1.0);
}

// T = T_e + p_i A_i - p_o A_o: no pressure inside above the mud's surface, below it that of the mud above.
TEST(Fill, trueAxialForceHasNoPressureOfMudThatIsNotThere)
{
  const Scene scene = tapered(990.0, 400.0);
  const StringProfile p = static_report(scene, no_sliding).profile;
  const double per_metre = standard_gravity * scene.mud.density;
  int above = 0, below = 0;
  for (std::size_t i = 0; i < p.tension.size(); ++i)
  {
    const double depth = -p.position[i].z();
    if (depth < 0.0 || std::abs(depth - 400.0) < 0.5 || p.from_bit[i] <= collars_to) continue;
    (depth < 400.0 ? above : below) += 1;
    const double inside = per_metre * std::max(0.0, depth - 400.0), outside = per_metre * depth;
    const double expected = p.tension[i] + inside * circle(pipe_inner) - outside * circle(pipe_outer);
    EXPECT_NEAR(p.true_axial_force[i], expected, 30.0) << p.from_bit[i];
  }
  EXPECT_GT(above, 30);
  EXPECT_GT(below, 30);
}

// Sideways only the mud that is there moves along.
TEST(Fill, inertiaOfMudThatIsNotThereIsMissing)
{
  const RigAtRest full = build_at_rest(tapered(190.0, 0.0)), part = build_at_rest(tapered(190.0, 100.0));
  Stage of_full(*full.model), of_part(*part.model);
  begin_step(*full.model, full.state, 0.01, Setpoints(), of_full);
  begin_step(*part.model, part.state, 0.01, Setpoints(), of_part);
  for (std::size_t i = 0; i < full.state.nodes.size(); ++i)
  {
    const MeshNode& node = full.model->mesh().nodes[i];
    const double depth = -full.state.nodes[i].position.z();
    if (depth < 0.0 || std::abs(depth - 100.0) < 0.1) continue;
    EXPECT_NEAR(of_full.added_mass[i] - of_part.added_mass[i], depth < 100.0 ? node.mud_inside : 0.0,
                1e-4 * of_full.added_mass[i])
        << depth;
  }
}

// The pump fills the string first: so long nothing comes to the bit and the stand pipe shows nothing; then the string weighs as a
// full one.
TEST(Fill, thePumpFillsTheStringFirst)
{
  constexpr double bit_depth = 90.0, level = 60.0, flow = 0.02;
  Scene scene = tapered(bit_depth, level);
  scene.rig.mud_pump.flow_ramp = 10.0;
  scene.rig.hoisting.rail_friction = 0.0;
  Simulator rig(scene);
  const double empty = rig.truth().hook_load_string, lighter = standard_gravity * scene.mud.density * air_above(level, bit_depth);
  const double lasts = air_above(level, bit_depth) / flow;
  ASSERT_GT(lasts, 10.0);
  rig.command(PumpSetpoint{flow});
  run_for(rig, 0.5 * lasts);
  EXPECT_EQ(rig.truth().stand_pipe_pressure, 0.0);
  EXPECT_NEAR(rig.truth().hook_load_string - empty, 0.5 * lighter, 0.02 * lighter);
  run_for(rig, 0.5 * lasts - 0.2);
  EXPECT_EQ(rig.truth().stand_pipe_pressure, 0.0);
  run_for(rig, 1.0);
  EXPECT_GT(rig.truth().stand_pipe_pressure, 1e5);
  rig.command(PumpSetpoint{0.0});
  run_for(rig, 20.0);
  EXPECT_NEAR(rig.truth().hook_load_string - empty, lighter, 0.02 * lighter) << "and stays full";
}

// Run in by 6 m while the level falls from 20 m to 80 m; as deep as that a string of that level weighs the same, and no energy
// comes from nowhere.
TEST(Fill, runInDry)
{
  Scene scene = tapered(100.0, 0.0);
  scene.rig.hoisting.rail_friction = 0.0;
  scene.mud.fill = {{100.0, 20.0}, {106.0, 80.0}};
  Simulator rig(scene);
  rig.balance_energy();
  const double before = rig.truth().hook_load_string;
  rig.command(WinchSetpoint{-0.3, false});
  run_for(rig, 20.5);
  rig.command(WinchSetpoint{0.0, true});
  run_for(rig, 20.0);
  const double bit_depth = rig.truth().bit_depth, level = fill_level(scene.mud, bit_depth);
  ASSERT_GT(level, 70.0);
  Scene there = tapered(bit_depth, level);
  there.start.block_height = rig.truth().block_height;
  EXPECT_NEAR(rig.truth().hook_load_string, string_load(there), 60.0);
  const double rho = scene.mud.density, lighter = standard_gravity * rho * (air_above(level, bit_depth) - air_above(20.0, 100.0));
  const double immersed = standard_gravity * rho * tool_jointed_mass / steel_density * (bit_depth - 100.0);
  EXPECT_NEAR(before - rig.truth().hook_load_string, lighter + immersed, 0.01 * lighter);
  EXPECT_LT(rig.energy().closure(), 1e-3);
}

// A hole whose end rises above the mud's surface: the mud stands by its way along the string, not by height.
TEST(Fill, aHoleThatRisesAgain)
{
  Scene scene = scene_in({{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {400.0, 100.0 * degree, 0.0}, {900.0, 100.0 * degree, 0.0}}, 900.0,
                         890.0, 0.2);
  scene.mud.fill = {{0.0, 300.0}};
  const RigAtRest rig = build_at_rest(scene);
  EXPECT_NEAR(rig.state.hydraulics.bore_top, 890.0 - 300.0, 1.0);
  State state = rig.state;
  EXPECT_NEAR(fill_bore(*rig.model, state), circle(pipe_inner) * 300.0, 0.01);
  EXPECT_LT(mud_surface(*rig.model, state), -200.0);
}
}  // namespace test_sim_fill
