// SPDX-License-Identifier: BSD-3-Clause
// The mud's way through string and hole: published losses, volumes, where along the string the pressures drop.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/running_speed.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "test_scenes.h"

namespace test_model_mud_circuit
{
using namespace drill_rig_sim;

namespace
{
constexpr double psi = 6894.757, foot = 0.3048, inch = 0.0254, gpm = 6.30902e-5, ppg = 119.8264;

Scene long_pipe()
{
  Scene scene = vertical_scene(1000.0, 990.0);
  scene.mud.gel_strength = 5.0;
  scene.rig.mud_pump.pressure_coefficient = 2e10;
  return scene;
}

MudCircuit circuit_of(const Scene& scene)
{
  return mud_circuit(scene, build_mesh(scene, scene.start.bit_depth + scene.start.block_height));
}
}  // namespace

// drillingformulas.com, after Lapeyrouse: 13 lb/gal, 8000 ft of 4 in in 6.5 in, 320 gal/min: 531.65 psi, of a speed rounded to
// 299 ft/min.
TEST(MudCircuit, annulusLosesWhatLapeyrouseSays)
{
  const double loss = 8000.0 * foot * annulus_gradient(13.0 * ppg, 320.0 * gpm, 6.5 * inch, 4.0 * inch) / psi;
  EXPECT_NEAR(loss, 531.65, 0.005 * 531.65);
  EXPECT_EQ(annulus_gradient(1200.0, 0.03, 0.2, 0.2), 0.0) << "no annulus";
}

// 6.1e-5 x 9.5 lb/gal x 5000 ft x 600^1.86 / 3.34^4.86 = 1213 psi; an example of drillingformulas.com with another law has 1254.
TEST(MudCircuit, boreLosesWhatLapeyrouseSays)
{
  EXPECT_NEAR(5000.0 * foot * bore_gradient(9.5 * ppg, 600.0 * gpm, 3.34 * inch) / psi, 1213.0, 2.0);
}

TEST(MudCircuit, volumesAndGelAreThoseOfTheGeometry)
{
  const Scene scene = long_pipe();
  const MudCircuit mud = circuit_of(scene);
  const double length = scene.start.bit_depth + scene.start.block_height;  // of the bore, less a bit's
  EXPECT_NEAR(mud.circuit.bore.capacity * scene.mud.bulk_modulus, 0.25 * pi * pipe_inner * pipe_inner * length, 0.01);
  EXPECT_NEAR(mud.circuit.bore.gel, 4.0 * 5.0 * length / pipe_inner, 0.002 * mud.circuit.bore.gel);
  const double hole = scene.well.sections.back().diameter;
  const double in_hole = scene.start.bit_depth;
  EXPECT_NEAR(mud.circuit.annulus.capacity * scene.mud.bulk_modulus,
              0.25 * pi * (hole * hole - pipe_outer * pipe_outer) * in_hole, 0.5);
  EXPECT_NEAR(mud.circuit.annulus.gel, 4.0 * 5.0 * in_hole / (hole - pipe_outer), 0.02 * mud.circuit.annulus.gel);
}

// The losses add up to the scene's; along plain pipe they fall in a straight line.
TEST(MudCircuit, lossesAddUpToTheScenes)
{
  const Scene scene = long_pipe();
  const MudCircuit mud = circuit_of(scene);
  const MudPumpSpec& pump = scene.rig.mud_pump;
  EXPECT_NEAR(mud.circuit.bore.loss + mud.circuit.annulus.loss, pump.pressure_coefficient * pump.max_flow * pump.max_flow, 1e-3);
  const double hole = scene.well.sections.back().diameter;
  EXPECT_NEAR(mud.circuit.annulus.loss, 990.0 * annulus_gradient(scene.mud.density, pump.max_flow, hole, pipe_outer),
              0.01 * mud.circuit.annulus.loss);
  EXPECT_NEAR(mud.bore_friction * mud.circuit.bore.loss,
              (scene.start.bit_depth + scene.start.block_height) * bore_gradient(scene.mud.density, pump.max_flow, pipe_inner),
              0.002 * mud.circuit.bore.loss);
  EXPECT_NEAR(std::accumulate(mud.annulus_here.begin(), mud.annulus_here.end(), 0.0), 1.0, 1e-12);
  HydraulicState state;
  state.stand_pipe_pressure = 3e7;
  state.annulus_pressure = 1e6;
  const std::size_t lowest = 1, top = mud.bore_above.size() - 1;
  const MudPressures flowing = mud_pressures(mud, state, pump.max_flow);
  EXPECT_NEAR(flowing.in_annulus(mud, lowest), 1e6, 2e4);
  EXPECT_EQ(flowing.in_annulus(mud, top), 0.0) << "above the rotary table";
  EXPECT_NEAR(flowing.in_bore(mud, top), 3e7, 2e5);
  EXPECT_NEAR(flowing.in_bore(mud, lowest), 3e7 - mud.bore_friction * mud.circuit.bore.loss, 2e5);
  EXPECT_EQ(mud_pressures(mud, state, 0.0).in_bore(mud, lowest), 3e7) << "at rest";
}

// Lapeyrouse's plugged pipe, 4 1/2 in in 7 7/8 in, 270 ft/min: K + D^2/(D_h^2 - D^2) = 0.467 + 0.485 of it is 257 ft/min, he has
// 252 with K = 0.45; 1.4327e-7 x 15 lb/gal x 14300 ft x 257^2/3.375 = 601 psi, his power law 516 at that speed, 716 at 1.5 times
// as much.
TEST(MudCircuit, plungedPipeSurgesAsLapeyrousesDoes)
{
  const double d = 4.5 * inch, hole = 7.875 * inch, speed = 270.0 * foot / 60.0;
  const double inside = 0.25 * pi * d * d, around = 0.25 * pi * hole * hole - inside;
  const double flow = speed * (inside + clinging_constant(d / hole) * around);
  EXPECT_NEAR(flow / around * 60.0 / foot, 257.0, 0.5);
  EXPECT_NEAR(14300.0 * foot * annulus_gradient(15.0 * ppg, flow, hole, d) / psi, 601.0, 3.0);
}

TEST(MudCircuit, displacedAreaIsThePipesAndWhatClingsToIt)
{
  Scene scene = long_pipe();
  const double hole = scene.well.sections.back().diameter;
  const auto of = [&](double d) { return 0.25 * pi * (d * d + clinging_constant(d / hole) * (hole * hole - d * d)); };
  EXPECT_NEAR(circuit_of(scene).displaced_area, of(pipe_outer), 1e-3 * of(pipe_outer));
  // collars take 3.1 times what pipe takes of the losses per metre
  scene.string.insert(scene.string.begin() + 1, collar_part(20, 9.5));
  const MudCircuit mud = circuit_of(scene);
  const double pipe = annulus_gradient(1.0, 1.0, hole, pipe_outer), collar = annulus_gradient(1.0, 1.0, hole, 0.165);
  const double share = 190.0 * collar / (190.0 * collar + 800.0 * pipe);
  const double expected = std::sqrt(share * std::pow(of(0.165), 2) + (1.0 - share) * std::pow(of(pipe_outer), 2));
  EXPECT_NEAR(mud.displaced_area, expected, 0.003 * expected);
}

TEST(MudCircuit, runningSpeedIsTheMeanOfThePipeInTheHole)
{
  const Scene scene = long_pipe();
  const Mesh mesh = build_mesh(scene, scene.start.bit_depth + scene.start.block_height);
  const MudCircuit mud = mud_circuit(scene, mesh);
  std::vector<NodeState> nodes(mesh.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    nodes[i].position = {0.0, 0.0, mesh.nodes[i].from_bit - scene.start.bit_depth};
    nodes[i].rate.velocity = {0.7, 0.0, -0.3};
  }
  EXPECT_NEAR(running_speed(mud, nodes), 0.3, 1e-12) << "across it nothing is displaced";
  nodes.back().rate.velocity.z() = -9.0;
  EXPECT_NEAR(running_speed(mud, nodes), 0.3, 1e-12) << "above the table neither";
  for (NodeState& node : nodes) node.rate.velocity.z() = 0.6 * node.position.z() / scene.start.bit_depth;
  EXPECT_NEAR(running_speed(mud, nodes), 0.3, 0.01) << "half, of a string stretched from above";
}

// With a rheology each section has the law's loss, and together they are what the circuit starts from.
TEST(MudCircuit, rheologyGivesTheLossesBySection)
{
  Scene scene = long_pipe();
  scene.rheology.emplace();
  scene.rheology->plastic_viscosity = 0.02;
  scene.rheology->yield_point = 6.0;
  scene.string.front().bit->nozzle_area = 4e-4;
  scene.rig.mud_pump.surface_lines = {{30.0, 0.09}};
  const MudCircuit mud = circuit_of(scene);
  const Rheology curve = {6.0, 0.02, 1.0};
  const double flow = scene.rig.mud_pump.max_flow, density = scene.mud.density, hole = scene.well.sections.back().diameter;
  const auto gradient = [&](const Passage& passage) { return pressure_gradient(curve, density, passage, flow / passage.area()); };
  const double bore = (scene.start.bit_depth + scene.start.block_height) * gradient({pipe_inner, 0.0, 0.0}),
               annulus = 990.0 * gradient({hole, pipe_outer, 0.0});
  EXPECT_NEAR(mud.losses.bore, bore, 0.002 * bore);
  EXPECT_NEAR(mud.losses.annulus, annulus, 0.01 * annulus);
  EXPECT_NEAR(mud.losses.lines, 30.0 * gradient({0.09, 0.0, 0.0}), 1.0);
  EXPECT_NEAR(mud.losses.bit, nozzle_loss(density, flow, 4e-4), 1.0);
  EXPECT_NEAR(mud.circuit.bore.loss, mud.losses.bore + mud.losses.lines + mud.losses.bit, 1e-3);
  EXPECT_NEAR(mud.circuit.bore.gel, 0.0, 1e-12) << "a gel of 5 Pa adds nothing to a yield point of 6";
  EXPECT_EQ(doubt_of_pressures(mud), "");
  const Mesh mesh = build_mesh(scene, scene.start.bit_depth + scene.start.block_height);
  EXPECT_NEAR(annulus_share(mud, mesh, 0.0), 1.0, 1e-9);
  EXPECT_NEAR(annulus_share(mud, mesh, 495.0), 0.5, 0.01);
  EXPECT_EQ(annulus_share(mud, mesh, 1005.0), 0.0) << "above the rotary table";
  HydraulicState state;
  state.stand_pipe_pressure = 3e7;
  const MudPressures pressures = mud_pressures(mud, state, 0.5 * flow);
  EXPECT_NEAR(pressures.in_bore(mud, mud.bore_above.size() - 1), 3e7 - pressures.lines, 1e5);
  EXPECT_LT(pressures.friction, 0.4 * mud.losses.bore);
}

TEST(MudCircuit, aSceneWithoutLossesHasNone)
{
  Scene scene = long_pipe();
  scene.rig.mud_pump.pressure_coefficient = 0.0;
  const MudCircuit mud = circuit_of(scene);
  EXPECT_EQ(mud.circuit.bore.loss, 0.0);
  EXPECT_EQ(mud.circuit.annulus.loss, 0.0);
  EXPECT_EQ(mud.displaced_area, 0.0);
}
}  // namespace test_model_mud_circuit
