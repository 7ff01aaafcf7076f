#include "drill_rig_sim/model/kernels/string_columns.h"

#include <algorithm>

#include "drill_rig_sim/model/workspace.h"

namespace drill_rig_sim
{
namespace
{
template <class Vector>
void put(NumberColumns& to, int kind, int i, const Vector& v) noexcept
{
  for (int k = 0; k < static_cast<int>(v.size()); ++k) to[kind + k][i] = v[k];
}

void take_node(const Model& model, int i, NumberColumns& to) noexcept
{
  const MeshNode& node = model.mesh().nodes[static_cast<std::size_t>(i)];
  const MudSpec& mud = model.scene().mud;
  to[node_column::mass][i] = node.mass + (i == model.top() ? model.scene().rig.hoisting.block_mass : 0.0);
  to[node_column::spin_inertia][i] = node.spin_inertia;
  to[node_column::tilt_inertia][i] = node.tilt_inertia;
  to[node_column::mud_across][i] = node.mud_across;
  to[node_column::mud_along][i] = node.mud_along - node.mud_across;
  to[node_column::mud_torsional][i] = node.mud_about;
  to[node_column::mud_quadratic][i] = node.length * lateral_drag(mud, node.diameter);
  to[node_column::contact_radius][i] = node.contact_radius;
}

void take_element(const MeshElement& element, int e, NumberColumns& to) noexcept
{
  const BeamSection& section = element.section;
  to[element_column::length][e] = section.length;
  to[element_column::axial][e] = section.axial;
  to[element_column::bending_near][e] = section.bending_near;
  to[element_column::bending_far][e] = section.bending_far;
  to[element_column::torsion][e] = section.torsion;
  put(to, element_column::upper_end, e, element.upper_end.coeffs());
  to[element_column::radius][e] = 0.5 * element.outer_diameter;
}
}  // namespace

StringColumns::StringColumns(const Model& model) : nodes(node_column::count, model.nodes()), elements(element_column::count, model.elements()),
    segments(static_cast<std::size_t>(model.nodes() + NumberColumns::room)), places(segments.size()),
    wall_places(static_cast<std::size_t>(model.nodes())), wall_numbers(wall_places.size())
{
  for (int i = 0; i < model.nodes(); ++i) take_node(model, i, nodes);
  for (int e = 0; e < model.elements(); ++e) take_element(model.mesh().elements[static_cast<std::size_t>(e)], e, elements);
  single_nodes.resize(static_cast<std::size_t>(model.nodes()));
  single_elements.resize(static_cast<std::size_t>(model.elements()));
  node_hints.resize(single_nodes.size());
  element_hints.resize(single_elements.size());
  for (int i = 0; i < model.nodes(); ++i)
    single_nodes[static_cast<std::size_t>(i)] =
        i == model.top() || i < model.mesh().gauge_nodes || model.mesh().nodes[static_cast<std::size_t>(i)].squeeze_film_damping > 0.0;
  for (std::size_t e = 0; e < single_elements.size(); ++e) single_elements[e] = model.mesh().elements[e].bend != 0.0 || model.mesh().is_shaft(static_cast<int>(e));
  double* straight = elements[element_column::upper_end + 3] + model.elements();
  std::fill(straight, straight + NumberColumns::room, 1.0);  // nor is there a bend behind the last
}

void StringColumns::take_stage(const Stage& stage) noexcept
{
  double *free = nodes[node_column::free], *immersed = nodes[node_column::immersed], *added = nodes[node_column::added_mass];
  double *x = elements[element_column::load], *y = elements[element_column::load + 1], *z = elements[element_column::load + 2];
  double* stretch = elements[element_column::free_stretch];
  const auto take_node = [&](std::size_t i)
  {
    free[i] = stage.any_guided && stage.guides[i].guided ? 0.0 : 1.0;
    immersed[i] = free[i] * stage.immersed[i];
    added[i] = free[i] * stage.added_mass[i];
  };
  const auto take_element = [&](std::size_t e)
  {
    x[e] = stage.load[e].x();
    y[e] = stage.load[e].y();
    z[e] = stage.load[e].z();
    stretch[e] = stage.free_stretch[e];
  };
  each_between(stage.guided_elements, static_cast<int>(stage.load.size()),
               [&](int first, int last)
               {
                 for (int e = first; e < last; ++e) take_element(static_cast<std::size_t>(e));
                 for (int i = first; i <= last; ++i) take_node(static_cast<std::size_t>(i));
               });
}

void StringColumns::take(const NodeMoves& node, int i) noexcept
{
  const Eigen::Vector3d rotating = node.rate.tail<3>();
  put(nodes, node_column::position, i, node.position);
  put(nodes, node_column::normal, i, node.normal);
  put(nodes, node_column::turning, i, Eigen::Vector3d(rotating + node.carried_spin * (node.normal - node.axis)));
  put(nodes, node_column::velocity, i, Eigen::Vector3d(node.rate.head<3>()));
  put(nodes, node_column::rotating, i, rotating);
  put(nodes, node_column::axis, i, node.axis);
  put(nodes, node_column::acceleration, i, node.acceleration);
  put(nodes, node_column::orientation, i, node.orientation.coeffs());
  nodes[node_column::carried_spin][i] = node.carried_spin;
  put(nodes, node_column::increment, i, node.increment);
}

}  // namespace drill_rig_sim
