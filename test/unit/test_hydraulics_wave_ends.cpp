// SPDX-License-Identifier: BSD-3-Clause
// Pressure waves at pump, bit and a hole in the string: pistons, dampener, relief valve, pulser, nozzles, plug.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "wave_well.h"

namespace test_hydraulics_wave_ends
{
using namespace drill_rig_sim;
using namespace wave_well;

TEST(PressureWaveEnds, keepTheirPumpAtItsReliefPressureAndAboveZero)
{
  Well well;
  well.pump.relief_pressure = 3e6;
  well.run(0.06, 10.0);
  EXPECT_EQ(well.mud.stand_pipe_pressure, 3e6);
  EXPECT_TRUE(well.mud.relief_open);
  EXPECT_LT(well.flow, 0.059);
  well.run(0.0, 100.0, [&] { EXPECT_GE(well.mud.stand_pipe_pressure, 0.0); });
  EXPECT_FALSE(well.mud.relief_open);
  EXPECT_NEAR(well.mud.stand_pipe_pressure, 0.0, 1e4);
}

// Crank and rod: three pistons deliver 17 % below to 6 % above their mean (Miller, The Reciprocating Pump), thrice a stroke.
TEST(PressureWaveEnds, comeFromThePistons)
{
  EXPECT_EQ(delivered_strokes(1.37, 0), 1.37);
  for (const int cylinders : {1, 3, 5})
    EXPECT_NEAR(delivered_strokes(7.21, cylinders) - delivered_strokes(3.21, cylinders), 4.0, 1e-12);
  double least = 2.0, most = 0.0;
  constexpr double h = 1e-5;
  for (double s = 0.0; s < 1.0; s += 1e-3)
  {
    const double rate = (delivered_strokes(s + h, 3) - delivered_strokes(s, 3)) / h;
    least = std::min(least, rate);
    most = std::max(most, rate);
    EXPECT_NEAR(delivered_strokes(s + 1.0 / 3.0, 3) - delivered_strokes(s, 3), 1.0 / 3.0, 1e-12);
  }
  EXPECT_NEAR(least, 0.83, 0.005);
  EXPECT_NEAR(most, 1.06, 0.005);
}

namespace
{
/// Amplitude of a part of the stand-pipe pressure at a frequency over the last ten seconds [Pa].
double part_at(Well& well, double flow, double frequency)
{
  double cosine = 0.0, sine = 0.0;
  int count = 0;
  well.run(flow, 60.0);
  well.run(flow, 70.0,
           [&]
           {
             const double angle = 2.0 * pi * frequency * well.time;
             cosine += std::cos(angle) * well.mud.stand_pipe_pressure;
             sine += std::sin(angle) * well.mud.stand_pipe_pressure;
             ++count;
           });
  return 2.0 * std::hypot(cosine, sine) / count;
}
}  // namespace

TEST(PressureWaveEnds, rippleAtStrokesTimesCylinders)
{
  const double flow = 0.0318;  // one stroke a second
  const auto with = [&](double dampener, double frequency)
  {
    Well well;
    well.waves.spec.cylinders = 3;
    well.waves.spec.dampener_volume = dampener;
    well.state = waves_at_rest(well.waves, 0.0, 0.0);
    return part_at(well, flow, frequency);
  };
  const double third = with(0.0, 3.0);
  EXPECT_GT(third, 1e5);
  for (const double other : {1.0, 2.0, 4.0}) EXPECT_LT(with(0.0, other), 0.01 * third) << other;
  EXPECT_LT(with(0.0757, 3.0), 0.5 * third) << "the dampener";
}

// The pump holds the flow: a pulse arrives after the way, and in the end has its height at this flow.
TEST(PressureWaveEnds, carryPulsesUpThePipe)
{
  Well well;
  const double flow = 0.03;
  well.waves.spec.pulse_height = 1e4;
  well.waves.spec.pulse_period = 80.0;  // open from 40 s on
  well.run(flow, 39.99);
  const double closed = well.mud.stand_pipe_pressure;
  double changed = 0.0;
  well.run(flow, 79.0,
           [&]
           {
             if (changed == 0.0 && well.mud.stand_pipe_pressure < closed - 100.0) changed = well.time;
           });
  EXPECT_NEAR(changed - 40.0, well.travel() + well.waves.tick, 1.01 * well.waves.tick);
  EXPECT_NEAR(closed - well.mud.stand_pipe_pressure, 1e4 * std::pow(flow / largest_flow, 2), 1.0);
}

// A rarefaction below the bit draws mud through its nozzles: f - b = (Z_1 + Z_2) Q + k Q^2, k of nozzle_loss().
TEST(PressureWaveEnds, drawMudThroughTheNozzles)
{
  Well well(water, 1e-9);
  constexpr double from_bore = 1e6, from_annulus = -5e5;
  std::fill(well.state.bore_with.begin(), well.state.bore_with.end(), from_bore);
  std::fill(well.state.annulus_against.begin(), well.state.annulus_against.end(), from_annulus);
  well.tick(0.0);
  const double annulus = density * wave_speed / Well::around(), z = well.bore_impedance() + annulus;
  const double k = nozzle_loss(density, 1.0, 4e-4), driving = from_bore - from_annulus;
  const double flow = 2.0 * driving / (z + std::sqrt(z * z + 4.0 * k * driving));
  EXPECT_NEAR(well.flow, flow, 1e-6 * flow);
  EXPECT_NEAR(well.mud.annulus_pressure, from_annulus + annulus * flow, 1.0);
  EXPECT_LT(well.mud.annulus_pressure, 0.0);
}

// A string that is pulled counts as closed, whatever its nozzles.
TEST(PressureWaveEnds, swabDrawsNothingFromTheString)
{
  Well well(bingham);
  well.loads.string_speed = -0.5;
  well.loads.displaced = -0.5 * well.circuit.law.displaced_area;
  well.run(0.0, 400.0);
  const double swab = well.circuit.law.outer(0.0, well.loads.displaced).loss;
  EXPECT_LT(swab, -1e5);
  EXPECT_NEAR(well.mud.annulus_pressure, swab, -1e-6 * swab);
  EXPECT_EQ(well.flow, 0.0);
}

TEST(PressureWaveEnds, leakThroughAHole)
{
  Well well;
  well.loads.leak_area = 1e-4;
  well.loads.leak_element = 1;
  well.run(0.03, 200.0);
  EXPECT_NEAR(well.mud.return_flow, 0.03, 1e-9);
  const double leak = 0.03 - well.flow;
  const double half_bore = 0.5 * well.circuit.law.bore.at(well.flow).loss,
               half_annulus = 0.5 * well.circuit.law.outer(well.flow, 0.0).loss;
  const double across = well.circuit.law.inner(well.flow).loss - 2.0 * half_bore + half_bore + half_annulus;
  EXPECT_NEAR(leak, orifice_flow(1e-4, across, density), 0.01 * leak);
  EXPECT_GT(leak, 0.003);
}

// What a plug holds back stands below it.
TEST(PressureWaveEnds, standBelowAPlug)
{
  Well well;
  well.loads.ways.plug = 2e6;
  well.run(0.001, 10.0 * well.travel());
  EXPECT_EQ(well.flow, 0.0);
  EXPECT_GT(well.mud.annulus_pressure, 1e5);
  EXPECT_LT(well.mud.annulus_pressure, 2e6);
  well.run(0.03, 200.0);
  EXPECT_NEAR(well.flow, 0.03, 1e-9);
  EXPECT_NEAR(well.mud.annulus_pressure, 2e6 + well.circuit.law.outer(0.03, 0.0).loss, 10.0);
}
}  // namespace test_hydraulics_wave_ends
