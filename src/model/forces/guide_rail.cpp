// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/guide_rail.h"

namespace drill_rig_sim
{
namespace
{
/// A guided node at the top, which the hole's guide holds as the rail does.
void hold_guided(int top, const ForceRows& to) noexcept
{
  at_node(to.residual(), top).setZero();
  if (!to.with_tangent()) return;
  to.tangent()->small_diagonal(top).setIdentity();
  to.tangent()->small_upper(top - 1).setZero();
  to.tangent()->small_lower(top - 1).setZero();
  if (to.tangent()->small(top - 1)) return;
  to.tangent()->upper(top - 1).setZero();
  to.tangent()->lower(top - 1).setZero();
}

void hold(int top, int k, const ForceRows& to) noexcept
{
  at_node(to.residual(), top)[k] = 0.0;
  if (!to.with_tangent()) return;
  to.tangent()->diagonal(top).row(k).setZero();
  to.tangent()->diagonal(top).col(k).setZero();
  to.tangent()->diagonal(top)(k, k) = 1.0;
  to.tangent()->upper(top - 1).col(k).setZero();
  to.tangent()->lower(top - 1).row(k).setZero();
}

void add_rail(const StageContext& at, const ForceRows& to) noexcept
{
  if (at.stage.guides.guided.back()) return;
  for (int k : held_by_rail) hold(at.model.top(), k, to);
}

void add_hold(const StageContext& at, const ForceRows& to) noexcept
{
  const auto r = at_node(to.residual(), at.model.top());
  at.work.result.held_force = r[2];
  at.work.result.held_torque = -r[5];
  if (at.stage.guides.guided.back()) return hold_guided(at.model.top(), to);
  for (int k = 0; k < 6; ++k) hold(at.model.top(), k, to);
}
}  // namespace

const Force guide_rail = {"guide rail", Cost::rig, Sum::none, add_rail, add_hold, nullptr, nullptr, nullptr};

}  // namespace drill_rig_sim
