#include "drill_rig_sim/model/guides.h"

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/mast.h"
#include "drill_rig_sim/model/stage.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr double kSettles = 0.5;     // over this time a guided node changes sides [s]
constexpr double kAtOnce = 0.5;      // and so much of it in each step of statics
constexpr double kPressed = 50.0;    // a load that presses it nearly to the wall [N]

bool guided_pair(const State& state, std::size_t lower) noexcept
{
  return state.nodes[lower].guided && state.nodes[lower + 1].guided;
}

bool joined(const State& state, std::size_t i) noexcept
{
  const std::size_t top = state.nodes.size() - 1;
  return i == 0 || i == top || !state.nodes[i - 1].guided || !state.nodes[i + 1].guided || static_cast<int>(i) == state.stuck_point.node;
}

Vector3d across(const Vector3d& tangent, const Vector3d& v) noexcept
{
  return v - tangent * tangent.dot(v);
}

/// The part across a guide's hole of the direction to another's.
Vector3d direction_across(const Guide& from, const Guide& to) noexcept
{
  return across(from.tangent, (to.centre - from.centre).normalized());
}

void find_guide(const Model& model, const State& state, std::size_t i, Guide& guide) noexcept
{
  const NodeState& node = state.nodes[i];
  const MeshNode& mesh = model.mesh().nodes[i];
  ClosestPoint closest = state.well.locate(node.position, node.segment);
  open_mast(closest);
  guide.side = across(closest.tangent, node.position - closest.centre);
  guide.tangent = closest.tangent;
  guide.centre = closest.centre;
  guide.md = closest.md;
  guide.friction = closest.md > 0.0 ? closest.friction : 0.0;
  guide.lever = mesh.friction_radius > 0.0 ? mesh.friction_radius : mesh.bearing_radius;
  guide.clearance = std::max(0.0, closest.radius - mesh.bearing_radius);
  guide.law = model.contact(static_cast<int>(i), closest, node.rest);
  guide.held = guide.law.tangential_stiffness * node.bristle.y();
  guide.joined = joined(state, i);
}

/// w by the change of the tangent towards the next guided node.
Vector3d turn_between(const Guide& a, const Guide& b) noexcept
{
  const double length = a.md - b.md;
  return std::abs(length) > 1e-6 ? Vector3d(a.tangent.cross(a.tangent - b.tangent) / length) : Vector3d(Vector3d::Zero());
}

/// `axis`: of the hole's axis; `chord`: between its two ends; `sides`: how far those of the string are apart beyond that.
double length_along(double axis, const Vector3d& chord, const Vector3d& sides) noexcept
{
  return axis + (chord + sides).norm() - chord.norm();
}

void reduce(const Stage& stage, double* b) noexcept
{
  for (std::size_t i = 0; i < stage.guides.size(); ++i)
  {
    const Guide& guide = stage.guides[i];
    if (!guide.guided) continue;
    double* at = b + 6 * i;
    const double along = guide.tangent.dot(Eigen::Map<const Vector3d>(at)), about = guide.tangent.dot(Eigen::Map<const Vector3d>(at + 3));
    at[0] = along;
    at[1] = about;
    at[2] = at[3] = at[4] = at[5] = 0.0;
  }
}

void expand(const Stage& stage, double* b) noexcept
{
  for (std::size_t i = 0; i < stage.guides.size(); ++i)
  {
    const Guide& guide = stage.guides[i];
    if (!guide.guided) continue;
    double* at = b + 6 * i;
    const double along = at[0], about = at[1];
    Eigen::Map<Vector3d> place{at};
    place = along * guide.tangent;
    Eigen::Map<Vector3d>(at + 3) = along * guide.turn + about * guide.tangent;
  }
}
}  // namespace

double length_between(const ClosestPoint& lower, const ClosestPoint& upper, const Vector3d& lower_side, const Vector3d& upper_side) noexcept
{
  return length_along(lower.md - upper.md, lower.centre - upper.centre, lower_side - upper_side);
}

void find_guides(const Model& model, const State& state, Stage& stage) noexcept
{
  stage.any_guided = false;
  const std::size_t n = state.nodes.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    Guide& guide = stage.guides[i];
    guide.guided = state.nodes[i].guided;
    guide.weight = guide.above = guide.below = Vector3d::Zero();
    if (!guide.guided) continue;
    stage.any_guided = true;
    find_guide(model, state, i, guide);
    stage.normal[i] = guide.tangent;
  }
  if (!stage.any_guided) return;
  for (std::size_t e = 0; e + 1 < n; ++e)
  {
    GuidedSpan& span = stage.guided_spans[e];
    span.guided = guided_pair(state, e);
    if (!span.guided) continue;
    Guide &lower = stage.guides[e], &upper = stage.guides[e + 1];
    const double length = length_along(lower.md - upper.md, lower.centre - upper.centre, lower.side - upper.side);
    span.stretch = length / model.mesh().elements[e].section.length - 1.0 - stage.free_stretch[e];
    span.twist = twist_between(state.nodes[e + 1].orientation, state.nodes[e].orientation);
    upper.turn = lower.turn = turn_between(lower, upper);
    lower.above = direction_across(lower, upper);
    upper.below = direction_across(upper, lower);
    lower.weight += 0.5 * stage.load[e];
    upper.weight += 0.5 * stage.load[e];
  }
}

bool solve_increment(const Stage& stage, BlockTridiagonal& tangent, double* b) noexcept
{
  if (!stage.any_guided) return tangent.solve(b);
  reduce(stage, b);
  if (!tangent.solve(b)) return false;
  expand(stage, b);
  return true;
}

void solve_increment_again(const Stage& stage, const BlockTridiagonal& tangent, double* b) noexcept
{
  if (!stage.any_guided) return tangent.solve_again(b);
  reduce(stage, b);
  tangent.solve_again(b);
  expand(stage, b);
}

void put_on_hole(const Stage& stage, const std::vector<Vector3d>& lean, double time, State& state) noexcept
{
  if (!stage.any_guided) return;
  const double follows = time > 0.0 ? -std::expm1(-time / kSettles) : kAtOnce;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const Guide& guide = stage.guides[i];
    if (!guide.guided) continue;
    NodeState& node = state.nodes[i];
    const ClosestPoint closest = state.well.locate(node.position, node.segment);
    const Vector3d load = across(closest.tangent, lean[i]);
    const Vector3d target = (guide.clearance / (kPressed + load.norm())) * load;
    const Vector3d side = across(closest.tangent, node.position - closest.centre);
    node.position = closest.centre + side + follows * (target - side);
    node.segment = closest.segment;
    node.orientation = (Eigen::Quaterniond::FromTwoVectors(x_axis(node.orientation), closest.tangent) * node.orientation).normalized();
    node.rate.velocity = closest.tangent * guide.tangent.dot(node.rate.velocity);
    node.rate.tilt = across(closest.tangent, node.rate.tilt);
  }
}

}  // namespace drill_rig_sim
