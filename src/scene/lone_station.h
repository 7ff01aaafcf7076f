// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_LONE_STATION_H
#define DRILL_RIG_SIM_SRC_SCENE_LONE_STATION_H

#include <string>
#include <vector>

#include "drill_rig_sim/well/survey.h"
#include "survey_units.h"

namespace drill_rig_sim
{
/// Where one station of a survey has another direction than those beside it, which fit together, as by a wrong digit or by a 0 or
/// -1 for an angle that was not measured; empty: nowhere. Of several the one that lies farthest off. `unit`: of the depths as
/// they were written.
std::string lone_station(const std::vector<SurveyStation>& survey, const UnitName& unit);

}  // namespace drill_rig_sim

#endif
