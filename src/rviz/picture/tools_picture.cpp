// SPDX-License-Identifier: BSD-3-Clause
#include "tools_picture.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr double two_pi = 6.283185307179586;
constexpr Color blade{0.10f, 0.50f, 1.00f}, core{0.06f, 0.28f, 0.62f}, marked{1.00f, 0.85f, 0.20f}, steel{0.72f, 0.74f, 0.78f};

Vector3d on_circle(double x, double radius, double angle)
{
  return {x, radius * std::cos(angle), radius * std::sin(angle)};
}

/// A quad with the normal that the four places have.
void add_face(MeshData& mesh, const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d, const Color& color)
{
  const Vector3d across = (c - a).cross(d - b);
  const Vector3d normal = across.norm() > 0.0 ? Vector3d(across.normalized()) : Vector3d(Vector3d::UnitX());
  add_quad(mesh, a, b, c, d, normal, color);
}

void add_revolution(MeshData& mesh, const std::vector<ProfilePoint>& profile, double share, const Color& color)
{
  std::vector<Ring> rings;
  rings.reserve(profile.size());
  for (const ProfilePoint& p : profile)
    rings.push_back({p.x * Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ(), share * p.radius, color});
  add_tube(mesh, rings, 24);
  add_disc(mesh, rings.front(), 24, true);
  add_disc(mesh, rings.back(), 24, false);
}
}  // namespace

void add_blades(MeshData& mesh, const std::vector<ProfilePoint>& profile, int count, double inner, double turn, double share,
                const Color& color)
{
  const double width = share * two_pi / count, from = profile.front().x, length = profile.back().x - from;
  for (int k = 0; k < count; ++k)
  {
    const Color& of_blade = k == 0 ? marked : color;  // one of another colour shows the turning
    const auto corner = [&](std::size_t i, bool outside, bool late)
    {
      const double start = two_pi * k / count + turn * (profile[i].x - from) / length;
      return on_circle(profile[i].x, (outside ? 1.0 : inner) * profile[i].radius, start + (late ? width : 0.0));
    };
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    {
      const std::size_t j = i + 1;
      add_face(mesh, corner(i, true, false), corner(i, true, true), corner(j, true, true), corner(j, true, false), of_blade);
      add_face(mesh, corner(i, false, false), corner(i, true, false), corner(j, true, false), corner(j, false, false), of_blade);
      add_face(mesh, corner(i, true, true), corner(i, false, true), corner(j, false, true), corner(j, true, true), of_blade);
    }
    const std::size_t last = profile.size() - 1;
    add_face(mesh, corner(0, false, false), corner(0, false, true), corner(0, true, true), corner(0, true, false), of_blade);
    add_face(mesh, corner(last, true, false), corner(last, true, true), corner(last, false, true), corner(last, false, false),
             of_blade);
  }
}

MeshData bit_mesh(double length, double radius)
{
  MeshData mesh;
  const std::vector<ProfilePoint> profile{{-0.70 * length, 0.80 * radius}, {-0.62 * length, radius},
                                          {-0.30 * length, radius},        {-0.15 * length, 0.93 * radius},
                                          {-0.05 * length, 0.70 * radius}, {0.0, 0.35 * radius}};
  add_revolution(mesh, profile, 0.78, core);
  add_blades(mesh, profile, 6, 0.7, 0.5, 0.5, blade);
  add_revolution(mesh, {{-length, 0.55 * radius}, {-0.8 * length, 0.55 * radius}, {-0.68 * length, 0.70 * radius}}, 1.0, steel);
  return mesh;
}

MeshData stabilizer_mesh(double length, double radius, double widest)
{
  MeshData mesh;
  const std::vector<ProfilePoint> profile{
      {-5.0 / 6.0 * length, radius}, {-0.72 * length, widest}, {-0.28 * length, widest}, {-length / 6.0, radius}};
  add_blades(mesh, profile, 4, 0.95 * std::min(radius / widest, 1.0), 0.8, 0.4, steel);
  return mesh;
}

}  // namespace drill_rig_sim
