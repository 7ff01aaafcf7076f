// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_UNLIKELY_VALUES_H
#define DRILL_RIG_SIM_SRC_SCENE_UNLIKELY_VALUES_H

#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// Values that are in range and that no rig has, as of a number in another unit; a line each: key, value and what is usual.
/// `stations`: those of the scene's well too; a survey's file has been looked at.
std::vector<std::string> unlikely_values(const Scene& scene, bool stations);

/// Where a survey turns more sharply than holes are drilled, as by a wrong station; empty: nowhere.
std::string sharp_turn(const std::vector<SurveyStation>& survey);

/// Where a survey begins more inclined than slant rigs drill, as where inclinations count from the horizontal; empty: it does
/// not.
std::string flat_begin(const std::vector<SurveyStation>& survey);

/// Where the numbers of a survey in degrees are like radians: no inclination above 1.8, no azimuth above 2 pi, most azimuths no
/// whole numbers, and as radians a hole without sharp turns; or all inclinations multiples of 5 deg in radians. Empty: they are
/// not. The azimuths of a vertical hole go all the way round.
std::string like_radians(const std::vector<SurveyStation>& survey);

}  // namespace drill_rig_sim

#endif
