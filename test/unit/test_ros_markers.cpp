// SPDX-License-Identifier: BSD-3-Clause
// The picture for rviz against one drawn by hand: places with lateral exaggeration, sizes, colours at both ends of their scale.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/ros/marker_picture.h"
#include "numbered_frame.h"

namespace drill_rig_sim::test_ros_markers
{
namespace
{
using visualization_msgs::Marker;

Parameters ten_times()
{
  Parameters p;
  p.frame_prefix = "rig_b/";
  p.lateral_exaggeration = 10.0;
  p.force_scale = 0.01;
  p.color_by = ColorQuantity::tension;
  return p;
}

/// The marker of this name in a picture of the frame.
Marker drawn(MarkerPicture& picture, const FrameOutput& s, const std::string& name)
{
  for (const Marker& m : picture.draw(s).markers)
    if (m.ns == name) return m;
  throw std::runtime_error("no " + name);
}
Marker drawn(const FrameOutput& s, const std::string& name, const Parameters& parameters = ten_times())
{
  MarkerPicture picture(parameters);
  return drawn(picture, s, name);
}

void expect_point(double x, double y, double z, const geometry_msgs::Point& p)
{
  EXPECT_NEAR(x, p.x, 1e-12);
  EXPECT_NEAR(y, p.y, 1e-12);
  EXPECT_NEAR(z, p.z, 1e-12);
}

void expect_color(double r, double g, double b, const std_msgs::ColorRGBA& c)
{
  EXPECT_NEAR(r, c.r, 1e-6);
  EXPECT_NEAR(g, c.g, 1e-6);
  EXPECT_NEAR(b, c.b, 1e-6);
  EXPECT_FLOAT_EQ(1.0f, c.a);
}

/// `value` along the string where the other nodes carry the full scale's.
std_msgs::ColorRGBA color_of(double value, double full)
{
  FrameOutput s = numbered_output();
  s.profile.tension = {value, full, full};
  return drawn(s, "string").colors.front();
}

/// Two nodes of hole 10 m apart, 0.1 m and 0.2 m of radius.
FrameOutput with_well()
{
  FrameOutput s = numbered_output();
  s.tube_due = true;
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
  s.well = {{0.0, {1.0, 2.0, 0.0}, down, 0.1, 0.2}, {10.0, {1.0, 2.0, -10.0}, down, 0.2, 0.2}};
  s.stations = {{0.0, {1.0, 2.0, 0.0}, down, 0.1, 0.2}, {20.0, {3.0, 4.0, -19.0}, down, 0.1, 0.2}};
  return s;
}
}  // namespace

TEST(Markers, eachHasItsNamespaceAndTheFramesStamp)
{
  MarkerPicture picture(ten_times());
  const auto markers = picture.draw(with_well()).markers;
  const std::vector<std::pair<std::string, int>> expected = {
      {"string", Marker::LINE_STRIP},        {"bit", Marker::SPHERE},
      {"contact_forces", Marker::LINE_LIST}, {"traveling_block", Marker::CUBE},
      {"wellbore", Marker::TRIANGLE_LIST},   {"stations", Marker::SPHERE_LIST}};
  ASSERT_EQ(expected.size(), markers.size());
  for (std::size_t i = 0; i < markers.size(); ++i)
  {
    EXPECT_EQ(expected[i].first, markers[i].ns);
    EXPECT_EQ(expected[i].second, markers[i].type);
    EXPECT_EQ(0, markers[i].id);
    EXPECT_EQ(Marker::ADD, markers[i].action);
    EXPECT_EQ("rig_b/rig_floor", markers[i].header.frame_id);
    EXPECT_EQ(ros::Time(12, 345678901), markers[i].header.stamp);
    EXPECT_EQ(1.0, markers[i].pose.orientation.w);
  }
  EXPECT_EQ(4u, picture.draw(numbered_output()).markers.size()) << "the well only where it is due";
}

// The second node lies 0.5 m east of the axis: drawn at 5 m.
TEST(Markers, stringIsDrawnWithItsOffsetExaggerated)
{
  const Marker m = drawn(numbered_output(), "string");
  ASSERT_EQ(3u, m.points.size());
  expect_point(1.0, 2.0, -100.0, m.points[0]);
  expect_point(9.0, 5.0, -90.0, m.points[1]);
  expect_point(7.0, 8.0, -80.0, m.points[2]);
  EXPECT_DOUBLE_EQ(10.0 * 2.0 * 0.06, m.scale.x) << "the thinnest pipe's diameter";
  EXPECT_EQ(3u, m.colors.size());
}

TEST(Markers, coloursGoFromTealThroughGreenToYellow)
{
  expect_color(0.146, 0.572, 0.53, color_of(0.0, 100.0));
  expect_color(0.216, 0.696, 0.462, color_of(25.0, 100.0));
  expect_color(0.134, 0.638, 0.515, color_of(12.5, 100.0));
  expect_color(0.474, 0.804, 0.318, color_of(50.0, 100.0));
  expect_color(0.732, 0.868, 0.218, color_of(75.0, 100.0));
  expect_color(0.99, 0.91, 0.14, color_of(100.0, 100.0));
  expect_color(0.732, 0.868, 0.218, color_of(-75.0, 100.0));  // size counts
  expect_color(0.99, 0.91, 0.14, color_of(200.0, 100.0));     // beyond the scale
  expect_color(0.146, 0.572, 0.53, drawn(numbered_output(), "string").color);
}

TEST(Markers, eachQuantityColours)
{
  const FrameOutput s = numbered_output();
  const std::vector<std::pair<ColorQuantity, std::vector<double> StringProfile::*>> quantities = {
      {ColorQuantity::contact_force, &StringProfile::contact_force},
      {ColorQuantity::tension, &StringProfile::tension},
      {ColorQuantity::torque, &StringProfile::torque},
      {ColorQuantity::bending_moment, &StringProfile::bending_moment}};
  for (const auto& [quantity, values] : quantities)
  {
    Parameters p = ten_times();
    p.color_by = quantity;
    FrameOutput one = s;
    for (const auto& other : quantities) one.profile.*other.second = {9.0, 9.0, 9.0};
    one.profile.*values = {0.0, 0.5, 1.0};
    const Marker m = drawn(one, "string", p);
    expect_color(0.146, 0.572, 0.53, m.colors[0]);
    expect_color(0.474, 0.804, 0.318, m.colors[1]);
    expect_color(0.99, 0.91, 0.14, m.colors[2]);
  }
}

// Of twenty nodes the full scale is what the two largest lie at or above, so that one peak at the bit hides nothing.
TEST(Markers, fullScaleLeavesTheLargestTenthOut)
{
  FrameOutput s = numbered_output();
  const WellNode axis = s.axis.front();
  s.axis.assign(20, axis);
  s.profile.position.assign(20, axis.position);
  s.profile.contact_force.assign(20, 0.0);
  s.profile.contact_vector.assign(20, Eigen::Vector3d::Zero());
  s.profile.tension.assign(20, 40.0);
  s.profile.tension[0] = -1e9;
  s.profile.tension[5] = 100.0;
  s.profile.tension[6] = 50.0;
  const Marker m = drawn(s, "string");
  expect_color(0.99, 0.91, 0.14, m.colors[0]);
  expect_color(0.99, 0.91, 0.14, m.colors[5]);
  expect_color(0.474, 0.804, 0.318, m.colors[6]);     // 50 of 100
  expect_color(0.3708, 0.7608, 0.3756, m.colors[7]);  // 40 of 100
}

TEST(Markers, fullScaleFallsSlowlyAfterAPeakAndIsForgottenWithTheRig)
{
  MarkerPicture picture(ten_times());
  FrameOutput s = numbered_output();
  s.profile.tension = {100.0, 100.0, 100.0};
  picture.draw(s);
  s.profile.tension = {49.0, 49.0, 49.0};
  expect_color(0.474, 0.804, 0.318, drawn(picture, s, "string").colors[0]);  // 49 of 98
  s.profile.tension = {48.02, 48.02, 48.02};
  expect_color(0.474, 0.804, 0.318, drawn(picture, s, "string").colors[0]);  // 48.02 of 96.04
  picture.restart();
  expect_color(0.99, 0.91, 0.14, drawn(picture, s, "string").colors[0]);
}

TEST(Markers, bitIsAsLargeAsItsHole)
{
  FrameOutput s = numbered_output();
  s.profile.position[0] = {1.1, 2.0, -100.0};
  const Marker m = drawn(s, "bit");
  expect_point(2.0, 2.0, -100.0, m.pose.position);
  for (const double size : {m.scale.x, m.scale.y, m.scale.z}) EXPECT_DOUBLE_EQ(10.0 * 2.0 * 0.11, size);
}

TEST(Markers, forcesAreLinesOfTheirScaleWhereTheWallTouches)
{
  const Marker m = drawn(numbered_output(), "contact_forces");
  ASSERT_EQ(2u, m.points.size()) << "one node touches";
  expect_point(9.0, 5.0, -90.0, m.points[0]);
  expect_point(9.0 - 20.0, 5.0 + 1.0, -90.0 + 3.0, m.points[1]);  // 0.01 m/N of (-2000, 100, 300) N
  EXPECT_DOUBLE_EQ(0.2, m.scale.x);
}

TEST(Markers, withoutAnyForceTheLinesAreTakenAway)
{
  FrameOutput s = numbered_output();
  EXPECT_EQ(Marker::ADD, drawn(s, "contact_forces").action);
  s.profile.contact_force.assign(s.profile.contact_force.size(), 0.0);
  const Marker m = drawn(s, "contact_forces");
  EXPECT_TRUE(m.points.empty());
  EXPECT_EQ(Marker::DELETE, m.action);
}

TEST(Markers, blockStandsOnItsShaft)
{
  const Marker m = drawn(numbered_output(), "traveling_block");
  expect_point(0.0, 0.0, 225.0, m.pose.position);  // 104 m above a floor that is 119 m high, and half its own 4 m
  for (const double size : {m.scale.x, m.scale.y, m.scale.z}) EXPECT_EQ(4.0, size);
}

TEST(Markers, wellboreIsATubeOfExaggeratedRadius)
{
  const Marker m = drawn(with_well(), "wellbore");
  ASSERT_EQ(12u * 6u, m.points.size()) << "two triangles a side";
  for (const auto& p : m.points)
  {
    const double radius = std::hypot(p.x - 1.0, p.y - 2.0);
    EXPECT_NEAR(p.z == 0.0 ? 1.0 : 2.0, radius, 1e-12);
    EXPECT_TRUE(p.z == 0.0 || p.z == -10.0);
  }
  // the first side: 30 deg of the circle, from x = 1 + radius
  expect_point(2.0, 2.0, 0.0, m.points[0]);
  expect_point(3.0, 2.0, -10.0, m.points[1]);
  EXPECT_NEAR(std::cos(30.0 * degree), m.points[2].x - 1.0, 1e-12);
  EXPECT_NEAR(std::sin(30.0 * degree), std::abs(m.points[2].y - 2.0), 1e-12);
  EXPECT_FLOAT_EQ(0.45f, m.color.a) << "seen through";
  double area = 0.0;
  for (std::size_t i = 0; i < m.points.size(); i += 3)
  {
    const auto vector = [&](std::size_t j) { return Eigen::Vector3d(m.points[j].x, m.points[j].y, m.points[j].z); };
    area += 0.5 * (vector(i + 1) - vector(i)).cross(vector(i + 2) - vector(i)).norm();
  }
  // 12 trapezia: mean chord 2 sin 15 deg (1 + 2) / 2, height sqrt(10^2 + cos(15 deg)^2)
  const double chord = 2.0 * std::sin(15.0 * degree) * 1.5, height = std::hypot(10.0, std::cos(15.0 * degree));
  EXPECT_NEAR(12.0 * chord * height, area, 1e-9) << "the triangles cover the tube once";
}

TEST(Markers, stationsLieOnTheAxis)
{
  const Marker m = drawn(with_well(), "stations");
  ASSERT_EQ(2u, m.points.size());
  expect_point(1.0, 2.0, 0.0, m.points[0]);
  expect_point(3.0, 4.0, -19.0, m.points[1]);
  for (const double size : {m.scale.x, m.scale.y, m.scale.z}) EXPECT_DOUBLE_EQ(1.2, size);
}

}  // namespace drill_rig_sim::test_ros_markers
