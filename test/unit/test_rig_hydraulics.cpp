// SPDX-License-Identifier: BSD-3-Clause
// The mud's two volumes: closed forms of filling and emptying, conservation, relief valve, gel, the motor's leakage, ECD.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/hydraulics/hydraulics.h"
#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/units.h"

namespace test_rig_hydraulics
{
using namespace drill_rig_sim;

namespace
{
constexpr double capacity = 5e-9;  // of 7 m3 at 1.4e9 Pa [m3/Pa]
constexpr double nominal = 0.06;

/// 14.4 MPa at 0.06 m3/s in the bore; no annulus but a way out.
HydraulicCircuit bore_alone(double exponent = 2.0)
{
  HydraulicCircuit c;
  c.bore = {capacity, 14.4e6, 0.0};
  c.nominal_flow = nominal;
  c.exponent = exponent;
  return c;
}

HydraulicCircuit whole()
{
  HydraulicCircuit c = bore_alone(1.7);
  c.annulus = {4e-8, 0.8e6, 0.0};
  return c;
}

/// A pump, as quick as its command, on a circuit.
struct Rig
{
  HydraulicCircuit circuit;
  MudPumpSpec pump;
  HydraulicState state;
  double flow = 0.0;
  double displaced = 0.0;  // by the string [m3/s]
  MudWays ways;
  double pumped = 0.0, returned = 0.0, most = 0.0;  // [m3, m3, Pa]

  explicit Rig(const HydraulicCircuit& c) : circuit(c) { pump.flow_ramp = 1e3; }
  void run(double seconds, double commanded, double step, double motor_pressure = 0.0)
  {
    for (long k = 0; k < std::lround(seconds / step); ++k)
    {
      advance_hydraulics(pump, circuit, commanded, motor_pressure, displaced, step, flow, state, ways);
      pumped += step * state.pump_flow;
      returned += step * state.return_flow;
      most = std::max(most, state.stand_pipe_pressure);
    }
  }
};
}  // namespace

// m = 1: a resistance R = 14.4e6/0.06 and a capacity: p = R Q (1 - exp(-t/(R C))), R C = 1.2 s.
TEST(Hydraulics, fillsLikeACapacityBehindAResistance)
{
  const double r = 14.4e6 / nominal, exact = r * 0.03 * (1.0 - std::exp(-1.0 / (r * capacity)));
  double error = 0.0;
  for (const double step : {0.02, 0.01, 0.005})
  {
    Rig rig(bore_alone(1.0));
    rig.run(1.0, 0.03, step);
    const double now = std::abs(rig.state.stand_pipe_pressure - exact) / exact;
    EXPECT_LT(now, 0.5 * step) << step;
    if (error > 0.0)
    {
      EXPECT_NEAR(now, 0.5 * error, 0.02 * error) << "first order";
    }
    error = now;
  }
}

// m = 2, pump off: C dp/dt = -Q with p = P (Q/Q_n)^2 makes Q fall at Q_n^2/(2 P C) = 0.025 m3/s2: from 0.045 it stands after 1.8
// s.
TEST(Hydraulics, emptiesInAFiniteTime)
{
  Rig rig(bore_alone());
  rig.run(60.0, 0.045, 0.01);
  EXPECT_NEAR(rig.state.stand_pipe_pressure, 8.1e6, 1.0);
  rig.run(1.0, 0.0, 0.001);
  EXPECT_NEAR(rig.flow, 0.02, 5e-5);
  rig.run(0.9, 0.0, 0.001);
  EXPECT_EQ(rig.flow, 0.0);
  EXPECT_LT(rig.state.stand_pipe_pressure, 1.0) << "mud that rests";
}

TEST(Hydraulics, settlesWhereTheLossesSay)
{
  Rig rig(whole());
  rig.run(200.0, 0.045, 0.01, 2e6);
  const double share = std::pow(0.75, 1.7);
  EXPECT_NEAR(rig.flow, 0.045, 1e-12);
  EXPECT_NEAR(rig.state.return_flow, 0.045, 1e-12);
  EXPECT_NEAR(rig.state.annulus_pressure, share * 0.8e6, 1e-3);
  EXPECT_NEAR(rig.state.stand_pipe_pressure, share * 15.2e6 + 2e6, 1e-3);
  const HydraulicState before = rig.state;
  rig.run(1.0, 0.045, 0.01, 2e6);
  EXPECT_DOUBLE_EQ(rig.state.stand_pipe_pressure, before.stand_pipe_pressure) << "it stands";
}

// A string that displaces a sixth of the nominal flow, up or down; with the pump's flow where it goes the same way, against it
// else.
TEST(Hydraulics, stringThatMovesSurgesAndSwabs)
{
  Rig rig(whole());
  const double alone = std::pow(1.0 / 6.0, 1.7) * 0.8e6;  // 38.0 kPa
  for (const double way : {1.0, -1.0})
  {
    rig.displaced = way * 0.01;
    rig.run(300.0, 0.0, 0.01);
    EXPECT_NEAR(rig.state.annulus_pressure, way * alone, 1e-3 * alone);
    EXPECT_NEAR(rig.state.return_flow, way * 0.01, 1e-5);
    EXPECT_EQ(rig.flow, 0.0) << "the float holds, and nothing is sucked through the bit";
    EXPECT_GE(rig.state.stand_pipe_pressure, 0.0);
  }
  rig.displaced = 0.01;
  rig.run(300.0, 0.03, 0.01);
  EXPECT_NEAR(rig.state.annulus_pressure, std::pow(4.0 / 6.0, 1.7) * 0.8e6, 10.0);
  EXPECT_NEAR(rig.state.stand_pipe_pressure, std::pow(0.5, 1.7) * 14.4e6 + rig.state.annulus_pressure, 100.0);
  rig.displaced = -0.01;
  rig.run(300.0, 0.03, 0.01);
  EXPECT_NEAR(rig.state.annulus_pressure, std::pow(2.0 / 6.0, 1.7) * 0.8e6, 10.0);
  rig.displaced = 0.0;
  rig.run(1000.0, 0.0, 0.01);
  EXPECT_LT(std::abs(rig.state.annulus_pressure), 1.0) << "and it goes when all rests";
}

TEST(Hydraulics, stringThatMovesBreaksTheGel)
{
  HydraulicCircuit c = whole();
  c.annulus.gel = 0.3e6;
  Rig rig(c);
  double least = 0.0;
  rig.displaced = -0.01;
  for (int k = 0; k < 3000; ++k)
  {
    rig.run(0.01, 0.0, 0.01);
    least = std::min(least, rig.state.annulus_pressure);
  }
  EXPECT_NEAR(least, -0.3e6, 0.06e6) << "it yields there";
  EXPECT_LT(rig.state.annulus_gel, 1e-6);
  EXPECT_NEAR(rig.state.annulus_pressure, -std::pow(1.0 / 6.0, 1.7) * 0.8e6, 100.0);
  rig.displaced = 1e-6;  // a string that creeps: mud that takes 5000 s for the volume that breaks it
  rig.run(600.0, 0.0, 0.1);
  EXPECT_GT(rig.state.annulus_gel, 0.9) << "it stiffens";
}

TEST(Hydraulics, losesNoMudAndIsStableAtAnyStep)
{
  for (const double step : {1e-3, 0.01, 0.1, 1.0, 30.0})
  {
    Rig rig(whole());
    for (const double commanded : {0.06, 0.001, 0.0, 0.03, 0.0})
    {
      rig.run(60.0, commanded, step, 3e6);
      const double held = capacity * rig.state.stand_pipe_pressure + 4e-8 * rig.state.annulus_pressure;
      EXPECT_NEAR(rig.pumped, rig.returned + held, 1e-9) << step << " " << commanded;
      EXPECT_GE(rig.flow, 0.0);
      EXPECT_GE(rig.state.annulus_pressure, 0.0);
    }
    EXPECT_LT(rig.most, 15.2e6 + 3e6 + 1.0) << step;
    EXPECT_NEAR(rig.state.strokes * MudPumpSpec().stroke_volume, rig.pumped, 1e-9) << step << ": they are counted";
  }
}

// The annulus alone, moved to and fro by the string: what it lets out is what was displaced, less what it holds.
TEST(Hydraulics, losesNoMudAsTheStringMoves)
{
  for (const double step : {1e-3, 0.01, 0.1, 1.0, 30.0})
  {
    Rig rig(whole());
    double displaced = 0.0;
    for (const double flow : {0.02, -0.03, 1e-5, -1e-5, 0.05})
    {
      rig.displaced = flow;
      rig.run(60.0, 0.0, step);
      displaced += 60.0 * flow;
      EXPECT_NEAR(displaced, rig.returned + 4e-8 * rig.state.annulus_pressure + capacity * rig.state.stand_pipe_pressure, 1e-9)
          << step << " " << flow;
      EXPECT_LT(std::abs(rig.state.annulus_pressure), 0.8e6) << step;
    }
  }
}

// At 6 MPa and 1 MPa over the motor the losses may be 5 MPa: 0.06 sqrt(5/14.4).
TEST(Hydraulics, reliefValveHoldsItsPressure)
{
  Rig rig(bore_alone());
  rig.pump.relief_pressure = 6e6;
  rig.run(0.2, 0.045, 0.01, 1e6);
  EXPECT_FALSE(rig.state.relief_open) << "on its way";
  rig.run(20.0, 0.045, 0.01, 1e6);
  EXPECT_TRUE(rig.state.relief_open);
  EXPECT_EQ(rig.state.stand_pipe_pressure, 6e6);
  EXPECT_EQ(rig.most, 6e6);
  EXPECT_NEAR(rig.flow, 0.06 * std::sqrt(5.0 / 14.4), 1e-12);
  EXPECT_EQ(rig.state.pump_flow, 0.045) << "the pump does not feel it";
  rig.run(20.0, 0.045, 0.01, 7e6);
  EXPECT_NEAR(rig.flow, mud_motor_leakage * 6.0 / 7.0, 1e-5) << "a stalled motor needs more: it leaks";
  rig.run(20.0, 0.02, 0.01, 0.0);
  EXPECT_FALSE(rig.state.relief_open);
}

// 1.2 MPa of gel in the bore, 0.3 MPa in the annulus: nothing moves below, and more than the losses is needed to start.
TEST(Hydraulics, gelIsBrokenBeforeMudFlows)
{
  HydraulicCircuit c = whole();
  c.bore.gel = 1.2e6;
  c.annulus.gel = 0.3e6;
  Rig rig(c);
  const double slow = 1e-4;  // m3/s; 1.2 MPa are there after C p/Q = 60 s
  rig.run(55.0, slow, 0.01);
  EXPECT_EQ(rig.flow, 0.0);
  EXPECT_NEAR(rig.state.stand_pipe_pressure, 55.0 * slow / capacity, 1.0);
  rig.run(10.0, slow, 0.01);
  EXPECT_GT(rig.flow, 0.0);
  EXPECT_NEAR(rig.most, 1.2e6, 0.05e6) << "it yields there";
  rig.run(600.0, 0.045, 0.01);
  EXPECT_LT(std::max(rig.state.bore_gel, rig.state.annulus_gel), 1e-6) << "broken";
  EXPECT_NEAR(rig.state.stand_pipe_pressure, std::pow(0.75, 1.7) * 15.2e6, 1.0);
  rig.run(10.0, 0.0, 0.01);
  ASSERT_EQ(rig.flow, 0.0);
  const double now = rig.state.bore_gel;
  rig.run(600.0, 0.0, 0.1);
  EXPECT_NEAR(1.0 - rig.state.bore_gel, (1.0 - now) * std::exp(-3.0), 1e-6) << "95 % in ten minutes";
}

// 0.9 MPa of gel in the annulus take 36 l, with the gel of the bore, 0.6 MPa, long broken by then: the annulus's is what the pump
// meets.
TEST(Hydraulics, gelOfTheAnnulusBearsAfterThatOfTheBoreIsBroken)
{
  HydraulicCircuit c = whole();
  c.bore.gel = 0.6e6;
  c.annulus.gel = 0.9e6;
  Rig rig(c);
  double most = 0.0;
  for (int k = 0; k < 6000; ++k)
  {
    rig.run(0.01, 2e-3, 0.01);
    most = std::max(most, rig.state.annulus_pressure);
    EXPECT_TRUE(most > 0.85e6 || rig.state.return_flow == 0.0) << k;
  }
  EXPECT_NEAR(most, 0.9e6, 0.05e6);
  EXPECT_GT(rig.most, 0.9e6) << "and so does the stand pipe";
  EXPECT_LT(rig.state.annulus_gel, 1e-6);
}

// The bit still loads the motor when the pump stops: what is left behind leaks away through it.
TEST(Hydraulics, aLoadedMotorLeaks)
{
  Rig rig(bore_alone());
  rig.run(30.0, 0.03, 0.01, 4e6);
  EXPECT_NEAR(rig.state.stand_pipe_pressure, 3.6e6 + 4e6, 1.0);
  rig.run(10.0, 0.0, 0.01, 4e6);
  EXPECT_LT(rig.flow, mud_motor_leakage);
  EXPECT_GT(rig.state.stand_pipe_pressure, 1e5);
  rig.run(1000.0, 0.0, 0.01, 4e6);
  EXPECT_LT(rig.state.stand_pipe_pressure, 1.0);
}

TEST(Hydraulics, ecdIsTheMudThatWouldPushAsHard)
{
  EXPECT_NEAR(equivalent_circulating_density(1200.0, 1e6, 1000.0), 1200.0 + 1e6 / 9806.65, 1e-9);
  EXPECT_EQ(equivalent_circulating_density(1200.0, 1e6, 0.5), 1200.0);
}

// Packed cuttings hold their pressure back while mud moves, on top of the losses, however much it is.
TEST(MudWays, aPlugAddsItsPressureToTheAnnulus)
{
  for (const double q : {0.02, 0.05})
  {
    Rig rig(whole()), plugged(whole());
    plugged.ways.plug = 3e6;
    for (Rig* one : {&rig, &plugged}) one->run(600.0, q, 0.05);
    EXPECT_NEAR(plugged.state.annulus_pressure - rig.state.annulus_pressure, 3e6, 10.0);
    EXPECT_NEAR(plugged.state.stand_pipe_pressure - rig.state.stand_pipe_pressure, 3e6, 10.0);
    EXPECT_NEAR(plugged.state.return_flow, q, 1e-9);
    plugged.run(600.0, 0.0, 0.05);
    EXPECT_NEAR(plugged.state.annulus_pressure, 0.0, 10.0) << "it seeps away with the pump off";
    plugged.displaced = -0.01;
    plugged.run(600.0, 0.0, 0.05);
    EXPECT_NEAR(plugged.state.annulus_pressure, -0.8e6 * std::pow(0.01 / nominal, 1.7), 10.0) << "no swab but the losses'";
  }
}

// What leaks passes the bit by: it makes no pressure in the bore, but comes back through the annulus; nothing is lost.
TEST(MudWays, aLeakPassesTheBitBy)
{
  Rig rig(whole());
  rig.ways.leak = 0.01;
  rig.run(600.0, 0.04, 0.05);
  EXPECT_NEAR(rig.flow, 0.03, 1e-9);
  EXPECT_NEAR(rig.state.return_flow, 0.04, 1e-9);
  const double annulus = 0.8e6 * std::pow(0.04 / nominal, 1.7);
  EXPECT_NEAR(rig.state.annulus_pressure, annulus, 1.0);
  EXPECT_NEAR(rig.state.stand_pipe_pressure, annulus + 14.4e6 * std::pow(0.03 / nominal, 1.7), 10.0);
  const double held = capacity * rig.state.stand_pipe_pressure + 4e-8 * rig.state.annulus_pressure;
  EXPECT_NEAR(rig.pumped - rig.returned, held, 1e-6 * rig.pumped);
}

TEST(MudWays, noMoreLeaksThanThereIs)
{
  Rig rig(whole());
  rig.ways.leak = 10.0;
  rig.run(60.0, 0.02, 0.05);
  EXPECT_EQ(rig.flow, 0.0);
  EXPECT_NEAR(rig.state.stand_pipe_pressure, 0.0, 1.0);
  EXPECT_NEAR(rig.state.return_flow, 0.02, 1e-6);
}

// 1 cm2 under 10 MPa of mud of 1200 kg/m3: 129.1 m/s, contracted to 0.611.
TEST(MudWays, anOrificeIsTorricellis)
{
  EXPECT_NEAR(orifice_flow(1e-4, 10e6, 1200.0), 0.611 * 1e-4 * 129.1, 1e-5);
  EXPECT_EQ(orifice_flow(1e-4, -1.0, 1200.0), 0.0);
  EXPECT_EQ(orifice_flow(1e-4, 10e6, 0.0), 0.0) << "air has no density here";
}
}  // namespace test_rig_hydraulics
