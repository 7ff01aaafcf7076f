// SPDX-License-Identifier: BSD-3-Clause
// Surface sensors and MWD: bias, noise, delay, filter, latency, resolution, and what a snapshot's clock shift does to them.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/instruments/instruments.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"

namespace test_sim_instruments
{
using namespace drill_rig_sim;

namespace
{
SensorView tilted_view(double inclination, double azimuth, double toolface)
{
  SensorView view;
  view.md = 100.0;
  view.axis = tangent_from(inclination, azimuth);
  const Eigen::Vector3d up = high_side(view.axis);
  view.scribe = up * std::cos(toolface) + view.axis.cross(up) * std::sin(toolface);
  return view;
}
}  // namespace

// The first numbers of splitmix64 from 1234567, as its users publish them.
TEST(NoiseSource, isSplitmix64)
{
  NoiseSource noise{1234567};
  for (const std::uint64_t published : {6457827717110365317u, 3203168211198807973u, 9817491932198370423u})
    EXPECT_NEAR(noise.uniform(), published * 0x1p-64, 1e-15);
}

// 10^5 numbers: mean within 4/sqrt(n), variance within 4 sqrt(2/n).
TEST(NoiseSource, isStandardNormalAndRepeats)
{
  NoiseSource noise{5}, again{5};
  const int n = 100000;
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < n; ++k)
  {
    const double x = noise.normal();
    ASSERT_EQ(x, again.normal());
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / n, 0.0, 4.0 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1.0, 4.0 * std::sqrt(2.0 / n));
}

TEST(Rounded, isWholeStepsOrTheValueItself)
{
  EXPECT_DOUBLE_EQ(rounded(12.34, 0.1), 12.3);
  EXPECT_DOUBLE_EQ(rounded(-12.36, 0.1), -12.4);
  EXPECT_DOUBLE_EQ(rounded(0.04, 0.1), 0.0);
  EXPECT_EQ(rounded(12.34, 0.0), 12.34);
  EXPECT_EQ(rounded(2.2e5, 5e-324), 2.2e5) << "more steps than there are numbers";
}

TEST(Sensor, idealOneTellsTheTruth)
{
  Sensor sensor{SensorSpec(), 0.01};
  for (int k = 0; k < 10; ++k) EXPECT_EQ(sensor.read(k * k, 0.01 * k), k * k);
}

TEST(Sensor, delayShiftsTheSignalAndBiasAddsToIt)
{
  SensorSpec spec;
  spec.delay = 0.05;
  spec.bias = 7.0;
  Sensor sensor(spec, 0.01);
  for (int k = 0; k < 50; ++k) EXPECT_NEAR(sensor.read(k, 0.01 * k), 7.0 + std::max(0, k - 5), 1e-12) << k;
}

// First order, exact for a held input: after one time constant 1 - 1/e of the step.
TEST(Sensor, filterAnswersAStepExponentially)
{
  SensorSpec spec;
  spec.filter_time = 0.5;
  Sensor sensor(spec, 0.01);
  sensor.read(0.0, 0.0);
  double reading = 0.0;
  for (int k = 1; k <= 50; ++k) reading = sensor.read(1.0, 0.01 * k);
  EXPECT_NEAR(reading, 1.0 - std::exp(-1.0), 1e-12);
}

TEST(Sensor, noiseHasItsDeviation)
{
  SensorSpec spec;
  spec.noise = 3.0;
  Sensor sensor(spec, 0.01, NoiseSource::of(1, 0));
  double squares = 0.0;
  const int n = 20000;
  for (int k = 0; k < n; ++k) squares += std::pow(sensor.read(10.0, 0.01 * k) - 10.0, 2);
  EXPECT_NEAR(std::sqrt(squares / n), 3.0, 3.0 * 4.0 / std::sqrt(2.0 * n));
}

TEST(Mwd, surveysComeByPeriodLateAndRounded)
{
  MwdSpec spec;
  spec.period = 10.0;
  spec.latency = 4.0;
  spec.inclination_resolution = 0.1 * degree;
  Mwd mwd(spec, ToolfaceSpec());
  MwdReading survey;
  ToolfaceReading toolface;
  const SensorView view = tilted_view(12.34 * degree, 300.0 * degree, 0.0);
  for (double t = 0.0; t < 3.9; t += 0.1) mwd.update(t, 0.03, view, survey, toolface);
  EXPECT_EQ(survey.sequence, 0u) << "still on its way up";
  for (double t = 3.9; t < 13.9; t += 0.1) mwd.update(t, 0.03, view, survey, toolface);
  EXPECT_EQ(survey.sequence, 1u);
  EXPECT_NEAR(survey.time, 0.0, 1e-9);
  EXPECT_NEAR(survey.inclination, 12.3 * degree, 1e-9);
  EXPECT_NEAR(survey.azimuth, 300.0 * degree, 1e-9);
  EXPECT_EQ(survey.md, 100.0);
  for (double t = 13.9; t < 14.5; t += 0.1) mwd.update(t, 0.03, view, survey, toolface);
  EXPECT_EQ(survey.sequence, 2u);
}

// A simulator's time is a sum of steps, and 10 s of them are 9.99999...: the reading is due all the same, not a frame later.
TEST(Mwd, isPunctualWhateverTheSumsOfSteps)
{
  Mwd mwd(MwdSpec{10.0, 0.0}, ToolfaceSpec{0.3, 0.0});
  MwdReading survey;
  ToolfaceReading toolface;
  double time = 0.0;
  for (int k = 0; k <= 10000; ++k, time += 0.01)
  {
    mwd.update(time, 0.03, tilted_view(0.2, 1.0, 0.5), survey, toolface);
    ASSERT_EQ(survey.sequence, static_cast<std::uint64_t>(k / 1000 + 1)) << time;
    ASSERT_EQ(toolface.sequence, static_cast<std::uint64_t>(k / 30 + 1)) << time;
  }
}

// A trickle of a tenth of a litre a second carries no pulses.
TEST(Mwd, isSilentWithoutFlow)
{
  for (const double flow : {0.0, 1e-4, 1.01e-4})
  {
    Mwd mwd{MwdSpec(), ToolfaceSpec()};
    MwdReading survey;
    ToolfaceReading toolface;
    for (double t = 0.0; t < 100.0; t += 0.5) mwd.update(t, flow, SensorView(), survey, toolface);
    EXPECT_EQ(survey.sequence > 0, flow > 1e-4) << flow;
    EXPECT_EQ(toolface.sequence > 0, flow > 1e-4) << flow;
  }
}

// 10^4 readings: deviations within 5 sqrt(1/2n), means within 5/sqrt(n) of the deviation, and no two alike.
TEST(Mwd, noiseIsInEachAngle)
{
  MwdSpec spec;
  spec.noise = 0.01;
  spec.period = 1.0;
  spec.latency = 0.0;
  ToolfaceSpec fast;
  fast.period = 1.0;
  fast.latency = 0.0;
  Mwd mwd(spec, fast, NoiseSource{3});
  const int n = 10000;
  Eigen::Array3d sum = Eigen::Array3d::Zero(), squares = sum, products = sum;
  for (int k = 0; k < n; ++k)
  {
    MwdReading survey;
    ToolfaceReading toolface;
    mwd.update(k, 0.03, tilted_view(1.0, 2.0, 0.5), survey, toolface);
    const Eigen::Array3d error(survey.inclination - 1.0, survey.azimuth - 2.0, toolface.toolface - 0.5);
    sum += error;
    squares += error.square();
    products += error * Eigen::Array3d(error[1], error[2], error[0]);
  }
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(sum[i] / n, 0.0, 0.01 * 5.0 / std::sqrt(n)) << i;
    EXPECT_NEAR(std::sqrt(squares[i] / n), 0.01, 0.01 * 5.0 * std::sqrt(0.5 / n)) << i;
    EXPECT_NEAR(products[i] / n, 0.0, 1e-4 * 5.0 / std::sqrt(n)) << i;
  }
}

// Pulses in the mud: what was measured before the pumps stopped comes when they run again.
TEST(Mwd, whatIsOnItsWayWaitsForFlow)
{
  Mwd mwd(MwdSpec{10.0, 4.0}, ToolfaceSpec{10.0, 4.0});
  MwdReading survey;
  ToolfaceReading toolface;
  for (double t = 0.0; t < 30.0; t += 0.5)
  {
    mwd.update(t, t < 2.0 || t >= 20.0 ? 0.03 : 0.0, SensorView(), survey, toolface);
    EXPECT_EQ(t < 20.0 ? 0u : t < 24.0 ? 1u : 2u, survey.sequence) << t;
    EXPECT_EQ(survey.sequence, toolface.sequence) << t;
  }
}

// Period 0: one survey each time the pumps come on.
TEST(Mwd, surveysAfterAPumpCycle)
{
  MwdSpec spec;
  spec.period = 0.0;
  spec.latency = 1.0;
  Mwd mwd(spec, ToolfaceSpec());
  MwdReading survey;
  ToolfaceReading toolface;
  for (int k = 0; k < 300; ++k)
  {
    const bool pumping = (k / 100) != 1;  // on, off, on
    mwd.update(0.1 * k, pumping ? 0.03 : 0.0, SensorView(), survey, toolface);
    EXPECT_LE(survey.sequence, k < 200 ? 1u : 2u);
  }
  EXPECT_EQ(survey.sequence, 2u);
  EXPECT_NEAR(survey.time, 20.0, 1e-9);
}

TEST(Mwd, toolfaceIsFromTheHighSideOrFromNorth)
{
  MwdReading survey;
  ToolfaceSpec fast;
  fast.period = 1.0;
  fast.latency = 0.0;
  MwdSpec spec;
  spec.scribe_offset = 0.25;
  ToolfaceReading steep, flat;
  Mwd first(spec, fast), second(spec, fast);
  first.update(0.0, 0.03, tilted_view(40.0 * degree, 1.0, 0.5), survey, steep);
  EXPECT_EQ(steep.sequence, 1u);
  EXPECT_FALSE(steep.magnetic);
  EXPECT_NEAR(steep.toolface, 0.75, 1e-12);
  SensorView vertical;  // scribe to the north
  second.update(0.0, 0.03, vertical, survey, flat);
  EXPECT_TRUE(flat.magnetic);
  EXPECT_NEAR(flat.toolface, 0.25, 1e-12);
}
}  // namespace test_sim_instruments
