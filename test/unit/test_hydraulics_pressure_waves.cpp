// SPDX-License-Identifier: BSD-3-Clause
// Pressure waves in bore and annulus against closed forms: Joukowsky, travel times, standing waves; steady losses, strokes,
// volumes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "drill_rig_sim/hydraulics/pressure_waves.h"
#include "drill_rig_sim/hydraulics/pump_strokes.h"
#include "drill_rig_sim/math/units.h"

namespace test_hydraulics_pressure_waves
{
using namespace drill_rig_sim;

namespace
{
constexpr double density = 1200.0, bulk_modulus = 1.4e9, length = 1080.12345, diameter = 0.1086;
constexpr double hole = 0.2159, outside = 0.127, largest_flow = 0.06;
const double wave_speed = std::sqrt(bulk_modulus / density);
const Rheology water = {0.0, 1e-3, 1.0}, bingham = {5.0, 0.02, 1.0};

double disc(double d)
{
  return 0.25 * pi * d * d;
}

/// Plain pipe in a plain hole.
struct Well
{
  MudPumpSpec pump;
  HydraulicCircuit circuit;
  PressureWaves waves;
  WaveLoads loads;
  HydraulicState mud;
  PressureWaveState state;
  double flow = 0.0, time = 0.0, returned = 0.0;

  /// @param friction  factor on the losses of pipe and annulus
  explicit Well(const Rheology& law = water, double friction = 1.0, double nozzle_area = 4e-4, double gel = 0.0)
  {
    pump.flow_ramp = 1e6;
    pump.relief_pressure = 1e9;
    MudSections sections;
    sections.bore = {{{diameter, 0.0, 0.0}, friction * length}};
    sections.annulus = {{{hole, outside, 0.0}, friction * length}};
    sections.nozzle_area = nozzle_area;
    circuit.nominal_flow = pump.max_flow = largest_flow;
    circuit.law = section_losses(law, density, sections, largest_flow);
    waves.spec.cylinders = 0;
    waves.spec.dampener_volume = 0.0;
    waves.density = density;
    waves.tick = wave_tick(length, wave_speed);
    const std::size_t cells = static_cast<std::size_t>(std::lround(length / wave_speed / waves.tick));
    const auto line = [&](double area, double displaced)
    {
      const std::vector<WaveStretch> stretches = {{0.3 * length, 0.3 * length * area, displaced, 0.3 * gel, 0, length},
                                                  {0.7 * length, 0.7 * length * area, displaced, 0.7 * gel, 0, length}};
      return wave_line(stretches, cells, waves.tick, bulk_modulus);
    };
    waves.bore = line(disc(diameter), 0.0);
    waves.annulus = line(around(), disc(outside));
    waves.bore_losses = bore_section_losses(law, density, sections, largest_flow);
    waves.bore_cell = {cells - 1, cells / 2, 0};
    waves.annulus_cell = {0, cells / 2, cells - 1};
    state = waves_at_rest(waves, 0.0, 0.0);
  }

  static double around() { return disc(hole) - disc(outside); }
  double bore_impedance() const { return density * wave_speed / disc(diameter); }
  double travel() const { return length / wave_speed; }
  /// A tick at a commanded flow.
  void tick(double commanded)
  {
    advance_pressure_waves(pump, circuit, waves, commanded, loads, time, waves.tick, flow, mud, state);
    time += waves.tick;
    returned += state.return_flow * waves.tick;
  }
  /// At a commanded flow until a time [s]; calls look() behind each tick.
  template <class Look>
  void run(double commanded, double until, const Look& look)
  {
    while (time + 0.5 * waves.tick < until)
    {
      tick(commanded);
      look();
    }
  }
  void run(double commanded, double until)
  {
    run(commanded, until, [] {});
  }
  /// Compression of mud and gas.
  double held() const { return stored_mud(waves, state) + waves.spec.dampener_volume - state.gas; }
};
}  // namespace

TEST(PressureWaves, haveCellsOfTheWavesWay)
{
  const Well well;
  EXPECT_EQ(well.waves.bore.cells(), 50u);
  EXPECT_NEAR(50.0 * well.waves.tick, well.travel(), 1e-12);
  EXPECT_NEAR(well.waves.bore.impedance[7], well.bore_impedance(), 1e-6 * well.bore_impedance());
  EXPECT_NEAR(wave_tick(5000.0, 1000.0), 0.02, 1e-12);
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
  Well well(water, 1e-9, 1e-9);
  for (auto* wave : {&well.state.annulus_with, &well.state.annulus_against}) std::fill(wave->begin(), wave->end(), 1e5);
  std::vector<double> turns;
  double before = 1e5;
  well.run(0.0, 60.0 * well.travel(),
           [&]
           {
             EXPECT_NEAR(std::abs(well.mud.annulus_pressure), 1e5, 1.0);
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

TEST(PressureWaves, keepTheirPumpAtItsReliefPressureAndAboveZero)
{
  Well well;
  well.pump.relief_pressure = 3e6;
  well.run(0.06, 10.0);
  EXPECT_EQ(well.mud.stand_pipe_pressure, 3e6);
  EXPECT_TRUE(well.mud.relief_open);
  EXPECT_LT(well.flow, 0.059);
  well.run(0.0, 40.0, [&] { EXPECT_GE(well.mud.stand_pipe_pressure, 0.0); });
  EXPECT_FALSE(well.mud.relief_open);
  EXPECT_NEAR(well.mud.stand_pipe_pressure, 0.0, 1e4);
}

// Crank and rod: three pistons deliver 17 % below to 6 % above their mean (Miller, The Reciprocating Pump), thrice a stroke.
TEST(PressureWaves, comeFromThePistons)
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

TEST(PressureWaves, rippleAtStrokesTimesCylinders)
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
TEST(PressureWaves, carryPulsesUpThePipe)
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

TEST(PressureWaves, leakThroughAHole)
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

// What a plug holds back stands below it.
TEST(PressureWaves, standBelowAPlug)
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
