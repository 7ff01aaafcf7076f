// SPDX-License-Identifier: BSD-3-Clause
// Instruments by themselves: clocks that are shifted, samples that are held, queues that are full, angles that go round.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/instruments/instruments.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"
#include "test_scenes.h"

namespace test_sim_gauges
{
using namespace drill_rig_sim;

namespace
{
constexpr double flow = 0.03;  // [m3/s]

MwdSpec prompt_surveys()
{
  MwdSpec spec;
  spec.period = 1.0;
  spec.latency = 0.0;
  return spec;
}

ToolfaceSpec prompt_toolface()
{
  ToolfaceSpec spec;
  spec.period = 1.0;
  spec.latency = 0.0;
  return spec;
}

SensorView view_along(double inclination, double azimuth)
{
  SensorView view;
  view.axis = tangent_from(inclination, azimuth);
  view.scribe = high_side(view.axis);
  return view;
}
}  // namespace

// Read more often than the interval it keeps the first of each; shown is the newest that is old enough, until then the oldest.
TEST(Sensor, holdsASampleForItsInterval)
{
  SensorSpec spec;
  spec.delay = 0.5;
  Sensor sensor(spec, 0.25);
  for (int k = 0; k < 100; ++k)
  {
    const double wanted = k < 8 ? 0.0 : std::floor(0.25 * (k - 8)) * 4.0;
    EXPECT_EQ(sensor.read(k, 0.0625 * k), wanted) << k;
  }
}

// A 6000th of 9.6 s is 1.6 ms: of readings 0.5 ms apart every fourth is kept.
TEST(Sensor, aLongDelayIsHeldInCoarserSteps)
{
  SensorSpec spec;
  spec.delay = 9.6;
  Sensor sensor(spec, 0.0005);
  for (int k = 0; k < 24000; ++k) ASSERT_EQ(sensor.read(k, 0.0005 * k), k < 19200 ? 0.0 : 4.0 * ((k - 19200) / 4)) << k;
}

// No more than 32 readings wait; one that finds no room is lost. Those that waited come one by one, in their order.
TEST(Mwd, aFullQueueLosesWhatIsMeasured)
{
  MwdSpec spec = prompt_surveys();
  ToolfaceSpec toolface = prompt_toolface();
  spec.latency = toolface.latency = 100.0;
  Mwd mwd(spec, toolface);
  MwdReading survey;
  ToolfaceReading face;
  for (int k = 0; k < 240; ++k)
  {
    mwd.update(k, flow, SensorView(), survey, face);
    // sequence n is measured at n - 1 s; from 100 s on one leaves a second, after that second's measurement found no room
    const std::uint64_t wanted = k < 100 ? 0 : k < 132 ? k - 99 : k < 201 ? 32 : k < 233 ? k - 99 : 133;
    ASSERT_EQ(survey.sequence, wanted) << k;
    ASSERT_EQ(face.sequence, wanted) << k;
  }
}

TEST(Mwd, noisyAnglesStayInTheirRanges)
{
  MwdSpec spec = prompt_surveys();
  spec.noise = 0.01;
  Mwd mwd(spec, prompt_toolface(), NoiseSource{3});
  int below_north = 0, above_north = 0;
  for (int k = 0; k < 200; ++k)
  {
    MwdReading survey;
    ToolfaceReading face;
    mwd.update(k, flow, k % 2 ? view_along(0.0, 0.0) : view_along(1.0, 0.0), survey, face);
    EXPECT_GE(survey.inclination, 0.0);
    EXPECT_GE(survey.azimuth, 0.0);
    EXPECT_LT(survey.azimuth, 2.0 * pi);
    EXPECT_NEAR(std::remainder(survey.azimuth, 2.0 * pi), 0.0, 0.06);
    ++(survey.azimuth > pi ? below_north : above_north);
  }
  EXPECT_GT(below_north, 50);
  EXPECT_GT(above_north, 50);
}

// 3 rad of offset and 1 rad: 4 rad to the right are 2.28 rad to the left.
TEST(Mwd, toolfaceGoesRoundAtHalfATurn)
{
  MwdSpec spec = prompt_surveys();
  spec.scribe_offset = 3.0;
  Mwd mwd(spec, prompt_toolface());
  SensorView view = view_along(1.0, 2.0);
  view.scribe = std::cos(1.0) * view.scribe + std::sin(1.0) * view.axis.cross(view.scribe);
  MwdReading survey;
  ToolfaceReading face;
  mwd.update(0.0, flow, view, survey, face);
  EXPECT_NEAR(face.toolface, 4.0 - 2.0 * pi, 1e-12);
}

// Between 4 and 6 degrees it stays with the reference that it has; it starts with north.
TEST(Mwd, remembersItsReference)
{
  Mwd mwd(prompt_surveys(), prompt_toolface());
  const double inclinations[] = {5.0, 5.9, 6.1, 5.0, 4.1, 3.9, 5.0};
  const bool magnetic[] = {true, true, false, false, false, true, true};
  for (int k = 0; k < 7; ++k)
  {
    MwdReading survey;
    ToolfaceReading face;
    mwd.update(k, flow, view_along(inclinations[k] * degree, 1.0), survey, face);
    EXPECT_EQ(magnetic[k], face.magnetic) << inclinations[k];
  }
}

// The block sinks by 5 mm/s from the start: so fast the gauges see the hole grow.
TEST(Instruments, ropIsThatOfTheBlock)
{
  Truth truth;
  truth.bit_depth = truth.hole_depth = 100.0;
  truth.block_height = 20.0;
  Instruments instruments(drilling_scene(), truth, 1);
  Readings readings;
  for (int k = 0; k <= 30; ++k)
  {
    truth.time = k;
    truth.block_height = 20.0 - 0.005 * k;
    instruments.read(truth, SensorView(), readings);
    EXPECT_NEAR(readings.rop, k > 0 ? 0.005 : 0.0, 1e-14) << k;
    EXPECT_NEAR(readings.hole_depth, 100.0 + 0.005 * k, 1e-12) << k;
  }
}
}  // namespace test_sim_gauges
