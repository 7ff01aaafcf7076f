// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/oscillator.h"

#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
/// Calls visit(node, force on it [N], world axes) for each tool while mud flows.
template <class Visit>
void each_oscillator(const StageContext& at, Visit&& visit)
{
  if (at.start.hydraulics.pump_flow <= 0.0) return;
  const double time = at.start.time + at.stage.time;
  for (const Oscillator& tool : at.model.mesh().oscillators)
    visit(tool.node, tool.force * std::sin(2.0 * pi * tool.frequency * time) * at.node(tool.node).axis);
}

void add_oscillator(const StageContext& at, const ForceRows& to) noexcept
{
  each_oscillator(at, [&](int node, const Eigen::Vector3d& force) { to.force(node).head<3>() -= force; });
}

void sample_oscillator(const StageContext& at, EnergySample& sample) noexcept
{
  each_oscillator(
      at, [&](int node, const Eigen::Vector3d& force) { at_node(sample, NodeForce::oscillator, node).head<3>() -= force; });
}
}  // namespace

const Force oscillator = {"oscillator", Cost::rig, Sum::contact, add_oscillator, nullptr, nullptr, nullptr, sample_oscillator};

}  // namespace drill_rig_sim
