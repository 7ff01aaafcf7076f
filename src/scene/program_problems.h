// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_PROGRAM_PROBLEMS_H
#define DRILL_RIG_SIM_SRC_SCENE_PROGRAM_PROBLEMS_H

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/well/problem.h"

namespace drill_rig_sim
{
/// What does not go together in a scene's program: lines out of order, keys of different modes in one line, values beyond the
/// rig's limits, faults without what they need.
ProblemList program_problems(const Scene& scene);

/// Why a string cannot be free just so far above the bit's face [m]: it would be cut within the bit, or within a shaft that
/// leans. Empty where it can; 0, not a number: nothing is cut.
std::string what_it_cuts(const Scene& scene, double free_length);

}  // namespace drill_rig_sim

#endif
