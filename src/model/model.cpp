#include "drill_rig_sim/model/model.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "drill_rig_sim/contact/bit_torque.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
const BeamKind& beam_of(const Scene& scene)
{
  const BeamKind* kind = find_beam(scene.numerics.element);
  if (!kind) throw std::runtime_error("numerics.element: '" + scene.numerics.element + "' is not known");
  return *kind;
}
}  // namespace

Model::Model(const Scene& scene, Mesh mesh)
  : scene_(scene), mesh_(std::move(mesh)), beam_(beam_of(scene)), formation_(scene.formation)
{
  contact_.assign(mesh_.nodes.size(), scene.contact);
  for (std::size_t i = 0; i < contact_.size(); ++i) contact_[i].law = mesh_.nodes[i].contact;
  for (const PartSpec& part : scene_.string)
    if (part.type == PartType::mud_motor) motor_ = &part;
  bit_bristle_ = drill_rig_sim::bit_bristle_stiffness(bit().torque, bit().diameter);
}

double Model::element_weight(int e, double z_lower, double z_upper) const noexcept
{
  const MeshElement& element = mesh_.elements[static_cast<std::size_t>(e)];
  const double height = std::max(z_upper - z_lower, 1e-9);
  const double immersed = z_upper <= 0.0 ? 1.0 : std::clamp(-z_lower / height, 0.0, 1.0);
  return standard_gravity * (element.linear_mass - scene_.mud.density * element.displaced * immersed) * element.section.length;
}

}  // namespace drill_rig_sim
