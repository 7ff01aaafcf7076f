// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/wall_loss.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace drill_rig_sim
{
namespace
{
constexpr double shallow = 0.05;                           // of the clearance
constexpr double equal_share = 0.05, equal_force = 500.0;  // [-], [N]

/// Whether a part's body may lose side forces: pipe is slender, the bit's wall is stiff.
bool may_lose(const PartSpec& part)
{
  return part.type != PartType::pipe && part.type != PartType::bit;
}

/// Deepest place for its clearance, of those that the stiffer wall would hold.
class Deepest
{
public:
  explicit Deepest(const Scene& scene) : scene_(scene) {}

  void look(int part, const ContactLaw& law, double force, double clearance, double from_bit)
  {
    if (force <= 0.0 || law.stiffness >= scene_.contact.assembly_stiffness ||
        !may_lose(scene_.string[static_cast<std::size_t>(part)]))
      return;
    const double depth = std::pow(force / law.stiffness, 1.0 / law.exponent);
    const double share = depth / std::max(clearance, 1e-6);
    if (share <= share_) return;
    share_ = share;
    loss.part = part;
    loss.depth = depth;
    loss.from_bit = from_bit;
  }
  bool deep() const { return share_ > shallow; }

  WallLoss loss;

private:
  const Scene& scene_;
  double share_ = 0.0;
};

Deepest deepest_of(const RigAtRest& rig)
{
  const Mesh& mesh = rig.model->mesh();
  const RigForces& forces = rig.statics.forces;
  Deepest deepest(rig.model->scene());
  const auto hole = [&rig](std::size_t node)
  { return rig.state.well.radius_near(rig.state.nodes[node].position, rig.state.nodes[node].segment); };
  for (std::size_t i = 0; i + 1 < mesh.nodes.size(); ++i)
    deepest.look(mesh.nodes[i].part, mesh.nodes[i].contact, forces.contact[i], hole(i) - mesh.nodes[i].contact_radius,
                 mesh.nodes[i].from_bit);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    deepest.look(mesh.elements[e].part, mesh.elements[e].contact, forces.span_contact[e],
                 hole(e) - 0.5 * mesh.elements[e].outer_diameter, mesh.middle(e));
  return deepest;
}

double sum_of_contacts(const RigForces& forces)
{
  return std::accumulate(forces.contact.begin(), forces.contact.end(), 0.0) +
         std::accumulate(forces.span_contact.begin(), forces.span_contact.end(), 0.0);
}

/// The wall under these bodies as it is under gauge and blades.
Scene with_stiff_wall(Scene scene)
{
  for (PartSpec& part : scene.string)
  {
    if (!may_lose(part)) continue;
    if (!part.contact) part.contact = scene.contact.law;
    part.contact->stiffness = std::max(part.contact->stiffness, scene.contact.assembly_stiffness);
  }
  return scene;
}

bool differ(double a, double b)
{
  return std::abs(a - b) > std::max(equal_force, equal_share * b);
}
}  // namespace

std::optional<WallLoss> wall_loss(const RigAtRest& rig)
{
  const Deepest deepest = deepest_of(rig);
  if (!deepest.deep()) return std::nullopt;
  WallLoss loss = deepest.loss;
  loss.side_force = rig.statics.forces.contact.front();
  loss.contact = sum_of_contacts(rig.statics.forces);
  try
  {
    const RigForces forces = build_at_rest(with_stiff_wall(rig.model->scene())).statics.forces;
    loss.stiff_side_force = forces.contact.front();
    loss.stiff_contact = sum_of_contacts(forces);
    loss.known = true;
  }
  catch (const std::runtime_error&)
  {
    return loss;
  }
  if (!differ(loss.side_force, loss.stiff_side_force) && !differ(loss.contact, loss.stiff_contact)) return std::nullopt;
  return loss;
}

}  // namespace drill_rig_sim
