// SPDX-License-Identifier: BSD-3-Clause
#include "well_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr Color casing{0.50f, 0.56f, 0.62f}, line{0.80f, 0.76f, 0.68f};
constexpr std::array<Color, 6> rock{{{0.58f, 0.42f, 0.27f},
                                     {0.46f, 0.45f, 0.42f},
                                     {0.62f, 0.53f, 0.26f},
                                     {0.52f, 0.31f, 0.25f},
                                     {0.42f, 0.45f, 0.30f},
                                     {0.36f, 0.42f, 0.49f}}};
constexpr float band_opacity = 0.30f;
constexpr double beyond_end = 1.0;  // of a plan, which goes on straight for so long [m]

/// Places of the wall's rings, top down: evenly, and just above and below where something changes.
std::vector<double> ring_depths(const HoleAxis& axis, const RigData& rig, double shoe, double spacing)
{
  std::vector<double> depths;
  const double end = axis.depth();
  const int pieces = std::max(1, static_cast<int>(std::ceil(end / spacing)));
  for (int i = 0; i <= pieces; ++i) depths.push_back(end * i / pieces);
  std::vector<double> steps = rig.section_bottom;
  steps.push_back(shoe);
  for (const double step : steps)
    if (step > 0.0 && step < end) depths.insert(depths.end(), {step - 1e-3, step + 1e-3});
  std::sort(depths.begin(), depths.end());
  return depths;
}

Ring wall_ring(const AxisPoint& p, double radius, const Color& color)
{
  return {p.position, p.side, p.other(), radius, color};
}
}  // namespace

Color layer_color(std::size_t layer) noexcept
{
  return rock[layer % rock.size()];
}

std::vector<Ring> wall_rings(const HoleAxis& axis, const RigData& rig, double shoe, double exaggeration, double spacing)
{
  std::vector<Ring> rings;
  for (const double md : ring_depths(axis, rig, shoe, spacing))
  {
    const AxisPoint p = axis.at(md);
    const Color color = md < shoe ? casing : layer_color(rig.layer_at(-p.position.z()));
    if (!rings.empty() && (rings.back().color.r != color.r || rings.back().color.g != color.g))
    {
      rings.push_back(wall_ring(p, exaggeration * rig.hole_radius(md), rings.back().color));  // a sharp edge between two colours
    }
    rings.push_back(wall_ring(p, exaggeration * rig.hole_radius(md), color));
  }
  return rings;
}

Vector3d closure_direction(const HoleAxis& axis) noexcept
{
  const AxisPoint& bottom = axis.points().back();
  for (const Vector3d& way : {bottom.position, bottom.tangent})
  {
    const Vector3d flat(way.x(), way.y(), 0.0);
    if (flat.norm() > 1e-3 * std::max(way.norm(), 1e-3)) return flat.normalized();
  }
  return Vector3d::UnitX();
}

void add_layers(MeshData& bands, MeshData& lines, const HoleAxis& axis, const RigData& rig, double margin)
{
  const Vector3d along = closure_direction(axis), normal(-along.y(), along.x(), 0.0);
  double least = 0.0, most = 0.0, lowest = 0.0;
  for (const AxisPoint& p : axis.points())
  {
    least = std::min(least, p.position.dot(along));
    most = std::max(most, p.position.dot(along));
    lowest = std::min(lowest, p.position.z());
  }
  const double bottom = lowest - margin;
  const Vector3d left = (least - margin) * along, right = (most + margin) * along, up = Vector3d::UnitZ();
  double top = 0.0;
  for (std::size_t i = 0; i < std::max<std::size_t>(rig.layer_base.size(), 1) && top > bottom; ++i)
  {
    const bool last = i + 1 >= rig.layer_base.size();
    const double base = last ? bottom : std::max(bottom, -rig.layer_base[i]);
    if (base >= top) continue;  // all of it above the table
    Color color = layer_color(i);
    color.a = band_opacity;
    add_quad(bands, left + base * up, right + base * up, right + top * up, left + top * up, normal, color);
    if (base > bottom) lines.add_line(left + base * up, right + base * up, line);
    top = base;
  }
}

PlanDistance distance_to_plan(const std::vector<Vector3d>& plan, const Vector3d& bottom) noexcept
{
  PlanDistance result;
  if (plan.size() < 2) return result;
  double least = INFINITY;
  bool beyond = false;
  for (std::size_t i = 0; i + 1 < plan.size(); ++i)
  {
    const Vector3d way = plan[i + 1] - plan[i];
    const double length = way.squaredNorm(), place = length > 0.0 ? (bottom - plan[i]).dot(way) / length : 0.0;
    const double end = i + 2 == plan.size() && length > 0.0 ? 1.0 + beyond_end / std::sqrt(length) : 1.0;
    const Vector3d foot = plan[i] + std::clamp(place, 0.0, end) * way;
    const double distance = (bottom - foot).norm();
    if (distance >= least) continue;
    least = distance;
    result.nearest = foot;
    beyond = i + 2 == plan.size() && place > end;
  }
  result.distance = least;
  result.there = !beyond;
  return result;
}

}  // namespace drill_rig_sim
