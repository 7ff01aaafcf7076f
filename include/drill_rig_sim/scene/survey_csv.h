#ifndef DRILL_RIG_SIM_SCENE_SURVEY_CSV_H
#define DRILL_RIG_SIM_SCENE_SURVEY_CSV_H

#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/well/well_checks.h"

namespace drill_rig_sim
{
/// Reads a comma-separated survey whose header names the columns md_m, inclination_deg and azimuth_deg, in any order; other
/// columns are ignored, so are empty lines and lines that begin with '#'. The file is a regular one of
/// at most 16 MiB. Throws SceneError with `file:LINE: column: ...` if it is unreadable or survey_problems() finds anything.
std::vector<SurveyStation> read_survey_csv(const std::string& file);

}  // namespace drill_rig_sim

#endif
