// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_DIGITS_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_DIGITS_H

#include "problems.h"
#include "survey_rows.h"

namespace drill_rig_sim
{
/// Takes away what stands between groups of digits: blanks and apostrophes (1 234,5), commas where some number has a decimal
/// point (1,234.56; 1,234 beside 2.5), points where some number also has a decimal comma (1.234,56). Settles `decimal_commas` by
/// it, and reports commas and points. Numbers with either sign are a problem.
void take_groups(char delimiter, SurveyRows& survey, Problems& problems);

}  // namespace drill_rig_sim

#endif
