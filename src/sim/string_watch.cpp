// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/string_watch.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr double hanging = 1.94;  // [-]

void take(double share, double from_bit, LoadShare& most) noexcept
{
  if (share > most.share) most = {share, from_bit};
}

/// Below the rotary table; of a string that may not be full as if it were empty, when its limit is least.
double vertical_buckling_load(const Model& model, std::size_t e) noexcept
{
  const BeamSection& section = model.mesh().elements[e].section;
  const double bore_top = model.scene().mud.fill.empty() ? full_bore : 0.0;
  const double weight = model.element_weight(static_cast<int>(e), -section.length, 0.0, bore_top) / section.length;
  return weight > 0.0 ? hanging * std::cbrt(section.bending * weight * weight) : 0.0;
}
}  // namespace

StringWatch::StringWatch(const Model& model)
{
  const Mesh& mesh = model.mesh();
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const PartSpec& part = model.scene().string[static_cast<std::size_t>(mesh.elements[e].part)];
    const BeamSection& section = mesh.elements[e].section;
    const double bending = 2.0 * section.bending / (part.young_modulus * part.outer_diameter);  // I over the outer radius
    const double yield = part.yield_strength, area = section.axial / part.young_modulus;
    strength_.push_back({1.0 / (area * yield), 1.0 / (bending * yield), std::sqrt(3.0) / (2.0 * bending * yield),
                         part.make_up_torque > 0.0 ? 1.0 / part.make_up_torque : 0.0, mesh.middle(e),
                         vertical_buckling_load(model, e)});
  }
}

double buckling_share(const Model& model, const State& state, std::size_t e, double tension) noexcept
{
  const MeshElement& element = model.mesh().elements[e];
  const NodeState &lower = state.nodes[e], &upper = state.nodes[e + 1];
  if (tension >= 0.0 || upper.position.z() > 0.0) return 0.0;
  const double stiffness = element.section.bending;
  const double weight =
      model.element_weight(static_cast<int>(e), lower.position.z(), upper.position.z(), state.hydraulics.bore_top) /
      element.section.length;
  if (element.linear_mass <= 0.0) return 0.0;  // within the bit's own length
  const double clearance = state.well.radius_near(lower.position, lower.segment) - 0.5 * element.outer_diameter;
  if (clearance <= 0.0) return 0.0;
  const Vector3d way = upper.position - lower.position;
  const double length = way.norm();
  const Vector3d up = way / length;
  const Vector3d bend =
      (state.well.tangent_near(lower.position, lower.segment) - state.well.tangent_near(upper.position, upper.segment)) / length;
  const Vector3d pressed = weight * (up * up.z() - Vector3d::UnitZ()) + tension * bend;  // against the wall [N/m]
  const double lying = 2.0 * std::sqrt(stiffness * pressed.norm() / clearance);
  const double hanging_cubed = hanging * hanging * hanging * stiffness * weight * weight;
  return -tension / (lying * lying * lying > hanging_cubed ? lying : std::cbrt(hanging_cubed));  // a cube's root is dear
}

BuckledPipe buckled_pipe(const Model& model, const State& state, const RigForces& forces) noexcept
{
  const Mesh& mesh = model.mesh();
  BuckledPipe out;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const double share = buckling_share(model, state, e, forces.tension[e]), length = mesh.elements[e].section.length;
    if (share <= 1.0) continue;
    if (out.length == 0.0) out.from_bit = mesh.nodes[e].from_bit;
    out.to = mesh.nodes[e + 1].from_bit;
    out.length += length;
    if (share > helical_share) out.helical += length;
  }
  return out;
}

StringLoads StringWatch::look(const Model& model, const State& state, const RigForces& forces) const noexcept
{
  StringLoads out;
  out.pull_to_yield = HUGE_VAL;
  for (std::size_t e = 0; e < strength_.size(); ++e)
  {
    const Strength& s = strength_[e];
    const double tension = forces.tension[e], torque = std::abs(forces.torque[e]), shear = s.by_torque * torque;
    const double bent = s.by_moment * std::max(forces.bending_moment[e], forces.bending_moment[e + 1]);
    const double axial = s.by_tension * std::abs(tension) + bent, borne = std::sqrt(std::max(1.0 - shear * shear, 0.0));
    out.pull_to_yield = std::min(out.pull_to_yield, (borne - bent) / s.by_tension - tension);
    take(axial * axial + shear * shear, s.from_bit, out.stress);
    take(s.by_make_up * torque, s.from_bit, out.torque);
    if (tension < 0.0 && -tension > out.buckling.share * s.least_buckling)
      take(buckling_share(model, state, e, tension), s.from_bit, out.buckling);
  }
  out.stress.share = std::sqrt(out.stress.share);
  return out;
}

}  // namespace drill_rig_sim
