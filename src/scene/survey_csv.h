// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_CSV_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_CSV_H

#include <string>

#include "drill_rig_sim/scene/survey_format.h"
#include "problems.h"
#include "survey_rows.h"

namespace drill_rig_sim
{
/// Reads a survey out of a table in text (read_survey_file(), survey_file.h): its header is one of the first 50 lines, cells are
/// parted by a comma, a semicolon, a tab or blanks, whichever makes it name the columns. Rows beyond most_stations are left out.
/// What is wrong goes to `problems`.
SurveyRows read_survey_csv(const std::string& text, const SurveyFormat& format, Problems& problems);

}  // namespace drill_rig_sim

#endif
