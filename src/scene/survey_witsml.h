// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_WITSML_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_WITSML_H

#include <string>

#include "drill_rig_sim/scene/survey_format.h"
#include "problems.h"
#include "survey_rows.h"

namespace drill_rig_sim
{
/// Reads the one trajectory of a WITSML document (1.3.1.1, 1.4.1.1) out of its text: md, incl, azi and, of the first station,
/// dispNs, dispEw, tvd, by their units; stations in any order. Stations whose status is `rejected` are left out and reported.
/// What is wrong goes to `problems`.
SurveyRows read_survey_witsml(const std::string& text, const SurveyFormat& format, Problems& problems);

}  // namespace drill_rig_sim

#endif
