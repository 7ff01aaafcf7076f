// SPDX-License-Identifier: BSD-3-Clause
// What the strip chart remembers, which piece of it is seen, and what is drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "rviz/console/chart_window.h"
#include "rviz/console/history.h"

namespace test_rviz_chart
{
using namespace drill_rig_sim::console;

namespace
{
constexpr Quantity load = Quantity::hook_load;

Values of(double hook_load, double azimuth = missing)
{
  Values v;
  v.set(load, hook_load);
  v.set(Quantity::azimuth, azimuth);
  return v;
}

// A ramp of `steps` tenths of a second: hook load = time, one metre a second.
History ramp(Axis axis, int steps, std::size_t capacity, double interval)
{
  History h(axis, capacity, interval);
  for (int n = 0; n <= steps; ++n) h.add(0.1 * n, 100.0 + 0.1 * n, of(0.1 * n));
  return h;
}
}  // namespace

TEST(ConsoleHistory, TheOldestGo)
{
  const History h = ramp(Axis::time, 1000, 50, 0.2);
  ASSERT_EQ(50u, h.size());
  EXPECT_NEAR(100.0, h[49].time, 1e-9);
  EXPECT_NEAR(100.0 - 49 * 0.2, h[0].time, 1e-9);
}

TEST(ConsoleHistory, ASampleIsTheMeanOfItsInterval)
{
  History h(Axis::time, 10, 0.2);
  for (const double t : {0.0, 0.1, 0.2}) h.add(t, 5.0, of(30.0 * t, t < 0.15 ? 6.2 : 0.1));
  ASSERT_EQ(1u, h.size());
  EXPECT_NEAR(3.0, h[0].value[index_of(load)], 1e-12);
  EXPECT_NEAR(0.1, h[0].value[index_of(Quantity::azimuth)], 1e-12) << "angles have no mean";
  EXPECT_TRUE(std::isnan(h[0].value[index_of(Quantity::rop)]));
}

TEST(ConsoleHistory, DepthStandsWhileNothingIsDrilled)
{
  History h = ramp(Axis::depth, 10, 100, 0.1);
  const std::size_t before = h.size();
  for (int n = 0; n < 50; ++n) h.add(2.0 + n, 101.0, of(1e9));  // a connection
  EXPECT_EQ(before, h.size());
  h.add(60.0, 101.2, of(3.0));
  EXPECT_NEAR(3.0, h[h.size() - 1].value[index_of(load)], 1e-12);
}

TEST(ConsoleHistory, AnotherWellForgets)
{
  History h = ramp(Axis::depth, 100, 100, 0.1);
  h.add(20.0, 50.0, of(1.0));
  EXPECT_TRUE(h.empty());
}

TEST(ConsoleHistory, Nearest)
{
  const History h = ramp(Axis::time, 100, 1000, 0.2);
  EXPECT_NEAR(5.0, h[h.nearest(5.04)].time, 1e-9);
  EXPECT_NEAR(5.2, h[h.nearest(5.13)].time, 1e-9);
  EXPECT_EQ(0u, h.nearest(-100.0));
  EXPECT_EQ(h.size() - 1, h.nearest(1e9));
}

TEST(ConsoleHistory, APeakIsDrawnHoweverManySamplesAColumnHas)
{
  History h(Axis::time, 10000, 0.1);
  for (int n = 0; n < 5000; ++n) h.add(0.1 * n, 1.0, of(n == 1234 ? 99.0 : n == 3000 ? -99.0 : 1.0));
  const auto strokes = h.line(load, 0.0, 500.0, 100);
  ASSERT_EQ(1u, strokes.size());
  EXPECT_LE(strokes[0].size(), 204u);
  double least = 0.0, most = 0.0, x = -1.0;
  for (const ChartPoint& p : strokes[0])
  {
    least = std::min(least, p.y);
    most = std::max(most, p.y);
    EXPECT_GE(p.x, x) << "in order";
    x = p.x;
  }
  EXPECT_EQ(99.0, most);
  EXPECT_EQ(-99.0, least);
}

TEST(ConsoleHistory, APeakWithinASampleIsDrawn)
{
  History h(Axis::time, 100, 0.2);
  Values values;
  for (int n = 0; n < 400; ++n)
  {
    values.set(Quantity::hook_load, n == 205 ? 900e3 : n == 206 ? 100e3 : 500e3);
    h.add(0.01 * n, 0.0, values);
  }
  double least = 1e9, most = 0.0;
  for (const Stroke& stroke : h.line(Quantity::hook_load, 0.0, 4.0, 50))
    for (const ChartPoint& p : stroke)
    {
      least = std::min(least, p.y);
      most = std::max(most, p.y);
    }
  EXPECT_EQ(900e3, most);
  EXPECT_EQ(100e3, least);
}

TEST(ConsoleHistory, AGapStaysAGap)
{
  History h(Axis::time, 1000, 0.2);
  Values values;
  values.set(Quantity::hook_load, 500e3);
  for (const double begin : {0.0, 30.0})
    for (int n = 0; n < 100; ++n) h.add(begin + 0.1 * n, 0.0, values);
  const std::vector<Stroke> strokes = h.line(Quantity::hook_load, 0.0, 40.0, 100);
  ASSERT_EQ(2u, strokes.size());
  EXPECT_LT(strokes[0].back().x, 10.1);
  EXPECT_GT(strokes[1].front().x, 29.9);
  History slow(Axis::time, 1000, 0.2);
  for (int n = 0; n < 10; ++n) slow.add(10.0 * n, 0.0, values);
  EXPECT_LE(slow.line(Quantity::hook_load, 0.0, 100.0, 100).size(), 2u) << "they come every 10 s";
}

TEST(ConsoleHistory, NoLineWhereNothingWasHeard)
{
  History h = ramp(Axis::time, 50, 1000, 0.2);
  h.interrupt();
  for (int n = 200; n < 250; ++n) h.add(0.1 * n, 1.0, of(n == 220 || n == 221 || n == 222 ? missing : 1.0));
  const auto strokes = h.line(load, 0.0, 30.0, 300);
  ASSERT_EQ(3u, strokes.size()) << "before, after, and after what was missing";
  EXPECT_LE(strokes[0].back().x, 5.0 + 1e-9);
  EXPECT_GE(strokes[1].front().x, 20.0);
  EXPECT_TRUE(h.line(Quantity::rop, 0.0, 30.0, 300).empty());
}

TEST(ConsoleHistory, Csv)
{
  History h(Axis::time, 10, 0.1);
  h.add(0.0, 100.0, of(5.0));
  h.add(0.25, 100.5, of(7.0));
  std::ostringstream out;
  h.write_csv(out);
  std::istringstream in(out.str());
  std::string names, row, more;
  std::getline(in, names);
  std::getline(in, row);
  EXPECT_EQ(0u, names.find("time [s],hole_depth [m],hook_load [N],surface_wob [N],torque [N m],top_drive_speed [rad/s]"))
      << names;
  EXPECT_EQ(0u, row.find("0.25,100.5,6,,,")) << row;
  EXPECT_EQ(std::count(names.begin(), names.end(), ','), std::count(row.begin(), row.end(), ','));
  EXPECT_FALSE(std::getline(in, more));
}

TEST(ConsoleChartWindow, FollowsUntilItIsPaused)
{
  ChartWindow w(60.0, 5.0, 7200.0);
  w.follow(100.0);
  EXPECT_DOUBLE_EQ(40.0, w.from());
  w.pause(true);
  w.follow(200.0);
  EXPECT_DOUBLE_EQ(100.0, w.to());
  w.pause(false);
  EXPECT_DOUBLE_EQ(200.0, w.to());
  w.pan(-50.0);
  EXPECT_TRUE(w.paused());
  EXPECT_DOUBLE_EQ(150.0, w.to());
}

TEST(ConsoleChartWindow, ZoomKeepsThePlaceUnderTheCursor)
{
  ChartWindow w(60.0, 5.0, 120.0);
  w.follow(100.0);
  w.pause(true);
  w.zoom(0.5, 70.0);
  EXPECT_DOUBLE_EQ(30.0, w.span());
  EXPECT_DOUBLE_EQ(85.0, w.to());
  w.zoom(1e-9, 70.0);
  EXPECT_DOUBLE_EQ(5.0, w.span());
  w.zoom(1e9, 70.0);
  EXPECT_DOUBLE_EQ(120.0, w.span());
}
}  // namespace test_rviz_chart
