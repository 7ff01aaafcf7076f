// SPDX-License-Identifier: BSD-3-Clause
// Tables of losses, and the two volumes with them: published surge, steady flow, no mud lost, yield stress and gel, a string that
// moves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/hydraulics/hydraulics.h"
#include "drill_rig_sim/math/units.h"

namespace test_hydraulics_section_losses
{
using namespace drill_rig_sim;

namespace
{
constexpr double psi = 6894.757, foot = 0.3048, inch = 0.0254, ppg = 119.8264;
constexpr double largest = 0.06;
const Rheology yielding = {3.0, 0.3, 0.7};
const PassageLength pipe_bore = {{0.1086, 0.0, 0.0}, 3000.0}, pipe_annulus = {{0.2159, 0.127, 0.0}, 2800.0},
                    collar_annulus = {{0.2159, 0.17, 0.0}, 200.0};

SectionLosses losses_of(const Rheology& mud)
{
  return section_losses(mud, 1300.0, {{{{0.08, 0.0, 0.0}, 40.0}}, {pipe_bore}, {pipe_annulus, collar_annulus}, 3e-4}, largest);
}

double loss_of(const Rheology& mud, const PassageLength& section, double flow)
{
  return section.length * pressure_gradient(mud, 1300.0, section.passage, flow / section.passage.area());
}

/// A pump, as quick as its command, on 30 m3 and 90 m3.
struct Rig
{
  HydraulicCircuit circuit;
  MudPumpSpec pump;
  HydraulicState state;
  double flow = 0.0, displaced = 0.0;

  explicit Rig(const Rheology& mud)
  {
    circuit.law = losses_of(mud);
    circuit.nominal_flow = largest;
    circuit.bore.capacity = 30.0 / 1.4e9;
    circuit.annulus.capacity = 90.0 / 1.4e9;
    pump.flow_ramp = 1e3;
    state.bore_gel = state.annulus_gel = 0.0;
  }
  void run(double seconds, double commanded, double step = 0.01)
  {
    for (long k = 0; k < std::lround(seconds / step); ++k)
      advance_hydraulics(pump, circuit, commanded, 0.0, displaced, step, flow, state);
  }
};
}  // namespace

TEST(LossTable, isWithinTwoThousandthsOfTheLaw)
{
  for (const Rheology& mud : {Rheology{0.0, 0.02, 1.0}, Rheology{8.0, 0.02, 1.0}, yielding})
  {
    const auto law = [&](double flow) { return loss_of(mud, pipe_bore, flow); };
    const LossTable table(largest, law);
    for (double flow = 0.01 * largest; flow <= largest; flow *= 1.013)
    {
      EXPECT_NEAR(table.at(flow).loss, law(flow), 2e-3 * law(flow)) << flow;
      EXPECT_EQ(table.at(-flow).loss, -table.at(flow).loss);
      const double h = 1e-6 * flow, slope = (table.at(flow + h).loss - table.at(flow - h).loss) / (2.0 * h);
      EXPECT_NEAR(table.at(flow).slope, slope, 1e-4 * slope + 1.0) << flow;
    }
    EXPECT_EQ(table.at(0.0).loss, 0.0);
    EXPECT_GT(table.at(1.2 * largest).loss, law(largest));
  }
}

TEST(LossTable, growsEverywhere)
{
  const LossTable table(largest, [&](double flow) { return loss_of({8.0, 0.02, 1.0}, pipe_bore, flow); });
  double before = -1.0;
  for (double flow = 0.0; flow < 1.5 * largest; flow += 1e-5)
  {
    ASSERT_GT(table.at(flow).loss, before) << flow;
    before = table.at(flow).loss;
  }
}

// Pumped for long enough, each volume has the losses behind it.
TEST(SectionLosses, steadyFlowHasTheLawsLosses)
{
  for (const double q : {0.01, 0.03, 0.045})
  {
    Rig rig(yielding);
    rig.run(600.0, q);
    const double annulus = loss_of(yielding, pipe_annulus, q) + loss_of(yielding, collar_annulus, q);
    const double inner =
        loss_of(yielding, pipe_bore, q) + loss_of(yielding, {{0.08, 0.0, 0.0}, 40.0}, q) + nozzle_loss(1300.0, q, 3e-4);
    EXPECT_NEAR(rig.flow, q, 1e-6 * q);
    EXPECT_NEAR(rig.state.return_flow, q, 1e-5 * q);
    EXPECT_NEAR(rig.state.annulus_pressure, annulus, 2e-3 * annulus) << q;
    EXPECT_NEAR(rig.state.stand_pipe_pressure, annulus + inner, 2e-3 * (annulus + inner)) << q;
  }
}

// What is pumped comes back, is left in the volumes, or has made room for none: no mud is lost at any step.
TEST(SectionLosses, noMudIsLost)
{
  for (const double step : {0.001, 0.02, 0.3})
  {
    Rig rig(yielding);
    double pumped = 0.0, returned = 0.0;
    for (int k = 0; k < 400; ++k)
    {
      rig.displaced = 0.004 * std::sin(0.05 * k);
      advance_hydraulics(rig.pump, rig.circuit, k < 200 ? 0.03 : 0.0, 0.0, rig.displaced, step, rig.flow, rig.state);
      pumped += step * (rig.state.pump_flow + rig.displaced);
      returned += step * rig.state.return_flow;
    }
    const double stored =
        rig.circuit.bore.capacity * rig.state.stand_pipe_pressure + rig.circuit.annulus.capacity * rig.state.annulus_pressure;
    EXPECT_NEAR(pumped, returned + stored, 1e-9 * pumped + 1e-12) << step;
  }
}

TEST(SectionLosses, resultHardlyDependsOnTheStep)
{
  double pressure[2] = {};
  for (int k = 0; k < 2; ++k)
  {
    Rig rig(yielding);
    rig.run(20.0, 0.04, k == 0 ? 0.02 : 0.001);
    pressure[k] = rig.state.stand_pipe_pressure;
  }
  EXPECT_NEAR(pressure[0], pressure[1], 0.005 * pressure[1]);
}

// Below its yield stress the mud stands: the stand pipe keeps what the bore's walls and the annulus hold.
TEST(SectionLosses, yieldStressHoldsThePressureOfAStoppedPump)
{
  Rig rig(yielding);
  rig.run(60.0, 0.03);
  rig.run(600.0, 0.0);
  EXPECT_LT(rig.flow, 4e-6);
  const double bore = 4.0 * 3.0 * 3000.0 / 0.1086 + 4.0 * 3.0 * 40.0 / 0.08;
  EXPECT_NEAR(rig.state.stand_pipe_pressure - rig.state.annulus_pressure, bore, 0.1 * bore);
  Rig newtonian({0.0, 0.02, 1.0});
  newtonian.run(60.0, 0.03);
  newtonian.run(600.0, 0.0);
  EXPECT_LT(newtonian.state.stand_pipe_pressure, 2e3);
}

// Run in and pulled out: surge and swab are opposite, each section with its own speed (Q + A_o v)/A + K v.
TEST(SectionLosses, aStringThatMovesSurgesAndSwabs)
{
  const double v = 0.5;
  Rig in(yielding), out(yielding);
  const double area = in.circuit.law.displaced_area;
  in.displaced = area * v;
  out.displaced = -area * v;
  in.run(900.0, 0.0);
  out.run(900.0, 0.0);
  double expected = 0.0;
  for (const PassageLength& section : {pipe_annulus, collar_annulus})
  {
    const double outside = 0.25 * pi * section.passage.inner * section.passage.inner, annulus = section.passage.area();
    const double speed = v * (outside / annulus + clinging(section.passage.inner / section.passage.outer, 0.0));
    ASSERT_LT(speed, critical_speed(yielding, 1300.0, section.passage));
    expected += section.length * pressure_gradient(yielding, 1300.0, section.passage, speed);
  }
  EXPECT_NEAR(in.state.annulus_pressure, expected, 0.005 * expected);
  EXPECT_NEAR(out.state.annulus_pressure, -expected, 0.005 * expected);
  EXPECT_NEAR(in.state.return_flow, area * v, 1e-4 * area * v);
}

// Lapeyrouse's plugged pipe (test_hydraulics_flow_losses) through the circuit: 516 psi with his K of 0.45; 497 with Burkhardt's
// laminar 0.407.
TEST(SectionLosses, plungedPipeSurgesAsLapeyrousesDoes)
{
  const Rheology mud = {0.0, 0.522 * 0.4788026, 0.8069};
  HydraulicCircuit circuit;
  const Passage annulus = {7.875 * inch, 4.5 * inch, 0.0};
  circuit.law = section_losses(mud, 15.0 * ppg,
                               {{}, {{{3.82 * inch, 0.0, 0.0}, 14300.0 * foot}}, {{annulus, 14300.0 * foot}}, 3e-4}, largest);
  const double speed = 270.0 * foot / 60.0, ratio = 4.5 / 7.875;
  const double by_lapeyrouse = std::pow((0.45 + 0.485) / (clinging(ratio, 0.0) + 0.485), 0.8069);
  const double surge = circuit.law.outer(0.0, circuit.law.displaced_area * speed).loss / psi;
  EXPECT_NEAR(surge, 497.0, 3.0);
  EXPECT_NEAR(surge * by_lapeyrouse, 516.0, 3.0);
}

// A gel that is stronger than the yield stress holds the bore's mud back once; then the pressure is what it would be without.
TEST(SectionLosses, gelHoldsBeyondTheYieldStress)
{
  Rig rig(yielding), without(yielding);
  rig.circuit.bore.gel = 3e6;
  rig.state.bore_gel = 1.0;
  double most = 0.0;
  for (int k = 0; k < 60; ++k)
  {
    rig.run(1.0, 0.003);
    without.run(1.0, 0.003);
    most = std::max(most, rig.state.stand_pipe_pressure - without.state.stand_pipe_pressure);
  }
  EXPECT_GT(most, 1e6);
  EXPECT_NEAR(rig.state.stand_pipe_pressure, without.state.stand_pipe_pressure, 0.02 * without.state.stand_pipe_pressure);
}

// What the pump does, p Q, is lost in lines, bore, bit and annulus or stands as compressed mud, C p^2/2, while it starts, runs
// and stops.
TEST(SectionLosses, thePumpsWorkIsLossesAndCompressedMud)
{
  constexpr double step = 1e-3;
  Rig rig(yielding);
  rig.pump.flow_ramp = 3e-3;
  double work = 0.0, lost = 0.0, most_stored = 0.0;
  for (const double commanded : {0.03, 0.045, 0.0})
    for (int k = 0; k < 60000; ++k)
    {
      rig.run(step, commanded, step);
      const HydraulicState& s = rig.state;
      work += s.stand_pipe_pressure * s.pump_flow * step;
      lost += rig.flow * rig.circuit.law.inner(rig.flow).loss * step;
      lost += s.return_flow * rig.circuit.law.outer(s.return_flow, 0.0).loss * step;
      const double p = s.stand_pipe_pressure, a = s.annulus_pressure;
      const double stored = 0.5 * (rig.circuit.bore.capacity * p * p + rig.circuit.annulus.capacity * a * a);
      most_stored = std::max(most_stored, stored);
      ASSERT_NEAR(work, lost + stored, 2e-4 * work + 10.0) << commanded << ' ' << k;
    }
  EXPECT_GT(most_stored, 5e5);  // [J], much more than the bound
}
}  // namespace test_hydraulics_section_losses
