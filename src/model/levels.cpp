// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/levels.h"

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/guides.h"
#include "drill_rig_sim/model/pointing.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
/// Stretch of an element as its nodes lie, whatever its length without tension [-].
double stretch_of(const Model& model, const State& state, std::size_t e) noexcept
{
  const MeshElement& element = model.mesh().elements[e];
  const NodeState &lower = state.nodes[e], &upper = state.nodes[e + 1];
  if (lower.guided && upper.guided) return guided_length(state, e) / element.section.length - 1.0;
  BeamPose pose{upper.position,
                lower.position,
                x_axis(upper.orientation),
                x_axis(lower.orientation),
                0.0,
                upper.orientation,
                lower.orientation,
                0.0};
  if (element.bend != 0.0) pose.upper_orientation = upper.orientation * element.upper_end;
  if (model.mesh().is_shaft(static_cast<int>(e))) pose.upper_orientation = leaning(upper.orientation, state.lean);
  pose.upper_normal = x_axis(pose.upper_orientation);
  BeamStrain strain;
  model.beam().forces(element.section, pose, BeamDamping(), Vector3d::Zero(), strain);
  return strain.stretch;
}

/// A place on the hole and the side of it where a node lies.
struct Side
{
  ClosestPoint closest;
  Vector3d outward;  ///< unit; zero in the middle
  Vector3d around;   ///< t x outward
};

Side side_of(const State& state, const NodeState& node) noexcept
{
  Side side;
  side.closest = state.well.locate(node.position, node.segment);
  Vector3d off = node.position - side.closest.centre;
  off -= side.closest.tangent * side.closest.tangent.dot(off);
  const double distance = off.norm();
  side.outward = distance > 1e-9 ? Vector3d(off / distance) : Vector3d(Vector3d::Zero());
  side.around = side.closest.tangent.cross(side.outward);
  return side;
}

/// `load`: normal force of its wall [N].
void make_free(const MeshNode& mesh, const State& state, double load, NodeState& node) noexcept
{
  const Side side = side_of(state, node);
  const double clearance = side.closest.radius - mesh.contact_radius;
  if (load > 0.0 && clearance > 0.0 && side.closest.md > 0.0 && mesh.contact_radius >= mesh.bearing_radius)
    node.position =
        side.closest.centre + (clearance + std::pow(load / mesh.contact.stiffness, 1.0 / mesh.contact.exponent)) * side.outward;
  node.bristle = node.bristle.x() * side.closest.tangent + node.bristle.y() * side.around;
  node.guided = false;
}

void make_guided(State& state, std::size_t i) noexcept
{
  NodeState& node = state.nodes[i];
  const Side side = side_of(state, node);
  node.bristle = Vector3d(node.bristle.dot(side.closest.tangent), node.bristle.dot(side.around), 0.0);
  node.guided = true;
  settle_in_hole(state, i);
}

void clear(SpanState& span) noexcept
{
  span.bristle.setZero();
  span.rest = 0.0;
}
}  // namespace

bool change_guided(const Model& model, const std::vector<unsigned char>& guided, const RigForces& forces, State& state) noexcept
{
  const auto changes = [&](std::size_t i) { return state.nodes[i].guided != (guided[i] != 0); };
  constexpr double changed = -1.0;  // what is to be measured anew is marked by its bristle's rest until then
  bool any = false;
  for (std::size_t e = 0; e < state.spans.size(); ++e)
    if (changes(e) || changes(e + 1))
    {
      state.spans[e].free_stretch -= stretch_of(model, state, e);
      state.spans[e].rest = changed;
      any = true;
    }
  if (!any) return false;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    if (!changes(i)) continue;
    const Vector3d before = state.nodes[i].position;
    if (guided[i])
      make_guided(state, i);
    else
      make_free(model.mesh().nodes[i], state, forces.contact[i], state.nodes[i]);
    for (HeldNode* held : {&state.stuck_point, &state.slips})
      if (static_cast<int>(i) == held->node) held->position += state.nodes[i].position - before;
  }
  for (std::size_t e = 0; e < state.spans.size(); ++e)
  {
    if (state.spans[e].rest != changed) continue;
    settle_span(state, e);
    state.spans[e].free_stretch += stretch_of(model, state, e);
    clear(state.spans[e]);
  }
  return true;
}

}  // namespace drill_rig_sim
