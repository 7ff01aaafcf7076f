// SPDX-License-Identifier: BSD-3-Clause
// Temperature in a hole with a string: weight of the mud against closed forms, losses against the laws along the hole, readings,
// rest, new hole, connections, snapshots, nothing where nothing depends on temperature.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/mud_temperature.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "drill_rig_sim/solve/start.h"
#include "in_slips.h"
#include "playing.h"
#include "test_scenes.h"

namespace test_sim_mud_temperature
{
using namespace drill_rig_sim;

namespace
{
constexpr double hole = 0.2159;

/// Straight hole with a bit, collars and pipe without tool joints.
Scene well(double depth, double inclination = 0.0)
{
  Scene scene = scene_in({{0.0, inclination, 0.0}, {depth, inclination, 0.0}}, depth, depth - 10.0, 0.2);
  scene.string = {bit_part(hole), collar_part(10, 9.4), pipe_part(0, 9.5, plain_pipe_mass, pipe_outer)};
  scene.string.front().bit->nozzle_area = 4e-4;
  scene.numerics.level = Level::axial_torsional;
  scene.numerics.element_length = 28.5;
  scene.rig.hoisting.rail_friction = 0.0;
  scene.mud.density = 1200.0;
  scene.mud.axial_damping = 20.0;
  scene.mud.torsional_damping = 0.02;
  scene.rheology.emplace();
  scene.rheology->law = RheologyLaw::bingham;
  scene.rheology->plastic_viscosity = 0.02;
  scene.rheology->yield_point = 5.0;
  scene.temperature.emplace();
  return scene;
}

Scene without(Scene scene)
{
  scene.temperature.reset();
  return scene;
}

TemperatureState temperature_of(const Simulator& rig)
{
  return rig.save()->mechanics.temperature;
}

/// The signals that hydraulics make.
void expect_same_mud(const Truth& a, const Truth& b, double tolerance)
{
  EXPECT_NEAR(a.stand_pipe_pressure, b.stand_pipe_pressure, tolerance * a.stand_pipe_pressure);
  EXPECT_NEAR(a.ecd, b.ecd, tolerance * a.ecd);
  EXPECT_NEAR(a.hook_load, b.hook_load, tolerance * a.hook_load);
}
}  // namespace

// g rho int(exp(-alpha (T - T_i)) - 1) dz of a linear T, without compressibility; and -ln(1 - kappa g rho z)/kappa - g rho z
// without expansion.
TEST(MudTemperature, weighsWhatItsDensityMakesOfADepth)
{
  Scene scene = well(3000.0);
  MudTemperatureSpec& spec = *scene.temperature;
  spec.compressibility = 0.0;
  const double depth = 2990.0, reference = standard_gravity * 1200.0, rate = spec.expansion * spec.gradient;
  const double warm = std::exp(spec.expansion * (spec.inlet - spec.surface));
  const double expanded = reference * (warm * -std::expm1(-rate * depth) / rate - depth);
  const Simulator hot(scene);
  EXPECT_NEAR(temperature_of(hot).heads.annulus, expanded, 1e-4 * std::abs(expanded));
  EXPECT_NEAR(temperature_of(hot).heads.bore, expanded, 1e-4 * std::abs(expanded));
  EXPECT_LT(expanded, -3e5);
  EXPECT_NEAR(hot.truth().ecd, 1200.0 + expanded / (standard_gravity * depth), 0.01);
  EXPECT_EQ(hot.truth().stand_pipe_pressure, 0.0);

  spec.expansion = 0.0;
  spec.compressibility = 4.4e-10;
  const double compressed = -std::log1p(-spec.compressibility * reference * depth) / spec.compressibility - reference * depth;
  const Simulator deep(scene);
  EXPECT_NEAR(temperature_of(deep).heads.annulus, compressed, 1e-3 * compressed);
  EXPECT_NEAR(deep.truth().ecd, 1200.0 + compressed / (standard_gravity * depth), 0.02);
}

TEST(MudTemperature, goesByTheTrueVerticalDepth)
{
  const Simulator rig(well(2000.0, 60.0 * degree));
  const TemperatureState t = temperature_of(rig);
  const MudTemperatureSpec spec;
  EXPECT_NEAR(t.heat.annulus.front(), ground_temperature(spec, 2.5), 0.1);
  EXPECT_NEAR(rig.truth().bottom_hole_temperature, ground_temperature(spec, 990.0), 0.3);
  EXPECT_NEAR(rig.truth().flow_line_temperature, spec.surface, 0.2);
}

TEST(MudTemperature, changesNothingWhereNothingDependsOnIt)
{
  Scene scene = well(1000.0);
  scene.temperature->activation = scene.temperature->expansion = scene.temperature->compressibility = 0.0;
  Simulator with(scene), none(without(scene));
  for (Simulator* rig : {&with, &none})
  {
    rig->command(PumpSetpoint{0.03});
    play(*rig, 40.0);
  }
  EXPECT_GT(with.truth().flow_line_temperature, 0.0);
  EXPECT_EQ(none.truth().flow_line_temperature, 0.0);
  EXPECT_EQ(none.truth().bottom_hole_temperature, 0.0);
  EXPECT_FALSE(temperature_of(none).any());
  expect_same_mud(none.truth(), with.truth(), 2e-3);
}

// Stand pipe and ECD of steady flow against the laws of flow_losses.h, summed over the cells.
TEST(MudTemperature, losesWhatTheLawsSayAlongTheHole)
{
  Scene scene = well(3000.0);
  scene.temperature->circulated = 4.0 * 3600.0;
  scene.rig.mud_pump.max_flow = 0.04;
  Simulator rig(scene);
  for (const double flow : {0.03, 0.012})
  {
    rig.command(PumpSetpoint{flow});
    play(rig, 150.0);
    const TemperatureState t = temperature_of(rig);
    const MudTemperatureSpec& spec = *scene.temperature;
    const Mesh mesh = build_mesh(scene, scene.start.bit_depth + scene.start.block_height);
    double inner = nozzle_loss(t.losses.bit_density * 1200.0, flow, 4e-4), outer = 0.0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    {
      const MeshElement& element = mesh.elements[e];
      const double md = 2990.0 - mesh.middle(e), bore = std::sqrt(4.0 / pi * element.bore_area);
      const std::size_t i = static_cast<std::size_t>(std::max(md, 0.0) / t.cell_length);
      const auto gradient = [&](double temperature, const Passage& passage)
      {
        const double f = viscosity_factor(spec, temperature);
        const double density = 1200.0 * density_ratio(spec, temperature, standard_gravity * 1200.0 * md);
        return pressure_gradient({f * 5.0, f * 0.02, 1.0}, density, passage, flow / passage.area());
      };
      if (bore > 0.0) inner += element.section.length * gradient(t.heat.bore_mean[i], {bore, 0.0, 0.0});
      if (md > 0.0) outer += element.section.length * gradient(t.heat.annulus_mean[i], {hole, element.outer_diameter, 0.0});
    }
    const double stand_pipe = inner + outer + t.heads.annulus - t.heads.bore;
    EXPECT_NEAR(rig.truth().stand_pipe_pressure, stand_pipe, 0.01 * stand_pipe) << flow;
    const double ecd = 1200.0 + (outer + t.heads.annulus) / (standard_gravity * 2990.0);
    EXPECT_NEAR(rig.truth().ecd, ecd, 0.5) << flow;
    EXPECT_LT(t.heads.annulus, t.heads.bore) << "the bore is colder";
  }
}

TEST(MudTemperature, givesPressureWavesTheSameSteadyFlow)
{
  Scene scene = well(1500.0), waves = scene;
  scene.temperature->circulated = waves.temperature->circulated = 3600.0;
  waves.pressure_waves.emplace();
  waves.pressure_waves->cylinders = 0;
  Simulator two_volumes(scene), waving(waves);
  for (Simulator* rig : {&two_volumes, &waving})
  {
    rig->command(PumpSetpoint{0.025});
    play(*rig, 120.0);
  }
  expect_same_mud(two_volumes.truth(), waving.truth(), 2e-3);
  for (Simulator* rig : {&two_volumes, &waving})
  {
    rig->command(PumpSetpoint{0.0});
    play(*rig, 120.0);
  }
  EXPECT_GT(two_volumes.truth().ecd, waving.truth().ecd) << "it holds what the yield stress can";
  EXPECT_EQ(waving.truth().bit_flow, 0.0);
}

TEST(MudTemperature, ofColdMudRaisesThePressure)
{
  Scene scene = well(1500.0);
  scene.temperature->circulated = 4.0 * 3600.0;
  Scene cold = scene;
  cold.temperature->inlet = 5.0;
  Simulator warm_rig(scene), cold_rig(cold);
  for (Simulator* rig : {&warm_rig, &cold_rig})
  {
    rig->command(PumpSetpoint{0.025});
    play(*rig, 60.0);
  }
  EXPECT_GT(cold_rig.truth().stand_pipe_pressure, 1.03 * warm_rig.truth().stand_pipe_pressure);
  EXPECT_LT(cold_rig.truth().bottom_hole_temperature, warm_rig.truth().bottom_hole_temperature - 3.0);
}

TEST(MudTemperature, warmsAgainAtRest)
{
  Scene scene = well(2500.0);
  scene.temperature->circulated = 6.0 * 3600.0;
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.03});
  play(rig, 60.0);
  const double circulating = rig.truth().bottom_hole_temperature, ground = ground_temperature(*scene.temperature, 2490.0);
  EXPECT_LT(circulating, ground - 15.0);
  rig.command(PumpSetpoint{0.0});
  play(rig, 300.0);
  EXPECT_GT(rig.truth().bottom_hole_temperature, circulating + 1.0);
  EXPECT_LT(rig.truth().bit_flow, 1e-4);
}

// The pump starts again after ten minutes; mud of the bore, 20 K colder or so, comes around the bit. A cell of 15 m holds
// 0.35 m3, of which 0.03 m3 are renewed in a second.
TEST(MudTemperature, atTheBitDoesNotJump)
{
  Scene scene = well(3000.0);
  scene.temperature->circulated = 6.0 * 3600.0;
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.0});
  play(rig, 600.0);
  const TemperatureState rested = temperature_of(rig);
  const std::size_t bottom = static_cast<std::size_t>(2990.0 / rested.cell_length);
  const double apart = std::abs(rested.heat.annulus[bottom] - rested.heat.bore[bottom]);
  rig.command(PumpSetpoint{0.03});
  double last = rig.truth().bottom_hole_temperature, largest = 0.0;
  const double before = last;
  for (int k = 0; k < 300; ++k)
  {
    play(rig, 1.0);
    largest = std::max(largest, std::abs(rig.truth().bottom_hole_temperature - last));
    last = rig.truth().bottom_hole_temperature;
  }
  EXPECT_LT(largest, 0.1 * apart + 0.3) << apart << " K between bore and annulus, from " << before << " to " << last;
  // then it is that of the mud from the bore and what the nozzles dissipate, but for what the lowest cell gains from the rock
  const TemperatureState t = temperature_of(rig);
  const double nozzles = nozzle_loss(t.losses.bit_density * 1200.0, 0.03, 4e-4) / (1200.0 * scene.temperature->heat_capacity);
  EXPECT_NEAR(nozzles, 0.9, 0.1);
  EXPECT_NEAR(last, t.heat.bore[bottom] + nozzles, 0.4);
}

// A bit that is pulled through the cells of a hole at rest reads the ground, and through a hole that was circulated no steps.
TEST(MudTemperature, followsTheBitWithoutSteps)
{
  for (const double circulated : {0.0, 6.0 * 3600.0})
  {
    Scene scene = well(3000.0);
    scene.temperature->circulated = circulated;
    RigAtRest rig = build_at_rest(scene);
    State& state = rig.state;
    const Eigen::Vector3d up(0.0, 0.0, 1.0);
    double last = 0.0;
    for (int k = 0; k < 400; ++k)
    {
      for (NodeState& node : state.nodes) node.position += 0.25 * up;
      renew_temperature(*rig.model, state);
      const double now = state.temperature.bit, depth = -state.nodes.front().position.z();
      const double ground = ground_temperature(*scene.temperature, depth);  // at the bit's face
      EXPECT_NEAR(now, circulated > 0.0 ? now : ground, 0.01) << depth;
      EXPECT_NEAR(now, k > 0 ? last : now, 0.05) << depth;
      last = now;
    }
  }
}

// The bit reads new hole as it grows by cells.
TEST(MudTemperature, followsNewHoleWithoutSteps)
{
  Scene scene = well(1000.0);
  RigAtRest rig = build_at_rest(scene);
  rig.state.flow = 0.03;
  const Eigen::Vector3d down = rig.state.well.end_direction();
  for (NodeState& node : rig.state.nodes) node.position += 10.0 * down;
  for (int k = 0; k < 600; ++k) advance_temperature(*rig.model, 60.0, rig.state);
  double last = rig.state.temperature.bit;
  for (int k = 0; k < 600; ++k)
  {
    rig.state.nodes.front().position += 0.05 * down;
    rig.state.well.extend(0.05 * down, down);
    advance_temperature(*rig.model, 1.0, rig.state);
    EXPECT_LT(std::abs(rig.state.temperature.bit - last), 0.15) << k;  // the first of it holds mud that rested below the bit
    last = rig.state.temperature.bit;
  }
}

TEST(MudTemperature, doesNotDrainABoreThatIsHeavier)
{
  Scene scene = well(2500.0);
  scene.rheology->law = RheologyLaw::newtonian;
  scene.temperature->circulated = 6.0 * 3600.0;
  Scene waves = scene;
  waves.pressure_waves.emplace();
  Simulator two_volumes(scene), waving(waves);
  for (Simulator* rig : {&two_volumes, &waving})
  {
    rig->command(PumpSetpoint{0.03});
    play(*rig, 60.0);
    rig->command(PumpSetpoint{0.0});
    play(*rig, 60.0);
    const TemperatureState t = temperature_of(*rig);
    EXPECT_GT(t.heads.bore, t.heads.annulus + 5e4);
    EXPECT_LT(rig->truth().bit_flow, 2e-4) << "drawn by its weight it would be ten times as much";
    EXPECT_GE(rig->truth().stand_pipe_pressure, 0.0);
    const double ecd = 1200.0 + t.heads.annulus / (standard_gravity * 2490.0);
    EXPECT_NEAR(rig->truth().ecd, ecd, 1.0);
  }
}

TEST(MudTemperature, followsNewHole)
{
  RigAtRest rig = build_at_rest(well(1000.0));
  const MudTemperatureSpec spec;
  rig.state.flow = 0.03;
  const int before = rig.state.temperature.opened;
  const Eigen::Vector3d down = rig.state.well.end_direction();
  for (int k = 0; k < 2100; ++k)
  {
    rig.state.nodes.front().position += 0.05 * down;
    rig.state.well.extend(0.05 * down, down);
    advance_temperature(*rig.model, 1.0, rig.state);
  }
  const TemperatureState& t = rig.state.temperature;
  EXPECT_EQ(t.opened, before + 10);
  const std::size_t last = static_cast<std::size_t>(t.opened) - 1;
  EXPECT_NEAR(t.heat.rock[rock_rings * last + rock_rings - 1], ground_temperature(spec, 1103.0), 0.5)
      << "rock is found as it was";
  for (std::size_t i = 0; i <= last; ++i)
  {
    EXPECT_GT(t.heat.annulus[i], spec.surface - 1.0);
    EXPECT_LT(t.heat.annulus[i], ground_temperature(spec, 1105.0));
  }
}

TEST(MudTemperature, theWholeBalanceCloses)
{
  RigAtRest rig = build_at_rest(well(1500.0));
  State& state = rig.state;
  state.flow = 0.03;
  // all that friction dissipates leaves with the mud or heats what is there
  const auto power = [&]
  {
    const SectionLosses& law = rig.model->mud().circuit.law;
    const LossPlaces& places = state.temperature.losses;
    return 0.03 * (law.in_bore(0.03, &places).loss + law.nozzles(0.03, &places) + law.outer(0.03, 0.0, &places).loss);
  };
  for (int k = 0; k < 3000; ++k) advance_temperature(*rig.model, 1e5, state);  // nine years
  const HeatMud& mud = *rig.model->heat();
  const TemperatureState& t = state.temperature;
  double from_ground = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(t.opened); ++i)
  {
    const double md = (static_cast<double>(i) + 0.5) * t.cell_length;
    from_ground += mud.rock.conductance.back() * t.cell_length *
                   (ground_temperature(mud.spec, md) - t.heat.rock[rock_rings * i + rock_rings - 1]);
  }
  const double carried = mud.capacity() * 0.03 * (t.flow_line - mud.spec.inlet);
  EXPECT_NEAR(carried, power() + from_ground, 0.02 * power()) << "a hundredth of the bore is above the table";
}

TEST(MudTemperature, aSnapshotBringsItBack)
{
  Simulator rig(well(800.0));
  rig.command(PumpSetpoint{0.03});
  rig.command(WinchSetpoint{-0.02, false});
  play(rig, 12.35);
  const auto saved = rig.save();
  play(rig, 6.0);
  const Truth after = rig.truth();
  const TemperatureState then = temperature_of(rig);
  ASSERT_TRUE(rig.restore(*saved));
  play(rig, 6.0);
  EXPECT_EQ(rig.truth().hook_load, after.hook_load);
  EXPECT_EQ(rig.truth().ecd, after.ecd);
  EXPECT_EQ(rig.truth().stand_pipe_pressure, after.stand_pipe_pressure);
  EXPECT_EQ(rig.truth().flow_line_temperature, after.flow_line_temperature);
  EXPECT_EQ(temperature_of(rig).heat.rock, then.heat.rock);
  EXPECT_EQ(temperature_of(rig).heat.bore, then.heat.bore);
  Simulator other(without(well(800.0)));
  EXPECT_FALSE(other.restore(*saved)) << "no temperatures there";
}

TEST(MudTemperature, goesOnThroughAConnection)
{
  Scene scene = slips_scene(Level::axial_torsional);
  scene.string.front().bit->nozzle_area = 4e-4;
  scene.rheology = well(300.0).rheology;
  scene.temperature.emplace();
  scene.connections = Connections::automatic;
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.03});
  play_on(rig, 20.0);
  const double length = rig.save()->string.length;
  const std::vector<double> before = temperature_of(rig).heat.annulus;
  rig.command(WinchSetpoint{-0.1, false});
  const int stands = rig.truth().stand_count;
  for (int k = 0; k < 200 && rig.truth().stand_count == stands; ++k) play_on(rig, 1.0);
  ASSERT_GT(rig.save()->string.length, length);
  const TemperatureState t = temperature_of(rig);
  for (std::size_t i = 0; i < static_cast<std::size_t>(t.opened); ++i) EXPECT_NEAR(t.heat.annulus[i], before[i], 3.0);
  rig.command(PumpSetpoint{0.03});
  play_on(rig, 30.0);
  EXPECT_GT(rig.truth().stand_pipe_pressure, 1e6);
}
}  // namespace test_sim_mud_temperature
