// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_MARKS_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_MARKS_H

#include <string>

#include "drill_rig_sim/scene/survey_format.h"
#include "problems.h"
#include "survey_rows.h"

/// Columns of a survey that mark its stations: as good or bad (`QC`, `Status`, `Comment`), or as those of a plan and of the
/// drilled well (`Type`).
namespace drill_rig_sim
{
/// Whether a column may be such a one, by its name in the header.
bool marks_stations(const std::string& name, const SurveyFormat& format);

/// Leaves out the stations that are marked as bad and those of the other path than `format` asks for; reported. A problem where
/// it cannot be known which stations are bad.
void leave_out_marked(const SurveyFormat& format, SurveyRows& survey, Problems& problems);

}  // namespace drill_rig_sim

#endif
