// SPDX-License-Identifier: BSD-3-Clause
#include "placed_string.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/guides.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
/// Nodes along the hole, resting on its low side where it is inclined; sections twisted as the guess says, y axes at the
/// toolface. `stretch`: how far each node is from its unstretched place, away from the bit [m]; nodes farther than `free_length`
/// above the bit's face are guided [m].
void place_nodes(const Mesh& mesh, const Wellbore& well, double depth, const Guess& guess, const std::vector<double>& stretch,
                 double free_length, State& state)
{
  state.nodes.assign(mesh.nodes.size(), NodeState());
  state.spans.assign(mesh.elements.size(), SpanState());
  const WellNode bottom = well.at(depth - mesh.nodes[0].from_bit);
  const Vector3d up = toolface_side(bottom.tangent, well.at(depth - mesh.nodes[toolface_node(mesh)].from_bit).tangent);
  Matrix3d axes;
  axes.col(0) = bottom.tangent;
  axes.col(1) = up * std::cos(guess.toolface) + bottom.tangent.cross(up) * std::sin(guess.toolface);
  axes.col(2) = axes.col(0).cross(axes.col(1));
  Quaterniond q(axes);
  const std::vector<double> compliance = torsional_compliances(mesh);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
  {
    const double md = depth - mesh.nodes[i].from_bit - stretch[i];
    const WellNode p = well.at(md);
    q = pointed_along(q, p.tangent);
    state.nodes[i].orientation = rotation_from_vector(guess.twist * compliance[i] / compliance.back() * p.tangent) * q;
    state.nodes[i].position = p.position;
    state.nodes[i].guided = mesh.nodes[i].from_bit > free_length;
    if (md <= 0.0) continue;
    const double gap = p.radius - mesh.nodes[i].contact_radius;
    const double inclined = p.tangent.head<2>().norm();  // sin I
    if (gap > 0.0 && inclined > 1e-3) state.nodes[i].position -= std::min(1.0, 20.0 * inclined) * gap * high_side(p.tangent);
  }
}

/// Moves the top node to the block's height over the well's centre, and points it down.
void hang_on_block(const Scene& scene, State& state)
{
  NodeState& top = state.nodes.back();
  top.position = Vector3d(0.0, 0.0, scene.start.block_height);
  top.orientation = pointed_along(top.orientation, -Vector3d::UnitZ());
}

/// What an element whose upper end is at measured depth `depth` pulls along its hole, in mud, a string empty inside down to
/// `level` [N].
double pull_along_hole(const MeshElement& e, const Scene& scene, const Wellbore& well, double depth, double level)
{
  const double empty = std::clamp((level - depth) / e.section.length, 0.0, 1.0);
  return standard_gravity * (e.linear_mass - scene.mud.density * (e.displaced + empty * e.holds)) * e.section.length *
         -well.at(depth).tangent.z();
}

}  // namespace

std::size_t toolface_node(const Mesh& mesh) noexcept
{
  return static_cast<std::size_t>(std::max(0, mesh.bend_node));
}

std::vector<double> torsional_compliances(const Mesh& mesh)
{
  std::vector<double> compliance(mesh.nodes.size(), 0.0);
  for (std::size_t e = toolface_node(mesh); e < mesh.elements.size(); ++e)
    compliance[e + 1] = compliance[e] + 1.0 / mesh.elements[e].section.torsion;
  return compliance;
}

std::vector<double> estimated_stretch(const Mesh& mesh, const Scene& scene, const Wellbore& well, double depth)
{
  const double level = fill_level(scene.mud, depth);
  double load = 0.0;
  std::vector<double> stretch{0.0};
  for (const MeshElement& e : mesh.elements)
  {
    depth -= e.section.length;
    const double weight = pull_along_hole(e, scene, well, depth, level);
    stretch.push_back(stretch.back() + (load + 0.5 * weight) * e.section.length / e.section.axial);
    load += weight;
  }
  return stretch;
}

double string_pull(const Scene& scene, const Mesh& mesh, const Wellbore& well, double depth)
{
  double pull = standard_gravity * mesh.bit_mass;
  const double level = fill_level(scene.mud, depth);
  for (const MeshElement& e : mesh.elements) pull += pull_along_hole(e, scene, well, depth -= e.section.length, level);
  return pull;
}

void place_string(const Mesh& mesh, const Scene& scene, const Wellbore& well, double depth, const Guess& guess, State& state)
{
  // stretched as it will be: the way to the equilibrium goes in increments of 2 cm
  place_nodes(mesh, well, depth, guess, estimated_stretch(mesh, scene, well, depth), free_length(scene), state);
  hang_on_block(scene, state);
  settle_guided(state);
}

void turn_string(const Mesh& mesh, const Guess& from, const Guess& to, State& state)
{
  const std::vector<double> compliance = torsional_compliances(mesh);
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    Quaterniond& q = state.nodes[i].orientation;
    const double turned = to.toolface - from.toolface + (to.twist - from.twist) * compliance[i] / compliance.back();
    q = rotation_from_vector(turned * x_axis(q)) * q;
  }
}

}  // namespace drill_rig_sim
