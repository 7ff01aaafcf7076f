// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_LAS_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_LAS_H

#include <string>

#include "drill_rig_sim/scene/survey_format.h"
#include "problems.h"
#include "survey_rows.h"

namespace drill_rig_sim
{
/// Reads a survey out of a file of Log ASCII Standard, LAS 1.2, 2.0 or 3.0 without wrapped lines: the curves of ~C by their
/// mnemonics and units, as read_survey_csv() reads columns; of LAS 3.0 those of ~Inclinometry where it has that section (LAS 3.0,
/// Canadian Well Logging Society, 2000). NULL of ~W is no value. What is wrong goes to `problems`.
SurveyRows read_survey_las(const std::string& text, const SurveyFormat& format, Problems& problems);

}  // namespace drill_rig_sim

#endif
