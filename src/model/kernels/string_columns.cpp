// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/kernels/string_columns.h"

#include "drill_rig_sim/model/workspace.h"

namespace drill_rig_sim
{
namespace
{
void take_node(const Model& model, int i, NodeColumns& to) noexcept
{
  const MeshNode& node = model.mesh().nodes[static_cast<std::size_t>(i)];
  const MudSpec& mud = model.scene().mud;
  to.mass[i] = node.mass + (i == model.top() ? model.scene().rig.hoisting.block_mass : 0.0);
  to.spin_inertia[i] = node.spin_inertia;
  to.tilt_inertia[i] = node.tilt_inertia;
  to.mud_across[i] = node.mud_across;
  to.mud_along[i] = node.mud_along - node.mud_across;
  to.mud_about[i] = node.mud_about;
  to.mud_quadratic[i] = node.length * lateral_drag(mud, node.diameter);
  to.contact_radius[i] = node.contact_radius;
}

void take_element(const MeshElement& element, int e, ElementColumns& to) noexcept
{
  const BeamSection& section = element.section;
  to.length[e] = section.length;
  to.axial[e] = section.axial;
  to.bending_near[e] = section.bending_near;
  to.bending_far[e] = section.bending_far;
  to.torsion[e] = section.torsion;
  to.upper_end.set(e, element.upper_end.coeffs());
  to.radius[e] = 0.5 * element.outer_diameter;
}
}  // namespace

void HoleColumns::take(std::size_t i, const HoleSegment* segment) noexcept
{
  held[i] = segment;
  if (!segment) return;
  const HoleSegment& from = *segment;
  c0.set(i, from.c0);
  c1.set(i, from.c1);
  c2.set(i, from.c2);
  c3.set(i, from.c3);
  chord.set(i, from.chord);
  md[i] = from.md;
  length[i] = from.length;
  radius[i] = from.radius;
  radius_change[i] = from.radius_change;
  friction[i] = from.friction;
  friction_change[i] = from.friction_change;
  section[i] = from.section;
  section_change[i] = from.section_change;
}

StringColumns::StringColumns(const Model& model)
    : beside(static_cast<std::size_t>(model.nodes())),
      places(beside.size() + Column::room),
      wall_places(static_cast<std::size_t>(model.nodes())),
      wall_laws(wall_places.size())
{
  const Mesh& mesh = model.mesh();
  ColumnSizes::resize(nodes, mesh.nodes.size());
  ColumnSizes::resize(elements, mesh.elements.size());
  for (HoleColumns* hole : {&node_holes, &element_holes})
  {
    ColumnSizes::resize(*hole, mesh.nodes.size());
    hole->held.resize(mesh.nodes.size());
  }
  for (int i = 0; i < model.nodes(); ++i) take_node(model, i, nodes);
  for (int e = 0; e < model.elements(); ++e) take_element(mesh.elements[static_cast<std::size_t>(e)], e, elements);
  single_nodes.resize(mesh.nodes.size());
  single_elements.resize(mesh.elements.size());
  node_hints.resize(single_nodes.size());
  element_hints.resize(single_elements.size());
  for (int i = 0; i < model.nodes(); ++i)
    single_nodes[static_cast<std::size_t>(i)] =
        i == model.top() || i < mesh.gauge_nodes || mesh.nodes[static_cast<std::size_t>(i)].squeeze_film_damping > 0.0;
  for (std::size_t e = 0; e < single_elements.size(); ++e)
    single_elements[e] = mesh.elements[e].bend != 0.0 || mesh.is_shaft(static_cast<int>(e));
  for (int k = 0; k < Column::room; ++k)
    elements.upper_end.part[3][model.elements() + k] = 1.0;  // nor is there a bend behind the last
}

void StringColumns::take(const NodeMotion& node, int i) noexcept
{
  nodes.position.set(i, node.position);
  nodes.normal.set(i, node.normal);
  nodes.turning.set(i, node.rate.tail<3>() + node.carried_spin * (node.normal - node.axis));
  nodes.axis.set(i, node.axis);
  nodes.orientation.set(i, node.orientation.coeffs());
  nodes.carried_spin[i] = node.carried_spin;
  nodes.increment.set(i, node.increment);
  nodes.rate.set(i, node.rate);
  nodes.acceleration.set(i, node.acceleration);
}

}  // namespace drill_rig_sim
