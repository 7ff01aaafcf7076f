// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_data.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr double two_pi = 6.283185307179586;

std::uint8_t byte(float share)
{
  return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f)));
}

/// Cosines and sines of `sides` equal angles.
std::vector<Eigen::Vector2d> circle(int sides)
{
  std::vector<Eigen::Vector2d> points;
  points.reserve(static_cast<std::size_t>(sides));
  for (int k = 0; k < sides; ++k) points.emplace_back(std::cos(two_pi * k / sides), std::sin(two_pi * k / sides));
  return points;
}

/// A frame across a straight line.
Ring across_line(const Vector3d& center, const Vector3d& direction, double radius, const Color& color)
{
  const Vector3d side = direction.unitOrthogonal();
  return {center, side, direction.cross(side), radius, color};
}
}  // namespace

void MeshData::clear()
{
  vertices.clear();
  indices.clear();
}

std::uint32_t MeshData::add(const Vector3d& p, const Vector3d& n, const Color& c)
{
  vertices.push_back({{static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())},
                      {static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z())},
                      {byte(c.r), byte(c.g), byte(c.b), byte(c.a)}});
  return static_cast<std::uint32_t>(vertices.size() - 1);
}

void MeshData::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  indices.insert(indices.end(), {a, b, c});
}

void MeshData::add_line(const Vector3d& a, const Vector3d& b, const Color& color)
{
  const std::uint32_t first = add(a, Vector3d::UnitZ(), color);
  indices.insert(indices.end(), {first, add(b, Vector3d::UnitZ(), color)});
}

void shade(MeshData& mesh)
{
  constexpr float light[3] = {0.36f, -0.48f, 0.80f};  // unit
  for (Vertex& v : mesh.vertices)
  {
    const float share = 0.76f + 0.24f * (light[0] * v.normal[0] + light[1] * v.normal[1] + light[2] * v.normal[2]);
    for (int i = 0; i < 3; ++i) v.color[i] = static_cast<std::uint8_t>(share * static_cast<float>(v.color[i]));
  }
}

void add_quad(MeshData& mesh, const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d, const Vector3d& normal,
              const Color& color)
{
  const std::uint32_t first = mesh.add(a, normal, color);
  mesh.add(b, normal, color);
  mesh.add(c, normal, color);
  mesh.add(d, normal, color);
  mesh.add_triangle(first, first + 1, first + 2);
  mesh.add_triangle(first, first + 2, first + 3);
}

void add_tube(MeshData& mesh, const std::vector<Ring>& rings, int sides, bool inside)
{
  const std::vector<Eigen::Vector2d> round = circle(std::max(sides, 3));
  const auto n = static_cast<std::uint32_t>(round.size());
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.reserve(mesh.vertices.size() + n * rings.size());
  mesh.indices.reserve(mesh.indices.size() + 6 * n * rings.size());
  for (const Ring& ring : rings)
    for (const Eigen::Vector2d& angle : round)
    {
      const Vector3d out = angle.x() * ring.side + angle.y() * ring.other;
      mesh.add(ring.center + ring.radius * out, inside ? Vector3d(-out) : out, ring.color);
    }
  for (std::uint32_t i = 0; i + 1 < rings.size(); ++i)
    for (std::uint32_t k = 0; k < n; ++k)
    {
      const std::uint32_t l = (k + 1) % n, a = first + i * n, b = a + n;
      const std::uint32_t p = inside ? a + l : a + k, q = inside ? a + k : a + l, r = inside ? b + l : b + k,
                          s = inside ? b + k : b + l;
      mesh.add_triangle(p, q, s);
      mesh.add_triangle(p, s, r);
    }
}

void add_disc(MeshData& mesh, const Ring& ring, int sides, bool back)
{
  const Vector3d normal = (back ? -1.0 : 1.0) * ring.side.cross(ring.other);
  const std::uint32_t middle = mesh.add(ring.center, normal, ring.color);
  const std::vector<Eigen::Vector2d> round = circle(std::max(sides, 3));
  const auto n = static_cast<std::uint32_t>(round.size());
  for (const Eigen::Vector2d& angle : round)
    mesh.add(ring.center + ring.radius * (angle.x() * ring.side + angle.y() * ring.other), normal, ring.color);
  for (std::uint32_t k = 0; k < n; ++k)
  {
    const std::uint32_t a = middle + 1 + k, b = middle + 1 + (k + 1) % n;
    mesh.add_triangle(middle, back ? b : a, back ? a : b);
  }
}

void add_arrow(MeshData& mesh, const Vector3d& tail, const Vector3d& tip, double radius, const Color& color, int sides)
{
  const double length = (tip - tail).norm();
  if (!(length > 0.0)) return;
  const Vector3d direction = (tip - tail) / length;
  const Vector3d neck = tip - std::min(0.5 * length, 8.0 * radius) * direction;
  const Ring foot = across_line(tail, direction, radius, color);
  Ring top = foot, wide = foot, point = foot;
  top.center = wide.center = neck;
  wide.radius = 3.0 * radius;
  point.center = tip;
  point.radius = 0.0;
  add_tube(mesh, {foot, top, wide, point}, sides);
}

void add_box(MeshData& mesh, const Vector3d& least, const Vector3d& most, const Color& color)
{
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true})
    {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      Vector3d corner = least;
      corner[axis] = high ? most[axis] : least[axis];
      Vector3d along_u = Vector3d::Zero(), along_v = Vector3d::Zero(), normal = Vector3d::Zero();
      along_u[u] = most[u] - least[u];
      along_v[v] = most[v] - least[v];
      normal[axis] = high ? 1.0 : -1.0;
      const std::uint32_t a = mesh.add(corner, normal, color), b = mesh.add(corner + along_u, normal, color);
      const std::uint32_t c = mesh.add(corner + along_u + along_v, normal, color), d = mesh.add(corner + along_v, normal, color);
      mesh.add_triangle(a, high ? b : c, high ? c : b);
      mesh.add_triangle(a, high ? c : d, high ? d : c);
    }
}

void add_bar(MeshData& mesh, const Vector3d& from, const Vector3d& to, double width, const Color& color)
{
  const double length = (to - from).norm();
  if (!(length > 0.0)) return;
  const Ring start = across_line(from, (to - from) / length, 0.7071 * width, color);
  Ring end = start;
  end.center = to;
  add_tube(mesh, {start, end}, 4);
}

void add_dashes(MeshData& mesh, const std::vector<Vector3d>& points, double dash, const Color& color)
{
  double walked = 0.0;  // along the line
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const Vector3d way = points[i + 1] - points[i];
    const double length = way.norm();
    for (double from = 0.0; from < length;)
    {
      const double place = walked + from, in_dash = std::fmod(place, 2.0 * dash);
      const double to = std::min(length, from + std::max((in_dash < dash ? dash : 2.0 * dash) - in_dash, 1e-6 * dash));
      if (in_dash < dash) mesh.add_line(points[i] + from / length * way, points[i] + to / length * way, color);
      from = to;
    }
    walked += length;
  }
}

}  // namespace drill_rig_sim
