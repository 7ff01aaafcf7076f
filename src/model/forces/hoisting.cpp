#include "drill_rig_sim/model/forces/hoisting.h"

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/hoisting.h"

namespace drill_rig_sim
{
namespace
{
double block_weight(const StageContext& at) noexcept
{
  return standard_gravity * at.model.scene().rig.hoisting.block_mass;
}

double block_height(const StageContext& at) noexcept
{
  return at.work.nodes.back().position.z();
}

LinePull pull_of(const StageContext& at) noexcept
{
  return line_pull(at.model.scene().rig.hoisting, block_height(at), at.stage.hoist.line_length);
}

void add(const StageContext& at, double* residual, BlockTridiagonal* tangent) noexcept
{
  const int top = at.model.top();
  const LinePull pull = pull_of(at);
  at_node(residual, top)[2] -= pull.hook_force - block_weight(at);
  at.work.result.forces.hook_load = pull.hook_force;
  if (tangent) tangent->diagonal(top)(2, 2) += pull.stiffness;
}

void store(const StageContext& at, StoredEnergy& energy) noexcept
{
  const double line = at.stage.hoist.line_length, tension = pull_of(at).tension;
  energy.line += 0.5 * tension * tension * line / at.model.scene().rig.hoisting.line_ea;
  energy.weight += block_weight(at) * block_height(at);
}

void sample(const StageContext& at, EnergySample& sample) noexcept
{
  const HoistingSpec& spec = at.model.scene().rig.hoisting;
  const HoistState& end = at.stage.hoist;
  const LinePull pull = pull_of(at);
  sample.hook_force = pull.hook_force;
  sample.line_price = pull.tension * (1.0 + 0.5 * pull.tension / spec.line_ea);
  sample.line_paid_out = end.line_length - at.start.hoist.line_length;
  sample.pay_out = -2.0 * spec.sheaves * end.winch_speed * end.line_length / strung_length(spec, block_height(at));
}
}  // namespace

const Force hoisting = {"hoisting", Cost::rig, add, store, sample};

HoistState advance_hoist(const Model& model, const State& state, const Setpoints& setpoints, double time) noexcept
{
  const HoistingSpec& spec = model.scene().rig.hoisting;
  const double height = state.nodes.back().position.z();
  const double hook_load = line_pull(spec, height, state.hoist.line_length).hook_force;
  const WinchStep winch =
      advance_winch(spec, setpoints.winch, state.hoist.line_length, state.hoist.winch_speed, height, hook_load, time);
  return {winch.line_length, winch.speed, winch.limits.any()};
}

}  // namespace drill_rig_sim
