#include "drill_rig_sim/model/forces/pads.h"

namespace drill_rig_sim
{
namespace
{
void add(const StageContext& at, double* residual, BlockTridiagonal*) noexcept
{
  const int i = at.model.mesh().pad_node;
  if (i >= 0) at_node(residual, i).head<3>() -= at.stage.pad_force;
}

void sample(const StageContext& at, EnergySample& sample) noexcept
{
  const int i = at.model.mesh().pad_node;
  if (i >= 0) at_node(sample, NodeForce::pads, i).head<3>() -= at.stage.pad_force;
}
}  // namespace

const Force pads = {"pads", Cost::rig, add, nullptr, sample};

}  // namespace drill_rig_sim
