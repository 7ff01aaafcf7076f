// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_OPERATION_PROBLEMS_H
#define DRILL_RIG_SIM_SRC_SCENE_OPERATION_PROBLEMS_H

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/well/problem.h"

namespace drill_rig_sim
{
/// What does not go together in a scene's operations: operations without an end, beyond the rig's limits or the block's travel,
/// or without what they need.
ProblemList operation_problems(const Scene& scene);

/// Why the rig's crew (crew/crew.h) cannot make connections in this scene, one line; empty: it can.
std::string what_the_crew_lacks(const Scene& scene);

}  // namespace drill_rig_sim

#endif
