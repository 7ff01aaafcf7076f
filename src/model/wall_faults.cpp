// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/wall_faults.h"

#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
/// @param motion  of a node or an element's middle
template <class Motion>
void put(const State& state, double radius, Motion& motion) noexcept
{
  ClosestPoint& closest = motion.closest;
  if (closest.md <= 0.0) return;
  const WashOut wider = wash_out(state.faults, closest.md);
  closest.radius += wider.radius;
  closest.radius_slope += wider.slope;
  closest.friction *= friction_factor(state, closest.md);
  if (motion.touches) motion.touches = wall_gap(closest, motion.position, radius) < 0.0;
}
bool is_at_wall(const State& state) noexcept
{
  return state.faults.at_wall() || state.cuttings.drags;
}
}  // namespace

WashOut wash_out(const FaultState& faults, double md) noexcept
{
  const double away = (md - faults.washed_out_at) / wash_out_length;
  if (faults.washed_out_by <= 0.0 || std::abs(away) >= 1.0) return {};
  const double quarter = 0.25 * faults.washed_out_by;
  return {quarter * (1.0 + std::cos(pi * away)), -quarter * pi / wash_out_length * std::sin(pi * away)};
}

void put_faults_on_wall(const Model& model, const State& state, const Stage& stage, Workspace& work) noexcept
{
  if (!is_at_wall(state)) return;
  // of those that batches have found clear nothing new is known, and of gauge and blades all is
  const auto is_new = [&](bool touches, bool singly) { return !work.place || touches || singly; };
  each_outside(stage.guided_nodes, model.top(),
               [&](int k)
               {
                 const std::size_t i = static_cast<std::size_t>(k);
                 NodeMotion& node = work.nodes[i];
                 if (is_new(node.touches, work.columns.single_nodes[i])) put(state, model.mesh().nodes[i].contact_radius, node);
               });
  each_outside(stage.guided_elements, model.elements(),
               [&](int k)
               {
                 const std::size_t e = static_cast<std::size_t>(k);
                 SpanMotion& span = work.spans[e];
                 if (is_new(span.touches, work.columns.single_elements[e]))
                   put(state, 0.5 * model.mesh().elements[e].outer_diameter, span);
               });
}

void put_faults_on_guides(const State& state, Stage& stage) noexcept
{
  if (!is_at_wall(state)) return;
  for (const Runs::Run& run : stage.guided_nodes)
    for (int k = run.first; k < run.last; ++k)
    {
      const double md = state.nodes[static_cast<std::size_t>(k)].md;
      if (md <= 0.0) continue;
      stage.guides.friction[k] *= friction_factor(state, md);
      stage.guides.clearance[k] += wash_out(state.faults, md).radius;
    }
}

}  // namespace drill_rig_sim
