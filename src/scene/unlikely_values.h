// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_UNLIKELY_VALUES_H
#define DRILL_RIG_SIM_SRC_SCENE_UNLIKELY_VALUES_H

#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene.h"
#include "survey_units.h"

namespace drill_rig_sim
{
/// Values that are in range and that no rig has, as of a number in another unit; a line each: key, value and what is usual.
/// `stations`: those of the scene's well too; a survey's file has been looked at.
std::vector<std::string> unlikely_values(const Scene& scene, bool stations);

/// What is unlikely of the stations of a survey, a line each: one that does not fit those beside it, else where the hole turns
/// more sharply than holes are drilled; a beginning more inclined than slant rigs drill, as where inclinations count from the
/// horizontal; angles that are radians, where the file has them in degrees; steps of pipe in feet, where its unit is m; a wrong
/// digit of a depth. `unit`: of the depths as they were written.
std::vector<std::string> unlikely_stations(const std::vector<SurveyStation>& survey, const UnitName& unit, bool in_degrees);

}  // namespace drill_rig_sim

#endif
