#include "drill_rig_sim/model/forces/guide_rail.h"

namespace drill_rig_sim
{
namespace
{
/// A guided node at the top, which the hole's guide holds as the rail does.
void hold_guided(int top, double* residual, BlockTridiagonal* tangent) noexcept
{
  at_node(residual, top).setZero();
  if (!tangent) return;
  tangent->small_diagonal(top).setIdentity();
  tangent->small_upper(top - 1).setZero();
  tangent->small_lower(top - 1).setZero();
  if (tangent->small(top - 1)) return;
  tangent->upper(top - 1).setZero();
  tangent->lower(top - 1).setZero();
}

void hold(int top, int k, double* residual, BlockTridiagonal* tangent) noexcept
{
  at_node(residual, top)[k] = 0.0;
  if (!tangent) return;
  tangent->diagonal(top).row(k).setZero();
  tangent->diagonal(top).col(k).setZero();
  tangent->diagonal(top)(k, k) = 1.0;
  tangent->upper(top - 1).col(k).setZero();
  tangent->lower(top - 1).row(k).setZero();
}

void add_rail(const StageContext& at, double* residual, BlockTridiagonal* tangent) noexcept
{
  if (at.stage.guides.back().guided) return;
  for (int k : held_by_rail) hold(at.model.top(), k, residual, tangent);
}

void add_hold(const StageContext& at, double* residual, BlockTridiagonal* tangent) noexcept
{
  const auto r = at_node(residual, at.model.top());
  at.work.result.held_force = r[2];
  at.work.result.held_torque = -r[5];
  if (at.stage.guides.back().guided) return hold_guided(at.model.top(), residual, tangent);
  for (int k = 0; k < 6; ++k) hold(at.model.top(), k, residual, tangent);
}
}  // namespace

const Force guide_rail = {"guide rail", Cost::rig, add_rail, nullptr, nullptr};
const Force held_top = {"held top", Cost::rig, add_hold, nullptr, nullptr};

}  // namespace drill_rig_sim
