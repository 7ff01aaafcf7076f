// SPDX-License-Identifier: BSD-3-Clause
// Means of a run's samples: each of its own field, directions across north, the drilling alone, its last quarter.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_averages.h"
#include "drill_rig_sim/math/units.h"
#include "numbered_frame.h"

namespace drill_rig_sim::test_tools_averages
{
namespace
{
Truth sample(double base)
{
  Truth m;
  number_signals(m, base);
  m.bit_position = {base + 21, base + 22, base + 23};
  m.wob = base + 31;
  m.bit_torque = base + 32;
  m.bit_speed = base + 33;
  return m;
}

Truth towards(double inclination, double azimuth)
{
  Truth m;
  m.bit_inclination = inclination * degree;
  m.bit_azimuth = azimuth * degree;
  return m;
}

Truth drilling_at(double time, double wob)
{
  Truth m;
  m.time = time;
  m.on_bottom = true;
  m.wob = wob;
  return m;
}

void expect_means(double base, const Averages& a)
{
  EXPECT_DOUBLE_EQ(base + 1, a.hook_load());
  EXPECT_DOUBLE_EQ(base + 8, a.torque());
  EXPECT_DOUBLE_EQ(base + 12, a.hole_depth());
  EXPECT_DOUBLE_EQ(base + 15, a.rop());
  EXPECT_DOUBLE_EQ(base + 21, a.bit_position().x());
  EXPECT_DOUBLE_EQ(base + 22, a.bit_position().y());
  EXPECT_DOUBLE_EQ(base + 23, a.bit_position().z());
  EXPECT_DOUBLE_EQ(base + 31, a.wob());
  EXPECT_DOUBLE_EQ(base + 32, a.bit_torque());
  EXPECT_DOUBLE_EQ(base + 33, a.bit_speed());
}

Averages of(std::initializer_list<Truth> samples)
{
  Averages a;
  for (const Truth& m : samples) a.add(m);
  return a;
}
}  // namespace

TEST(Averages, areMeansOfEachField)
{
  const Averages a = of({sample(100), sample(200), sample(600)});
  EXPECT_EQ(3u, a.samples());
  EXPECT_EQ(100.0, a.first_time());
  expect_means(300.0, a);
}

TEST(Averages, ofTwoAreThoseOfAllTheirSamples)
{
  Averages late = of({sample(600)});
  late.add(of({sample(100), sample(200)}));
  EXPECT_EQ(3u, late.samples());
  EXPECT_EQ(100.0, late.first_time());
  expect_means(300.0, late);
  late.add(Averages());
  EXPECT_EQ(100.0, late.first_time()) << "nothing adds nothing";
  Averages none;
  none.add(late);
  EXPECT_EQ(100.0, none.first_time()) << "not the nought of having none";
  expect_means(300.0, none);
}

TEST(Averages, directionIsThatOfTheMeanVector)
{
  Averages a = of({towards(30.0, 350.0)});
  EXPECT_NEAR(30.0 * degree, a.inclination(), 1e-12);
  EXPECT_NEAR(350.0 * degree, a.azimuth(), 1e-12);
  a.add(of({towards(30.0, 30.0)}));
  EXPECT_NEAR(10.0 * degree, a.azimuth(), 1e-12) << "across north";
  // sin 30 cos 20 outwards, cos 30 down
  EXPECT_NEAR(std::atan(0.5 * std::cos(20.0 * degree) / std::cos(30.0 * degree)), a.inclination(), 1e-12);
  EXPECT_NEAR(120.0 * degree, of({towards(120.0, 200.0)}).inclination(), 1e-12) << "upwards";
}

TEST(Averages, areNoNumbersWithoutSamples)
{
  const Averages a;
  for (const double mean : {a.hook_load(), a.wob(), a.rop(), a.bit_position().x(), a.inclination(), a.azimuth()})
    EXPECT_TRUE(std::isnan(mean));
}

TEST(DrillingRecord, countsTheTimeOnBottomAlone)
{
  DrillingRecord record;
  EXPECT_EQ(0u, record.all().samples());
  EXPECT_EQ(0u, record.last_quarter().samples());
  record.add(drilling_at(0.0, 10.0));
  Truth off = drilling_at(0.1, 1000.0);
  off.on_bottom = false;
  record.add(off);
  record.add(drilling_at(0.2, 20.0));
  EXPECT_EQ(2u, record.all().samples());
  EXPECT_DOUBLE_EQ(15.0, record.all().wob());
}

// Ten seconds at ten samples a second, the weight that of the second: the last quarter is whole seconds, three of them.
TEST(DrillingRecord, lastQuarterIsOfWholeSeconds)
{
  DrillingRecord record;
  for (int k = 0; k < 100; ++k) record.add(drilling_at(50.0 + 0.1 * k, k / 10));
  EXPECT_EQ(100u, record.all().samples());
  EXPECT_NEAR(4.5, record.all().wob(), 1e-12);
  EXPECT_EQ(30u, record.last_quarter().samples());
  EXPECT_NEAR(8.0, record.last_quarter().wob(), 1e-12);
  DrillingRecord four;
  for (int k = 0; k < 40; ++k) four.add(drilling_at(0.1 * k, k / 10));
  EXPECT_EQ(10u, four.last_quarter().samples()) << "of four seconds one";
}

// Twenty seconds at ten samples a second, off bottom, the weight that of the second: seconds 10 to 19.
TEST(LatestRecord, isOfTheLastTenSeconds)
{
  LatestRecord record;
  EXPECT_EQ(0u, record.all().samples());
  for (int k = 0; k < 200; ++k)
  {
    Truth off = drilling_at(0.1 * k, k / 10);
    off.on_bottom = false;
    record.add(off);
  }
  EXPECT_EQ(100u, record.all().samples());
  EXPECT_NEAR(14.5, record.all().wob(), 1e-12);
  EXPECT_NEAR(10.0, record.all().first_time(), 1e-9);
}

}  // namespace drill_rig_sim::test_tools_averages
