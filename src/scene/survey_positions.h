// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_POSITIONS_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_POSITIONS_H

#include <string>
#include <vector>

#include "drill_rig_sim/well/survey.h"
#include "survey_rows.h"

namespace drill_rig_sim
{
/// Where the vertical depths that a survey's file has are not those of its stations by minimum curvature, as of a wrong unit or
/// column; empty: nowhere, or it has none. `rows`: of the stations. Depths are compared from the first station on that has one.
std::string differing_tvd(const SurveyRows& survey, const std::vector<SurveyStation>& stations,
                          const std::vector<const SurveyRow*>& rows);

/// The same of north and east, as of exchanged columns or of azimuths from another north.
std::string differing_displacement(const SurveyRows& survey, const std::vector<SurveyStation>& stations,
                                   const std::vector<const SurveyRow*>& rows);

}  // namespace drill_rig_sim

#endif
