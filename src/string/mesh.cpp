// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/string/mesh.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "cuts.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
BeamSection section_of(const PartSpec& part, double length)
{
  const StiffnessSpec& given = part.stiffness;
  return given.axial > 0.0
             ? stiff_section(length, given.axial, given.bending, given.torsional, part.inner_diameter / part.outer_diameter)
             : tube_section(length, part.outer_diameter, part.inner_diameter, part.young_modulus, part.poisson_ratio);
}

MeshElement make_element(const PartSpec& part, int index, double lower, double upper, double mass)
{
  MeshElement e;
  const double length = upper - lower;
  e.section = section_of(part, length);
  e.linear_mass = mass / length;
  e.displaced = e.linear_mass / part.density;
  e.outer_area = 0.25 * pi * part.outer_diameter * part.outer_diameter;
  e.bore_area = 0.25 * pi * part.inner_diameter * part.inner_diameter;
  e.holds = e.bore_area * e.linear_mass / part.linear_mass;
  e.outer_diameter = part.outer_diameter;
  e.friction_radius = part.friction_radius;
  e.part = index;
  return e;
}

/// Half of an element's inertia to each end. The share of its mass that resists tilting is that of the cubic beam's consistent
/// mass after the diagonal scaling of Hinton, Rock and Zienkiewicz (1976): m L^2 / 78 at each end.
void lump(const MeshElement& e, const PartSpec& part, const MudSpec& mud, MeshNode& lower, MeshNode& upper)
{
  const double length = e.section.length;
  const double mass = e.linear_mass * length;
  const double inside = mud.added_mass * mud.density * e.bore_area * length;
  const double outside = mud.added_mass * mud.density * e.outer_area * length;
  const double square =
      0.25 * (part.outer_diameter * part.outer_diameter + part.inner_diameter * part.inner_diameter);  // ro^2 + ri^2
  const double polar = part.polar_inertia > 0.0 ? part.polar_inertia * mass / part.linear_mass : 0.5 * mass * square;
  for (MeshNode* node : {&lower, &upper})
  {
    node->mass += 0.5 * mass;
    node->mud_inside += 0.5 * inside;
    node->mud_outside += 0.5 * outside;
    node->diameter = (node->length * node->diameter + 0.5 * length * part.outer_diameter) / (node->length + 0.5 * length);
    node->length += 0.5 * length;
    node->spin_inertia += 0.5 * polar;
    node->tilt_inertia += 0.25 * polar + (mass + inside + outside) * length * length / 78.0;
  }
}

[[noreturn]] void refuse_rest(const PartSpec& part, double rest)
{
  std::ostringstream message;
  message << "string: part '" << part.name << "' fills up to the surface, but the parts below it leave only " << rest
          << " m; at least " << shortest_joint << " m are needed";
  throw std::runtime_error(message.str());
}

/// In the last part, what is above its uppermost joint as it was first built is broken out or added joint by joint.
Pairs pairs_in(const PartSpec& part, bool last, double lower, std::size_t joints, const ElementLengths& longest)
{
  if (!last) return {static_cast<int>(joints), 2};
  return {static_cast<int>(joint_lengths(part, longest.start_length - lower).size()) - 1, longest.stand};
}

/// Where the elements of all parts end, and where the parts begin and end.
std::vector<Cut> cut_string(const std::vector<PartSpec>& parts, const ElementLengths& longest, Mesh& mesh)
{
  std::vector<Cut> cuts;
  if (parts.front().bit->gauge_length > 0.0)
  {
    cuts.push_back(cut_gauge(*parts.front().bit));
    mesh.gauge_nodes = 2;
  }
  double top = parts.front().length;
  mesh.part_bottom.push_back(0.0);
  mesh.part_top.push_back(top);
  for (std::size_t p = 1; p < parts.size(); ++p)
  {
    const PartSpec& part = parts[p];
    const std::vector<double> lengths = joint_lengths(part, mesh.total_length - top);
    if (lengths.empty()) refuse_rest(part, mesh.total_length - top);
    mesh.part_bottom.push_back(top);
    cut_part(part, static_cast<int>(p), top, lengths, longest,
             pairs_in(part, p + 1 == parts.size(), top, lengths.size(), longest), cuts);
    for (double length : lengths) top += length;
    mesh.part_top.push_back(top);
    if (part.mwd) mesh.sensor_from_bit = mesh.part_bottom.back() + part.mwd->sensor_offset;
  }
  if (std::abs(top - mesh.total_length) <= 1e-6) return cuts;
  std::ostringstream message;
  message << "string: its parts are " << top << " m long, but bit and top drive are " << mesh.total_length
          << " m apart; give the last part 'joints: fill'";
  throw std::runtime_error(message.str());
}

/// The wall's law under a part; `guide`: gauge or blades.
ContactLaw law_under(const PartSpec& part, const ContactSpec& contact, bool guide)
{
  if (part.contact) return *part.contact;
  ContactLaw law = contact.law;
  if (guide) law.stiffness = std::max(law.stiffness, contact.assembly_stiffness);
  return law;
}

MeshNode bit_node(const PartSpec& bit, const ContactSpec& contact, const Mesh& mesh)
{
  MeshNode node;
  node.from_bit = mesh.bit_radius;
  node.contact_radius = mesh.bit_radius;
  node.contact = law_under(bit, contact, true);
  node.mass = bit.bit->mass;
  node.squeeze_film_damping = bit.bit->squeeze_film_damping;
  node.spin_inertia = node.tilt_inertia = 0.4 * bit.bit->mass * mesh.bit_radius * mesh.bit_radius;
  return node;
}

/// The element that ends at `cut`, on top of those that are there.
void add_element(const std::vector<PartSpec>& parts, const Cut& cut, const ContactSpec& contact, const MudSpec& mud, Mesh& mesh)
{
  const PartSpec& part = parts[cut.part];
  const double lower = mesh.nodes.back().from_bit;
  // the bit's own length carries no mass of the part above it
  const double mass = part.linear_mass * std::max(0.0, cut.from_bit - std::max(lower, parts.front().length));
  MeshElement element = make_element(part, cut.part, lower, cut.from_bit, mass);
  element.contact = law_under(part, contact, false);
  MeshNode node;
  node.from_bit = cut.from_bit;
  node.contact_radius = cut.contact_radius;
  const bool blades = part.stabilizer && !cut.joint_end && cut.contact_radius == 0.5 * part.stabilizer->blade_diameter;
  const bool sleeve =
      part.motor && part.motor->sleeve_diameter > 0.0 && std::abs(cut.from_bit - part.motor->bit_to_sleeve) < 1e-9;
  node.contact = law_under(part, contact, blades || sleeve);
  node.friction_radius = part.friction_radius;
  node.part = cut.part;
  node.joint = cut.joint;
  node.joint_end = cut.joint_end;
  if (blades) node.squeeze_film_damping = part.stabilizer->squeeze_film_damping;
  if (sleeve) node.squeeze_film_damping = StabilizerSpec().squeeze_film_damping;
  if (part.motor && part.motor->bend != 0.0 && std::abs(cut.from_bit - part.motor->bit_to_bend) < 1e-9)
  {
    mesh.bend_node = static_cast<int>(mesh.nodes.size());
    element.bend = part.motor->bend;
    element.upper_end = Eigen::Quaterniond(Eigen::AngleAxisd(part.motor->bend, Eigen::Vector3d::UnitZ()));
  }
  if (part.steerable && std::abs(cut.from_bit - part.steerable->place()) < 1e-9)
    (part.steerable->tilt > 0.0 ? mesh.pivot_node : mesh.pad_node) = static_cast<int>(mesh.nodes.size());
  lump(element, part, mud, mesh.nodes.back(), node);
  mesh.elements.push_back(element);
  mesh.nodes.push_back(node);
}

/// The pads' upper end touches as the gauge does, and half of the mud that they squeeze is there.
void put_gauge(const PartSpec& bit, const ContactSpec& contact, MeshNode& lower, MeshNode& upper)
{
  upper.contact = law_under(bit, contact, true);
  upper.friction_radius = 0.0;
  lower.squeeze_film_damping = upper.squeeze_film_damping = 0.5 * bit.bit->squeeze_film_damping;
}

/// A joint's end touches with the larger of the two ends that meet there; `above`: the part above it.
void widen(const PartSpec& above, MeshNode& node)
{
  const double radius = 0.5 * joint_end_diameter(above);
  if (!node.joint_end || radius <= node.contact_radius) return;
  node.contact_radius = radius;
  node.friction_radius = above.friction_radius;
}

void put_oscillators(const std::vector<PartSpec>& parts, Mesh& mesh)
{
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    if (parts[k].oscillation_force == 0.0) continue;
    const double middle = 0.5 * (mesh.part_bottom[k] + mesh.part_top[k]);
    const auto nearer = [middle](const MeshNode& a, const MeshNode& b)
    { return std::abs(a.from_bit - middle) < std::abs(b.from_bit - middle); };
    const auto nearest = std::min_element(mesh.nodes.begin(), mesh.nodes.end(), nearer);
    mesh.oscillators.push_back(
        {static_cast<int>(nearest - mesh.nodes.begin()), parts[k].oscillation_force, parts[k].oscillation_frequency});
  }
}

double bearing_radius(const PartSpec& part, const MeshNode& node)
{
  return part.pipe ? std::max(node.contact_radius, 0.5 * joint_end_diameter(part)) : node.contact_radius;
}
}  // namespace

Mesh build_mesh(const std::vector<PartSpec>& parts, const ContactSpec& contact, const MudSpec& mud, const ElementLengths& longest,
                double total_length)
{
  Mesh mesh;
  const PartSpec& bit = parts.front();
  mesh.total_length = total_length;
  mesh.bit_radius = 0.5 * bit.bit->diameter;
  mesh.bit_mass = bit.bit->mass;
  mesh.bit_displaced = bit.bit->mass / bit.density;
  const std::vector<Cut> cuts = cut_string(parts, longest, mesh);
  mesh.nodes.push_back(bit_node(bit, contact, mesh));
  for (const Cut& cut : cuts) add_element(parts, cut, contact, mud, mesh);
  if (mesh.gauge_nodes > 1) put_gauge(bit, contact, mesh.nodes[0], mesh.nodes[1]);
  for (std::size_t i = 1; i + 1 < mesh.nodes.size(); ++i) widen(parts[mesh.nodes[i + 1].part], mesh.nodes[i]);
  for (MeshNode& node : mesh.nodes) node.bearing_radius = bearing_radius(parts[node.part], node);
  put_oscillators(parts, mesh);
  return mesh;
}

}  // namespace drill_rig_sim
