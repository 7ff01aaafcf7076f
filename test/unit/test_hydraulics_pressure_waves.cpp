// SPDX-License-Identifier: BSD-3-Clause
// Pressure waves in bore and annulus against closed forms: Joukowsky, travel times, standing waves; steady losses, strokes,
// volumes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "wave_well.h"

namespace test_hydraulics_pressure_waves
{
using namespace drill_rig_sim;
using namespace wave_well;

TEST(PressureWaves, haveCellsOfTheWavesWay)
{
  const Well well;
  EXPECT_EQ(well.waves.bore.cells(), 50u);
  EXPECT_NEAR(50.0 * well.waves.tick, well.travel(), 1e-12);
  EXPECT_NEAR(well.waves.bore.impedance[7], well.bore_impedance(), 1e-6 * well.bore_impedance());
  EXPECT_NEAR(wave_tick(6000.0, 1000.0), 0.03, 1e-12);
  EXPECT_NEAR(wave_tick(100.0, 1000.0), 0.005, 1e-12);
  EXPECT_NEAR(wave_tick(3.0, 1000.0), 0.0015, 1e-12) << "two cells at least";
  double shares = 0.0;
  for (const WaveLine::Share& share : well.waves.bore.shares) shares += share.share;
  EXPECT_NEAR(shares, 1.0, 1e-12);
}

// Sections of other areas: an impedance of their own each, volumes to the litre.
TEST(PressureWaves, followTheSections)
{
  const WaveLine line = wave_line({{400.0, 4.0, 0.01, 1e5, 0, 400.0}, {600.0, 12.0, 0.03, 3e5, 1, 1200.0}}, 50, 0.02, 1e9);
  double volume = 0.0, gel = 0.0, first = 0.0, second = 0.0;
  for (const double impedance : line.impedance) volume += 0.02 / impedance * 1e9;
  for (const WaveLine::Node& node : line.nodes) gel += node.gel;
  for (const WaveLine::Share& share : line.shares) (share.section == 0 ? first : second) += share.share;
  EXPECT_NEAR(volume, 16.0, 1e-9);
  EXPECT_NEAR(gel, 4e5, 1e-6);
  EXPECT_NEAR(first, 1.0, 1e-12);
  EXPECT_NEAR(second, 0.5, 1e-12) << "half of what the law is for";
  EXPECT_NEAR(line.impedance[0], 2.0 * line.impedance[49], 1e-6 * line.impedance[0]);
  EXPECT_NEAR(line.outside[19], 0.01, 1e-12);
  EXPECT_NEAR(line.outside[20], 0.03, 1e-12);
}

// A flow that starts at once: rho a dv on the pump until the front comes back; a closed bit sends it back with its sign, the pump
// again: 1, 3, 5 times at 0, 2 L/a, 4 L/a.
TEST(PressureWaves, riseByJoukowskyAndComeBackAfterTwiceTheWay)
{
  Well well(water, 1e-9, 1e-12);
  const double rise = density * wave_speed * (0.02 / disc(diameter));
  const double tick = well.waves.tick, way = well.travel();
  well.run(0.02, 5.9 * way,
           [&]
           {
             const double passed = std::floor((well.time - 0.5 * tick) / (2.0 * way));
             EXPECT_NEAR(well.mud.stand_pipe_pressure, (2.0 * passed + 1.0) * rise, 1e-5 * rise) << well.time;
           });
  EXPECT_GT(rise, 2e6);
}

TEST(PressureWaves, fallByJoukowskyAtAStop)
{
  Well well;
  well.run(0.03, 60.0);
  const double before = well.mud.stand_pipe_pressure, friction = well.circuit.law.bore.at(0.03).loss;
  well.tick(0.0);
  EXPECT_NEAR(before - well.mud.stand_pipe_pressure, well.bore_impedance() * 0.03, 0.02 * friction);
}

TEST(PressureWaves, reachBitAndFlowLineAfterTheirWay)
{
  Well well(water, 1e-9);
  double at_bit = 0.0, at_flow_line = 0.0;
  well.run(0.02, 4.0 * well.travel(),
           [&]
           {
             if (well.flow > 0.0 && at_bit == 0.0) at_bit = well.time;
             if (well.mud.return_flow > 0.0 && at_flow_line == 0.0) at_flow_line = well.time;
           });
  EXPECT_NEAR(at_bit, well.travel() + well.waves.tick, 1e-9) << "a tick is the flow's mean over it";
  EXPECT_NEAR(at_flow_line, 2.0 * well.travel() + well.waves.tick, 1e-9);
}

// The annulus is closed at the bit and open above: a quarter wave.
TEST(PressureWaves, standInTheAnnulusWithAPeriodOfFourWays)
{
  Well well(water, 1e-9, 1e-12);
  for (auto* wave : {&well.state.annulus_with, &well.state.annulus_against}) std::fill(wave->begin(), wave->end(), 1e5);
  std::vector<double> turns;
  double before = 1e5;
  well.run(0.0, 60.0 * well.travel(),
           [&]
           {
             // 0.2 Pa less each time the bit draws: the error of its root
             EXPECT_NEAR(std::abs(well.mud.annulus_pressure), 1e5, 10.0);
             if (before * well.mud.annulus_pressure < 0.0) turns.push_back(well.time);
             before = well.mud.annulus_pressure;
           });
  ASSERT_GE(turns.size(), 29u);
  EXPECT_NEAR(turns[28] - turns[0], 14.0 * 4.0 * well.travel(), 1e-9);
}

TEST(PressureWaves, loseInSteadyFlowWhatTheLawSays)
{
  for (const Rheology& law : {water, bingham})
    for (const double flow : {0.01, 0.03, 0.06})
    {
      Well well(law);
      well.loads.ways.load = 2e5;
      well.loads.ways.narrowing = 1.2;
      well.loads.motor_pressure = 3e6;
      well.run(flow, 200.0);
      const double outer = 1.2 * well.circuit.law.outer(flow, 0.0).loss + 2e5;
      EXPECT_NEAR(well.flow, flow, 1e-9);
      EXPECT_NEAR(well.mud.return_flow, flow, 1e-9);
      EXPECT_NEAR(well.mud.annulus_pressure, outer, 1e-6 * outer);
      const double all = well.circuit.law.inner(flow).loss + 3e6 + outer;
      EXPECT_NEAR(well.mud.stand_pipe_pressure, all, 1e-6 * all);
    }
}

TEST(PressureWaves, loseNoMud)
{
  Well well(bingham);
  well.waves.spec.cylinders = 3;
  well.waves.spec.dampener_volume = 0.0757;
  well.state = waves_at_rest(well.waves, 0.0, 0.0);
  for (const double flow : {0.03, 0.05, 0.02, 0.0})
  {
    well.run(flow, well.time + 7.0);
    const double stroke = delivered_strokes(well.state.strokes, 3) - delivered_strokes(0.0, 3);
    if (flow > 0.0)
    {
      EXPECT_NEAR(stroke * well.pump.stroke_volume - well.returned, well.held(), 1e-6) << flow;
    }
  }
  EXPECT_GE(well.mud.stand_pipe_pressure, 0.0);
}

// A string that starts to run in at v pushes mud up: rho a A_o v/A at first, then the losses of surge.
TEST(PressureWaves, surgeWithTheMudsInertia)
{
  Well well(bingham, 1.0, 1e-9);
  well.loads.string_speed = 0.5;
  well.loads.displaced = 0.5 * well.circuit.law.displaced_area;
  well.tick(0.0);
  const double inertia = density * wave_speed * disc(outside) * 0.5 / Well::around();
  EXPECT_NEAR(well.mud.annulus_pressure, inertia, 0.03 * inertia);
  well.run(0.0, 400.0);
  const double surge = well.circuit.law.outer(0.0, well.loads.displaced).loss;
  EXPECT_NEAR(well.mud.annulus_pressure, surge, 1e-6 * surge);
  EXPECT_NEAR(well.mud.return_flow, disc(outside) * 0.5, 1e-9);
  well.loads.string_speed = -0.5;
  well.loads.displaced = -well.loads.displaced;
  well.run(0.0, 800.0);
  EXPECT_NEAR(well.mud.annulus_pressure, -surge, 1e-6 * surge);
  EXPECT_EQ(well.flow, 0.0) << "the bit counts as closed";
}

TEST(PressureWaves, waitForTheGel)
{
  Well well(water, 1.0, 4e-4, 2e6);
  well.run(0.002, 2.0 * well.travel());
  EXPECT_EQ(well.flow, 0.0);
  EXPECT_GT(well.mud.stand_pipe_pressure, 1e5);
  well.run(0.03, 100.0);
  EXPECT_NEAR(well.flow, 0.03, 1e-6);
  EXPECT_LT(well.mud.bore_gel, 1e-6);
}

// A step that was rejected and comes again in parts leaves what one step leaves.
TEST(PressureWaves, goOnOnceInARepeatedStep)
{
  Well once, twice;
  once.run(0.03, 3.0);
  twice.run(0.03, 3.0);
  const double tick = once.waves.tick;
  const HydraulicState before = twice.mud;
  advance_pressure_waves(twice.pump, twice.circuit, twice.waves, 0.03, twice.loads, twice.time, tick, twice.flow, twice.mud,
                         twice.state);
  twice.mud = before;
  for (int part = 0; part < 2; ++part)
    advance_pressure_waves(twice.pump, twice.circuit, twice.waves, 0.03, twice.loads, twice.time + 0.5 * part * tick, 0.5 * tick,
                           twice.flow, twice.mud, twice.state);
  once.tick(0.03);
  EXPECT_EQ(once.mud.stand_pipe_pressure, twice.mud.stand_pipe_pressure);
  EXPECT_EQ(once.state.time, twice.state.time);
  EXPECT_EQ(once.flow, twice.flow);
}
}  // namespace test_hydraulics_pressure_waves
