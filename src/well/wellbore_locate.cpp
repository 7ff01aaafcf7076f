// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "drill_rig_sim/math/one_lane.h"
#include "drill_rig_sim/well/wellbore.h"

namespace drill_rig_sim::one_lane
{
#include "drill_rig_sim/well/locate_text.h"
}  // namespace drill_rig_sim::one_lane

namespace drill_rig_sim
{
namespace
{
constexpr int most_iterations = 12;
constexpr int most_moves = 32;
// Newton's error after a step ds, and Taylor's along it, are about k h^2 ds^2 metres: 1e-14 m on an arc of 3 deg/30 m.
constexpr double step_tolerance = 1e-7;
// A first guess this far outside the segment is not worth refining.
constexpr double far_outside = 0.1;

struct Foot : one_lane::Foot
{
  int iterations = 0;
};

double first_guess(const HoleSegment& g, const Eigen::Vector3d& point) noexcept
{
  return (point - g.c0).dot(g.chord);
}

void refine(const HoleSegment& g, const Eigen::Vector3d& point, Foot& foot) noexcept
{
  const one_lane::Cubic cubic{one_lane::from(g.c0), one_lane::from(g.c1), one_lane::from(g.c2), one_lane::from(g.c3)};
  const one_lane::V3 at = one_lane::from(point);
  double step = 0.0;
  do
  {
    step = newton_step(cubic, at, foot);
    foot.s += step;
    ++foot.iterations;
  } while (std::abs(step) > step_tolerance && foot.iterations < most_iterations);
  take_along(step, foot);
}

// A foot this far away may belong to another part of the hole than the point.
bool far_from_axis(const HoleSegment& g, const Eigen::Vector3d& point, const Foot& foot) noexcept
{
  return (point - to_eigen(foot.centre)).squaredNorm() > 16.0 * g.radius * g.radius;
}

ClosestPoint closest(const HoleSegment& g, const Foot& foot, int segment) noexcept
{
  const one_lane::HoleNumbers hole{g.md,       g.length,          g.radius,  g.radius_change,
                                   g.friction, g.friction_change, g.section, g.section_change};
  const one_lane::Closest c = closest_of(hole, foot);
  ClosestPoint closest;
  closest.md = c.md;
  closest.centre = to_eigen(foot.centre);
  closest.tangent = to_eigen(c.tangent);
  closest.centre_slope = to_eigen(c.slope);
  closest.md_gradient = to_eigen(c.gradient);
  closest.radius = c.radius;
  closest.radius_slope = c.radius_slope;
  closest.friction = c.friction;
  closest.section = c.section;
  closest.segment = segment;
  closest.iterations = foot.iterations;
  return closest;
}
}  // namespace

const HoleSegment& Wellbore::segment(int i) const noexcept
{
  const int originals = original_count();
  if (i < originals) return original_->segments[static_cast<std::size_t>(i)];
  if (i < new_interval_index()) return drilled_[static_cast<std::size_t>(i - originals)].segment;
  return new_interval_;
}

const Box& Wellbore::box(int i) const noexcept
{
  const int originals = original_count();
  return i < originals ? original_->boxes[static_cast<std::size_t>(i)] : drilled_[static_cast<std::size_t>(i - originals)].box;
}

// The segment to go on with from segment i when the point's cross section is at s there: i itself to stay. The curve is smooth
// at permanent nodes. At its two kinks, the first node and P, one plane each decides for both sides: z = 0 and the fresh line's.
int Wellbore::neighbour(int i, double s, const Eigen::Vector3d& point) const noexcept
{
  constexpr double slack = 1e-9;
  const int fresh = new_interval_index();
  if (i == 0) return s > 0.0 ? 1 : 0;
  if (i == fresh) return s < 0.0 ? fresh - 1 : fresh;
  if (s < 0.5)
  {
    if (i == 1)
    {
      const HoleSegment& first = segment(1);
      const bool above = first_guess(segment(0), point) <= 0.0 && s * first.length <= 2.0 * first.radius;
      return above ? 0 : 1;
    }
    return s < -slack ? i - 1 : i;
  }
  if (i == fresh - 1) return first_guess(new_interval_, point) >= 0.0 ? fresh : i;
  return s > 1.0 + slack ? i + 1 : i;
}

int Wellbore::nearest_segment(const Eigen::Vector3d& point) const noexcept
{
  const int fresh = new_interval_index();
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](int i, double low, double high)
  {
    const HoleSegment& g = segment(i);
    Foot foot;
    foot.s = std::clamp(first_guess(g, point), low, high);
    refine(g, point, foot);
    const double distance2 = (point - g.centre(std::clamp(foot.s, low, high))).squaredNorm();
    if (distance2 < least)
    {
      least = distance2;
      nearest = i;
    }
  };
  consider(0, -std::numeric_limits<double>::infinity(), 0.0);
  consider(fresh, 0.0, std::numeric_limits<double>::infinity());
  for (int i = 1; i < fresh; ++i)
    if (box(i).squared_distance(point) < least) consider(i, 0.0, 1.0);
  return nearest;
}

ClosestPoint Wellbore::locate(const Eigen::Vector3d& point, int segment_hint) const noexcept
{
  bool searched = segment_hint < 0;
  int i = searched ? nearest_segment(point) : std::min(segment_hint, new_interval_index());
  Foot foot;
  for (int moves = 0;; ++moves)
  {
    const HoleSegment& g = segment(i);
    foot.s = first_guess(g, point);
    foot.iterations = 0;
    int next = i;
    if (moves < most_moves && (foot.s < -far_outside || foot.s > 1.0 + far_outside)) next = neighbour(i, foot.s, point);
    if (next == i)
    {
      refine(g, point, foot);
      next = neighbour(i, foot.s, point);
      const bool arrived = next == i;
      if (searched && (arrived || moves >= most_moves)) return closest(g, foot, i);
      if (arrived && !far_from_axis(g, point, foot)) return closest(g, foot, i);
      if (arrived) moves = most_moves;
    }
    i = next;
    if (moves >= most_moves && !searched)  // a hint from somewhere else in the hole
    {
      searched = true;
      moves = 0;
      i = nearest_segment(point);
    }
  }
}

const HoleSegment* Wellbore::smooth_segment(int i, const Eigen::Vector3d& point) const noexcept
{
  if (i < 1 || i > new_interval_index() - 2) return nullptr;
  const HoleSegment& g = segment(i);
  if (i > 1) return &g;
  const bool far_below = first_guess(g, point) * g.length > 4.0 * g.radius + 1.0;  // of the first node
  return far_below ? &g : nullptr;
}

double Wellbore::radius_near(const Eigen::Vector3d& point, int segment_hint) const noexcept
{
  if (segment_hint < 0) return locate(point, segment_hint).radius;
  const HoleSegment& g = segment(std::min(segment_hint, new_interval_index()));
  return g.radius + std::clamp(first_guess(g, point), 0.0, 1.0) * g.radius_change;
}

Eigen::Vector3d Wellbore::tangent_near(const Eigen::Vector3d& point, int segment_hint) const noexcept
{
  if (segment_hint < 0) return locate(point, segment_hint).tangent;
  const HoleSegment& g = segment(std::min(segment_hint, new_interval_index()));
  const double s = std::clamp(first_guess(g, point), 0.0, 1.0);
  return (g.c1 + s * (2.0 * g.c2 + 3.0 * s * g.c3)).normalized();
}

}  // namespace drill_rig_sim
