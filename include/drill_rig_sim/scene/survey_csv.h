#ifndef DRILL_RIG_SIM_SCENE_SURVEY_CSV_H
#define DRILL_RIG_SIM_SCENE_SURVEY_CSV_H

#include <cstddef>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// What is wrong with one station of a survey.
struct SurveyProblem
{
  std::size_t station = 0;  ///< index, 0 = first
  std::string text;         ///< one line: what is wrong, what is allowed
};

/// Checks a survey as the well needs it: at least two stations, finite values, md from 0 strictly increasing and at most 20 km,
/// inclination 0 .. pi, azimuth -2 pi .. 2 pi, less than half a turn between neighbours. Empty when all is well.
std::vector<SurveyProblem> survey_problems(const std::vector<SurveyStation>& stations);

/// Reads a comma-separated survey whose header names the columns md_m, inclination_deg and azimuth_deg, in any order; other
/// columns are ignored, so are empty lines and lines that begin with '#'. Throws SceneError with `file:LINE: column: ...` if it
/// is unreadable or survey_problems() finds anything.
std::vector<SurveyStation> read_survey_csv(const std::string& file);

}  // namespace drill_rig_sim

#endif
