// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_STATIONS_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_STATIONS_H

#include <optional>

#include "drill_rig_sim/scene/survey_file.h"
#include "problems.h"
#include "survey_rows.h"

namespace drill_rig_sim
{
/// The stations of a survey's rows, checked (survey_problems()). `pass_over`: stations without a value and those that equal the
/// one before are left out, and a missing azimuth of a vertical station is 0; remarks report it. `tie_in` goes before that of the
/// rows. What is wrong goes to `problems`.
SurveyTable stations_of(const SurveyRows& survey, bool pass_over, const std::optional<TieIn>& tie_in, Problems& problems);

}  // namespace drill_rig_sim

#endif
