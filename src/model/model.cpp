// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/model.h"

#include <algorithm>
#include <utility>

#include "drill_rig_sim/contact/bit_torque.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/drive_tuning.h"
#include "drill_rig_sim/scene/scene_mesh.h"

namespace drill_rig_sim
{
namespace
{
std::vector<FormationLayer> rings_of(const Scene& scene)
{
  const BitSpec& bit = *scene.string.front().bit;
  const bool by_width = traits_of(bit.torque.model).drag;
  std::vector<FormationLayer> layers = scene.formation;
  for (FormationLayer& layer : layers) layer = ring_of(layer, scene.well.pilot_diameter / bit.diameter, by_width);
  return layers;
}
}  // namespace

double immersed_share(double z_lower, double z_upper) noexcept
{
  const double height = std::max(z_upper - z_lower, 1e-9);
  return z_upper <= 0.0 ? 1.0 : std::clamp(-z_lower / height, 0.0, 1.0);
}

Model::Model(const Scene& scene, Mesh mesh)
    : scene_(scene),
      mesh_(std::move(mesh)),
      beam_(find_beam(scene.numerics.element)),
      kernel_(resolved(scene.numerics.kernel)),
      formation_(scene.formation),
      ring_(rings_of(scene)),
      pilot_(scene.well),
      friction_(scene.contact, scene.well.sections)
{
  for (const MeshNode& node : mesh_.nodes)
    contact_.push_back(wall_law(scene.contact, node.contact, node.mass, node.friction_radius));
  for (const MeshElement& element : mesh_.elements)
    span_contact_.push_back(
        wall_law(scene.contact, element.contact, element.linear_mass * element.section.length, element.friction_radius));
  for (int e = 0; e < elements(); ++e)
  {
    const double top =
        mesh_.nodes[static_cast<std::size_t>(e)].from_bit + mesh_.elements[static_cast<std::size_t>(e)].section.length;
    wet_.push_back({top, partly_wet_weight(e, -1.0, 0.0, full_bore)});
  }
  for (const PartSpec& part : scene_.string)
  {
    if (part.motor) motor_ = &*part.motor;
    if (part.steerable) steerable_ = &*part.steerable;
  }
  mud_ = mud_circuit(scene_, mesh_);
  if (scene_.cuttings)
    cuttings_ = CuttingsFluid{curve_of(*scene_.rheology, scene_.mud.viscosity), scene_.mud.density, *scene_.cuttings};
  if (scene_.temperature) heat_ = HeatMud{*scene_.temperature, rock_grid(*scene_.temperature), scene_.mud.density};
  turn_limit_ = drill_rig_sim::turn_limit(mesh_);
  scene_.rig.top_drive = tuned(scene_.rig.top_drive, mesh_);
  bit_bristle_ = drill_rig_sim::bit_bristle_stiffness(bit().torque, bit().diameter);
}

double Model::partly_wet_weight(int e, double z_lower, double z_upper, double bore_top) const noexcept
{
  const MeshElement& element = mesh_.elements[static_cast<std::size_t>(e)];
  const double immersed = immersed_share(z_lower, z_upper);
  const double full =
      std::clamp((bore_top - mesh_.nodes[static_cast<std::size_t>(e)].from_bit) / element.section.length, 0.0, 1.0);
  const double displaced = element.displaced * immersed + element.holds * std::max(0.0, immersed - full);
  return standard_gravity * (element.linear_mass - scene_.mud.density * displaced) * element.section.length;
}

}  // namespace drill_rig_sim
