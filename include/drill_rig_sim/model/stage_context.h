// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_STAGE_CONTEXT_H
#define DRILL_RIG_SIM_MODEL_STAGE_CONTEXT_H

#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"

namespace drill_rig_sim
{
struct StageContext;
/// A guided node's motion as a free one's, into work.nodes.
void move_as_free(const StageContext& at, int i) noexcept;

/// A stage and where it is worked out: what a force sees, and what Newton's method solves.
struct StageContext
{
  const Model& model;
  const State& start;  ///< of the step
  const Stage& stage;
  Workspace& work;

  /// How node i moves at the stage, whether it is free or guided. `closest` and `touches` of NodeMotion are set only for free
  /// nodes.
  const NodeMotion& node(int i) const noexcept
  {
    if (!work.motion_known[static_cast<std::size_t>(i)]) move_as_free(*this, i);
    return work.nodes[static_cast<std::size_t>(i)];
  }
};

}  // namespace drill_rig_sim

#endif
