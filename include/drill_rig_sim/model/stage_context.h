#ifndef DRILL_RIG_SIM_MODEL_STAGE_CONTEXT_H
#define DRILL_RIG_SIM_MODEL_STAGE_CONTEXT_H

#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"

namespace drill_rig_sim
{
/// A stage and where it is worked out: what a force sees (the motion is in work.nodes), and what Newton's method solves.
struct StageContext
{
  const Model& model;
  const State& start;  ///< of the step
  const Stage& stage;
  Workspace& work;
};

}  // namespace drill_rig_sim

#endif
