// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/assembly_fit.h"

#include <cstdio>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/rig_forces.h"

namespace drill_rig_sim
{
std::optional<TightAssembly> tight_assembly(const Model& model, const RigForces& at_rest) noexcept
{
  const MotorSpec* motor = model.motor();
  if (!motor || motor->bend == 0.0) return std::nullopt;
  const Mesh& mesh = model.mesh();
  const Scene& scene = model.scene();
  TightAssembly out;
  out.side_force = at_rest.contact.front();
  out.turn = model.turn_limit().curvature;
  out.weight = standard_gravity * mesh.bit_mass * (1.0 - scene.mud.density / scene.string.front().density);
  for (const MeshElement& element : mesh.elements)
    if (scene.string[static_cast<std::size_t>(element.part)].motor)
      out.weight += standard_gravity * (element.linear_mass - scene.mud.density * element.displaced) * element.section.length;
  if (out.side_force <= most_of_weight * out.weight) return std::nullopt;
  return out;
}

std::string text_of(const TightAssembly& assembly)
{
  char text[320];
  std::snprintf(text, sizeof text,
                "the bent motor does not fit into its hole: its bit presses on the wall with %.1f kN, %.1f times the weight of "
                "bit and motor."
                " Slides may stop, and the hole turns by up to %.0f deg/30 m; use a smaller bend_deg or sleeve_diameter",
                assembly.side_force / 1e3, assembly.side_force / assembly.weight, 30.0 * assembly.turn / degree);
  return text;
}

}  // namespace drill_rig_sim
