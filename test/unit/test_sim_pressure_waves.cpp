// SPDX-License-Identifier: BSD-3-Clause
// Pressure waves with a rig: the way to the bit, the losses of the two volumes in steady flow, what the string feels, snapshots,
// connections, steps of any length.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "drill_rig_sim/solve/start.h"
#include "in_slips.h"
#include "playing.h"
#include "test_scenes.h"

namespace test_sim_pressure_waves
{
using namespace drill_rig_sim;

namespace
{
constexpr double depth = 990.0;

void add_waves(Scene& scene, int cylinders = 0)
{
  scene.rheology.emplace();
  scene.rheology->law = RheologyLaw::bingham;
  scene.rheology->plastic_viscosity = 0.02;
  scene.rheology->yield_point = 5.0;
  scene.string.front().bit->nozzle_area = 4e-4;
  scene.pressure_waves.emplace();
  scene.pressure_waves->cylinders = cylinders;
}

Scene hanging(int cylinders = 0)
{
  Scene scene = vertical_scene(1000.0, depth);
  scene.string = {bit_part(0.2159), collar_part(6, 9.4), pipe_part(0, 9.5, plain_pipe_mass, pipe_outer)};
  scene.numerics.level = Level::axial_torsional;
  scene.mud.axial_damping = 50.0;
  scene.rig.hoisting.rail_friction = 0.0;
  scene.rig.hoisting.line_damping = 0.3;
  scene.rig.mud_pump.flow_ramp = 10.0;
  add_waves(scene, cylinders);
  return scene;
}

Scene without_waves(Scene scene)
{
  scene.pressure_waves.reset();
  return scene;
}

double way_in_time(const Scene& scene)
{
  return (depth + scene.start.block_height) / std::sqrt(scene.mud.bulk_modulus / scene.mud.density);
}
}  // namespace

TEST(PressureWavesOfARig, reachTheBitAfterTheirWay)
{
  for (const double step : {0.01, 0.004, 0.0})
  {
    Scene scene = hanging();
    scene.numerics.step = step;
    Simulator rig(scene);
    rig.command(PumpSetpoint{0.03});
    double at_pump = -1.0, at_bit = -1.0;
    play(rig, 3.0,
         [&](const Truth& truth)
         {
           if (truth.stand_pipe_pressure > 1e5 && at_pump < 0.0) at_pump = truth.time;
           if (truth.bit_flow > 0.0 && at_bit < 0.0) at_bit = truth.time;
         });
    EXPECT_NEAR(at_bit - at_pump, way_in_time(scene), 0.05) << step;
  }
}

// Stand-pipe pressure, ECD and what the string feels are those of the two volumes in the end.
// The volumes' losses along the string are distributed as at the pump's largest flow, a few per cent off.
TEST(PressureWavesOfARig, endInTheSteadyFlowOfTheTwoVolumes)
{
  const Scene scene = hanging();
  Simulator waves(scene), volumes(without_waves(scene));
  for (Simulator* rig : {&waves, &volumes})
  {
    rig->command(PumpSetpoint{0.03});
    play(*rig, 120.0);
  }
  const Truth &one = waves.truth(), &other = volumes.truth();
  EXPECT_NEAR(one.bit_flow, 0.03, 1e-6);
  EXPECT_NEAR(one.stand_pipe_pressure, other.stand_pipe_pressure, 2e-3 * other.stand_pipe_pressure);
  EXPECT_NEAR(one.ecd - scene.mud.density, other.ecd - scene.mud.density, 2e-3 * (other.ecd - scene.mud.density));
  EXPECT_NEAR(one.hook_load, other.hook_load, 20.0);
  const auto saved = waves.save(), plain = volumes.save();
  const RigAtRest a = build_at_rest(scene), b = build_at_rest(without_waves(scene));
  const MudPressures pressures = pressures_in_mud(*a.model, saved->mechanics);
  const MudPressures expected = pressures_in_mud(*b.model, plain->mechanics);
  for (std::size_t e = 0; e < a.model->mesh().elements.size(); e += 7)
  {
    const double inner = expected.in_bore(b.model->mud(), e), outer = expected.in_annulus(b.model->mud(), e);
    EXPECT_NEAR(pressures.in_bore(a.model->mud(), e), inner, 0.02 * other.stand_pipe_pressure) << e;
    EXPECT_NEAR(pressures.in_annulus(a.model->mud(), e), outer, 0.08 * saved->mechanics.hydraulics.annulus_pressure) << e;
  }
}

TEST(PressureWavesOfARig, rippleWithThePumpsStrokes)
{
  Scene scene = hanging(3);
  scene.pressure_waves->dampener_volume = 0.0;
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.0318});  // a stroke a second
  play(rig, 60.0);
  double before = 0.0, mean = rig.truth().stand_pipe_pressure;
  for (int k = 0; k < 2; ++k)  // the second time about the mean of the first
  {
    int rises = 0, count = 0;
    double sum = 0.0;
    before = rig.truth().stand_pipe_pressure;
    play(rig, 20.0,
         [&](const Truth& truth)
         {
           rises += before < mean && truth.stand_pipe_pressure >= mean;
           before = truth.stand_pipe_pressure;
           sum += before;
           ++count;
         });
    mean = sum / count;
    if (k > 0)
    {
      EXPECT_NEAR(rises, 60, 1);
    }
  }
}

TEST(PressureWavesOfARig, aSnapshotBringsThemBack)
{
  Simulator rig(hanging(3));
  rig.command(PumpSetpoint{0.03});
  rig.command(WinchSetpoint{-0.1, false});
  play(rig, 1.23);
  const auto saved = rig.save();
  EXPECT_EQ(saved->mechanics.mud_waves.bore_with.size(), 50u);
  play(rig, 4.0);
  const Truth after = rig.truth();
  const PressureWaveState waves = rig.save()->mechanics.mud_waves;
  ASSERT_TRUE(rig.restore(*saved));
  play(rig, 4.0);
  EXPECT_EQ(rig.truth().hook_load, after.hook_load);
  EXPECT_EQ(rig.truth().stand_pipe_pressure, after.stand_pipe_pressure);
  EXPECT_EQ(rig.save()->mechanics.mud_waves.bore_with, waves.bore_with);
  EXPECT_EQ(rig.save()->mechanics.mud_waves.annulus_against, waves.annulus_against);
  Simulator volumes(without_waves(hanging(3)));
  EXPECT_FALSE(volumes.restore(*saved)) << "of another scene";
}

// A string that is let go at once surges; then its friction holds: the bit's pressure leads the two volumes'.
TEST(PressureWavesOfARig, feelTheStringsMotion)
{
  const Scene scene = hanging();
  Simulator waves(scene), volumes(without_waves(scene));
  double most[2] = {0.0, 0.0};
  int k = 0;
  for (Simulator* rig : {&waves, &volumes})
  {
    play(*rig, 1.0);
    rig->command(WinchSetpoint{-0.5, false});
    play(*rig, 8.0, [&](const Truth& truth) { most[k] = std::max(most[k], truth.ecd - scene.mud.density); });
    ++k;
  }
  EXPECT_GT(most[0], 1.2 * most[1]);
  EXPECT_GT(most[1], 0.0);
  EXPECT_EQ(waves.truth().bit_flow, 0.0);
}

TEST(PressureWavesOfARig, standStillThroughAConnection)
{
  Scene scene = slips_scene(Level::axial_torsional);
  add_waves(scene, 3);
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.02});
  play_on(rig, 10.0);
  EXPECT_GT(rig.truth().stand_pipe_pressure, 1e5);
  rig.command(PumpSetpoint{0.0});
  play_on(rig, 20.0);
  lay_into_slips(rig);
  const std::size_t nodes = rig.save()->mechanics.nodes.size();
  connect(rig, 1, false);
  EXPECT_GT(rig.save()->mechanics.nodes.size(), nodes);
  EXPECT_EQ(rig.truth().stand_pipe_pressure, 0.0);
  take_from_slips(rig);
  rig.command(PumpSetpoint{0.02});
  play_on(rig, 30.0);
  EXPECT_NEAR(rig.truth().bit_flow, 0.02, 0.002);
}
}  // namespace test_sim_pressure_waves
