// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_SCENE_PROBLEMS_H
#define DRILL_RIG_SIM_SCENE_SCENE_PROBLEMS_H

#include <string>

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/well/problem.h"

namespace drill_rig_sim
{
/// What does not go together in a scene whose values are each in range: well, string, mesh, rig, start and program, by the rules
/// of their rooms (well_checks.h, string_checks.h) and those between them. The survey is sound (survey_problems()). Empty when
/// all is well. The one set of rules for every door: scene files, settings, the service that loads a survey.
ProblemList scene_problems(const Scene& scene);

/// What a scene asks for and this version does not have: levels but beam3d, connections. Part of scene_problems().
ProblemList unavailable(const Scene& scene);

/// Only letters, digits and _, 1 to 64 of them: what every name in a scene is.
bool is_name(const std::string& text);

}  // namespace drill_rig_sim

#endif
