// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/string/lower_body.h"

#include <algorithm>
#include <limits>

namespace drill_rig_sim
{
namespace
{
/// From the bit's middle to the upper end of the stiff body [m].
double length_of(const Mesh& mesh) noexcept
{
  double end = 2.0 * mesh.bit_radius * stiff_diameters;
  for (const int node : {mesh.bend_node, mesh.pivot_node})
    if (node > 0) end = std::min(end, mesh.nodes[static_cast<std::size_t>(node)].from_bit - mesh.bit_radius);
  return end;
}

/// Of the body of the element in which a place lies, `above` the bit's middle [m].
double body_clearance(const Mesh& mesh, double above) noexcept
{
  std::size_t e = 0;
  while (e + 1 < mesh.elements.size() && mesh.nodes[e + 1].from_bit - mesh.bit_radius < above) ++e;
  return mesh.bit_radius - 0.5 * mesh.elements[e].outer_diameter;
}
}  // namespace

TurnLimit turn_limit(const Mesh& mesh) noexcept
{
  TurnLimit limit{length_of(mesh), std::numeric_limits<double>::infinity()};
  const double end = limit.length, clearance_at_end = body_clearance(mesh, end);
  const auto take = [&](double above, double clearance)
  {
    if (above <= 0.0 || above >= end) return;
    const double curvature = 2.0 * (std::max(0.0, clearance) + clearance_at_end * above / end) / (above * (end - above));
    limit.curvature = std::min(limit.curvature, curvature);
  };
  take(0.5 * end, body_clearance(mesh, 0.5 * end));
  for (const MeshNode& node : mesh.nodes)
  {
    if (node.from_bit - mesh.bit_radius >= end) break;
    take(node.from_bit - mesh.bit_radius, mesh.bit_radius - node.contact_radius);
  }
  return limit;
}

}  // namespace drill_rig_sim
