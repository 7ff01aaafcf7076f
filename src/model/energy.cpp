// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/energy.h"

#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/forces/lists.h"

namespace drill_rig_sim
{
namespace
{
StoredEnergy stored_at(const StageContext& at) noexcept
{
  StoredEnergy out;
  for (const Force* force : all_forces)
    if (force->store) force->store(at, out);
  return out;
}
}  // namespace

StoredEnergy stored_energy(const Model& model, const State& start, const Stage& stage, const double* u, Workspace& work) noexcept
{
  update(model, start, stage, u, work);
  return stored_at({model, start, stage, work});
}

void sample_energy(const Model& model, const State& start, const Stage& stage, const double* u, Workspace& work,
                   EnergySample& out)
{
  const std::size_t size = 6 * work.nodes.size();
  for (std::vector<double>& force : out.force) force.assign(size, 0.0);
  out.rate.resize(size);
  out.increment.resize(size);
  out.step = stage.time;
  out.shaft = ShaftSample();
  // the whole residual as the methods see it, not the sum of the forces' parts: one that is missing there would show
  evaluate(model, start, stage, u, work, out.force[static_cast<std::size_t>(NodeForce::unsolved)].data(), nullptr);
  expand_motions(stage, work);
  const StageContext at{model, start, stage, work};
  out.stored = stored_at(at);
  for (int i = 0; i < model.nodes(); ++i)
  {
    at_node(out.rate.data(), i) = work.nodes[i].rate;
    at_node(out.increment.data(), i) = work.nodes[i].increment;
  }
  for (const Force* force : all_forces)
    if (force->sample) force->sample(at, out);
}

}  // namespace drill_rig_sim
