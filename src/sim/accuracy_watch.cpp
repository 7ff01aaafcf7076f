// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/accuracy_watch.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/extend_hole.h"
#include "drill_rig_sim/sim/string_watch.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::uint64_t every = 10;       // frames
constexpr double stays = 10.0;            // [s]
constexpr double most_confined = 0.8;     // of the critical buckling load
constexpr double most_twist = 1.0;        // [rad]
constexpr double least_clearance = 2e-3;  // [m]
constexpr double stiffer_load = 1.5;      // force on a stiffer wall under pipe, over that on the soft one: a margin
constexpr double most_slant = 10.0 * degree;

/// By F = k d^e, with the depth d of the warning's limit. A stiff body in a narrow hole presses harder the less the wall gives
/// way: it needs the wall of gauge and blades [N/m^e].
double stiff_enough(const Scene& scene, const MeshNode& node, double force, double clearance)
{
  const double by_force = stiffer_load * force / std::pow(std::max(clearance, least_clearance), node.contact.exponent);
  const bool is_slender = scene.string[static_cast<std::size_t>(node.part)].type == PartType::pipe;
  return is_slender ? by_force : std::max(by_force, scene.contact.assembly_stiffness);
}
}  // namespace

void watch_model(const Model& model, const State& state, const RigForces& forces, double duration,
                 AccuracyMemory& memory) noexcept
{
  memory.stands_for = std::max(0.0, memory.stands_for - duration);
  if (memory.stands_for == 0.0) memory.report = AccuracyReport();
  if (memory.frames++ % every != 0) return;
  AccuracyReport found = doubt_of_string(model, state, forces);
  if (found.doubt == AccuracyDoubt::none) found = doubt_of_turn(model, state, forces);
  if (found.doubt == AccuracyDoubt::none) found = doubt_of_hole(state);
  if (found.doubt == AccuracyDoubt::none) found = doubt_of_level(model.scene(), state);
  if (found.doubt == AccuracyDoubt::none) return;
  memory.report = found;
  memory.stands_for = stays;
}

AccuracyReport doubt_of_level(const Scene& scene, const State& state) noexcept
{
  constexpr unsigned of_free_nodes = need_direction | need_contact | need_buckling;
  constexpr unsigned of_waves = need_torque | need_bit_speed;
  const unsigned no_bending = state.nodes.front().guided ? of_free_nodes : 0u,
                 no_waves = scene.numerics.level == Level::rigid ? of_waves : 0u;
  const unsigned left_out = scene.needs & (no_bending | no_waves);
  return left_out ? AccuracyReport{AccuracyDoubt::level, static_cast<double>(left_out), 0.0, 0.0, 0.0} : AccuracyReport();
}

AccuracyReport doubt_of_hole(const State& state) noexcept
{
  const double slant = std::acos(std::clamp(-state.well.node(0).tangent.z(), -1.0, 1.0));
  return slant > most_slant ? AccuracyReport{AccuracyDoubt::slant, slant, 0.0, 0.0, 0.0} : AccuracyReport();
}

AccuracyReport doubt_of_turn(const Model& model, const State& state, const RigForces& forces) noexcept
{
  const double turn = refused_turn(model, state, forces);
  return turn > 0.0 ? AccuracyReport{AccuracyDoubt::turn, turn, 0.0, 0.0, model.turn_limit().curvature} : AccuracyReport();
}

AccuracyReport doubt_of_string(const Model& model, const State& state, const RigForces& forces) noexcept
{
  AccuracyReport report;
  const Mesh& mesh = model.mesh();
  const auto take = [&report](AccuracyDoubt doubt, double measure, double from_bit, double length, double allowed = 0.0)
  {
    const bool before = report.doubt == AccuracyDoubt::none || doubt < report.doubt;
    if (before || (doubt == report.doubt && measure > report.measure)) report = {doubt, measure, from_bit, length, allowed};
  };
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const BeamSection& s = mesh.elements[e].section;
    const double share = -forces.tension[e] * s.length * s.length / (0.5 * pi * pi * s.bending);
    const double twist = std::abs(forces.torque[e]) / s.torsion;
    const bool guided = state.nodes[e].guided && state.nodes[e + 1].guided;
    const double buckles = guided ? buckling_share(model, state, e, forces.tension[e]) : 0.0;
    if (buckles > most_confined) take(AccuracyDoubt::confined, buckles, mesh.middle(e), s.length);
    if (share > 1.0 && !guided) take(AccuracyDoubt::compression, share, mesh.middle(e), s.length);
    if (twist > most_twist) take(AccuracyDoubt::twist, twist, mesh.middle(e), s.length);
  }
  for (int i = 0; i < model.top(); ++i)
  {
    const MeshNode& node = mesh.nodes[static_cast<std::size_t>(i)];
    const double force = forces.contact[static_cast<std::size_t>(i)];
    if (state.nodes[static_cast<std::size_t>(i)].guided) continue;
    if (force <= elastic_force(node.contact, least_clearance)) continue;
    const double depth = std::pow(force / node.contact.stiffness, 1.0 / node.contact.exponent);
    const NodeState& at = state.nodes[static_cast<std::size_t>(i)];
    const double clearance = state.well.radius_near(at.position, at.segment) - node.contact_radius;
    if (depth > clearance)
      take(AccuracyDoubt::embedding, depth, node.from_bit, 0.0, stiff_enough(model.scene(), node, force, clearance));
  }
  return report;
}

}  // namespace drill_rig_sim
