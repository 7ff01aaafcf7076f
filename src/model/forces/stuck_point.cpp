#include "drill_rig_sim/model/forces/stuck_point.h"

#include "held_node.h"

namespace drill_rig_sim
{
namespace
{
constexpr Grip grip{stuck_point_stiffness, stuck_point_torsion, false, false};

void add(const StageContext& at, double* residual, BlockTridiagonal* tangent) noexcept
{
  add_held(at, at.start.stuck_point, grip, residual, tangent);
}

void store(const StageContext& at, StoredEnergy& energy) noexcept
{
  store_held(at, at.start.stuck_point, grip, energy);
}

void sample(const StageContext& at, EnergySample& sample) noexcept
{
  sample_held(at, at.start.stuck_point, grip, sample);
}
}  // namespace

const Force stuck_point = {"stuck point", Cost::rig, add, store, sample};

}  // namespace drill_rig_sim
