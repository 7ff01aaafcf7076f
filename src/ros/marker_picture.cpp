// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/marker_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/math/viridis.h"
#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
namespace
{
using visualization_msgs::Marker;

constexpr int tube_sides = 12;
constexpr double color_memory = 0.98;  // the colour scale falls by 2 % per picture after a peak

std_msgs::ColorRGBA color(double r, double g, double b, double a = 1.0)
{
  std_msgs::ColorRGBA c;
  c.r = static_cast<float>(r);
  c.g = static_cast<float>(g);
  c.b = static_cast<float>(b);
  c.a = static_cast<float>(a);
  return c;
}

const std_msgs::ColorRGBA bit_color = color(0.1, 0.5, 1.0), force_color = color(0.95, 0.2, 0.95),
                          block_color = color(0.9, 0.75, 0.1), tube_color = color(0.80, 0.56, 0.32, 0.45),
                          station_color = color(0.95, 0.95, 0.95);

// The light part of the scale: the string is thin, and seen through the wall of its hole.
std_msgs::ColorRGBA graded(double share)
{
  const Rgb shade = viridis(0.4 + 0.6 * std::clamp(share, 0.0, 1.0));
  return color(shade[0], shade[1], shade[2]);
}

const std::vector<double>& quantity(const StringProfile& profile, ColorQuantity which)
{
  switch (which)
  {
    case ColorQuantity::tension:
      return profile.tension;
    case ColorQuantity::torque:
      return profile.torque;
    case ColorQuantity::bending_moment:
      return profile.bending_moment;
    case ColorQuantity::contact_force:
      break;
  }
  return profile.contact_force;
}

// The size that nine values in ten stay below: one large value at the bit is not to hide all others.
double nearly_largest(const std::vector<double>& values)
{
  std::vector<double> sizes(values);
  for (double& size : sizes) size = std::abs(size);
  const auto place = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
  std::nth_element(sizes.begin(), place, sizes.end());
  return *place;
}

// A ring of points about each node, the first side carried along without twist.
std::vector<std::vector<Eigen::Vector3d>> rings(const std::vector<WellNode>& well, double exaggeration)
{
  std::vector<std::vector<Eigen::Vector3d>> result;
  Eigen::Vector3d side = Eigen::Vector3d::UnitX();
  for (const WellNode& node : well)
  {
    side = (side - side.dot(node.tangent) * node.tangent).normalized();
    const Eigen::Vector3d other = node.tangent.cross(side);
    std::vector<Eigen::Vector3d> ring;
    for (int k = 0; k < tube_sides; ++k)
    {
      const double angle = 2.0 * pi * k / tube_sides;
      ring.push_back(node.position + exaggeration * node.radius * (std::cos(angle) * side + std::sin(angle) * other));
    }
    result.push_back(std::move(ring));
  }
  return result;
}
}  // namespace

MarkerPicture::MarkerPicture(const Parameters& parameters)
    : floor_(parameters.floor()),
      exaggeration_(parameters.lateral_exaggeration),
      force_scale_(parameters.force_scale),
      color_by_(parameters.color_by)
{
}

visualization_msgs::MarkerArray MarkerPicture::draw(const FrameOutput& s)
{
  visualization_msgs::MarkerArray array;
  array.markers = {string_marker(s), bit_marker(s), force_marker(s), block_marker(s)};
  if (s.tube_due)
  {
    array.markers.push_back(tube_marker(s));
    array.markers.push_back(station_marker(s));
  }
  return array;
}

Marker MarkerPicture::marker(const FrameOutput& s, const std::string& name, int type) const
{
  Marker m;
  m.header.stamp = to_time(s.frame.stamp);
  m.header.frame_id = floor_;
  m.ns = name;
  m.id = 0;
  m.type = type;
  m.action = Marker::ADD;
  m.pose.orientation.w = 1.0;
  return m;
}

Eigen::Vector3d MarkerPicture::drawn(const FrameOutput& s, std::size_t i) const
{
  return s.axis[i].position + exaggeration_ * (s.profile.position[i] - s.axis[i].position);
}

Marker MarkerPicture::string_marker(const FrameOutput& s)
{
  const std::vector<double>& values = quantity(s.profile, color_by_);
  color_full_ = std::max({nearly_largest(values), color_memory * color_full_, 1e-9});

  Marker m = marker(s, "string", Marker::LINE_STRIP);
  for (std::size_t i = 0; i < s.profile.position.size(); ++i)
  {
    m.points.push_back(to_point(drawn(s, i)));
    m.colors.push_back(graded(std::abs(values[i]) / color_full_));
  }
  m.scale.x = exaggeration_ * 2.0 * *std::min_element(s.profile.radius.begin(), s.profile.radius.end());
  m.color = graded(0.0);
  return m;
}

Marker MarkerPicture::bit_marker(const FrameOutput& s) const
{
  Marker m = marker(s, "bit", Marker::SPHERE);
  m.pose.position = to_point(drawn(s, 0));
  m.scale.x = m.scale.y = m.scale.z = exaggeration_ * 2.0 * s.axis.front().radius;
  m.color = bit_color;
  return m;
}

Marker MarkerPicture::force_marker(const FrameOutput& s) const
{
  Marker m = marker(s, "contact_forces", Marker::LINE_LIST);
  for (std::size_t i = 0; i < s.profile.position.size(); ++i)
  {
    if (s.profile.contact_force[i] <= 0.0) continue;
    const Eigen::Vector3d foot = drawn(s, i);
    m.points.push_back(to_point(foot));
    m.points.push_back(to_point(foot + force_scale_ * s.profile.contact_vector[i]));
  }
  if (m.points.empty()) m.action = Marker::DELETE;  // rviz calls a list without points an error
  m.scale.x = 0.02 * exaggeration_;
  m.color = force_color;
  return m;
}

Marker MarkerPicture::block_marker(const FrameOutput& s) const
{
  Marker m = marker(s, "traveling_block", Marker::CUBE);
  m.pose.position.z = s.frame.truth.block_height + s.frame.truth.floor_height + 2.0;
  m.scale.x = m.scale.y = m.scale.z = 4.0;
  m.color = block_color;
  return m;
}

Marker MarkerPicture::tube_marker(const FrameOutput& s) const
{
  Marker m = marker(s, "wellbore", Marker::TRIANGLE_LIST);
  const auto ring = rings(s.well, exaggeration_);
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
  {
    for (std::size_t k = 0; k < tube_sides; ++k)
    {
      const std::size_t l = (k + 1) % tube_sides;
      for (const Eigen::Vector3d& p : {ring[i][k], ring[i + 1][k], ring[i][l], ring[i][l], ring[i + 1][k], ring[i + 1][l]})
        m.points.push_back(to_point(p));
    }
  }
  m.scale.x = m.scale.y = m.scale.z = 1.0;
  m.color = tube_color;
  return m;
}

Marker MarkerPicture::station_marker(const FrameOutput& s) const
{
  Marker m = marker(s, "stations", Marker::SPHERE_LIST);
  for (const WellNode& station : s.stations) m.points.push_back(to_point(station.position));
  m.scale.x = m.scale.y = m.scale.z = 0.12 * exaggeration_;
  m.color = station_color;
  return m;
}

}  // namespace drill_rig_sim
