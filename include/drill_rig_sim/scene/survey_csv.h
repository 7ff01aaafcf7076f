#ifndef DRILL_RIG_SIM_SCENE_SURVEY_CSV_H
#define DRILL_RIG_SIM_SCENE_SURVEY_CSV_H

#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/well/tie_in.h"
#include "drill_rig_sim/well/well_checks.h"

namespace drill_rig_sim
{
/// What a survey file holds.
struct SurveyTable
{
  std::vector<SurveyStation> stations;
  std::optional<TieIn> tie_in;  ///< where the first station lies, if that is known
};

/// Reads a comma-separated survey whose header names the columns md_m, inclination_deg and azimuth_deg, in any order; where it has north_m,
/// east_m and tvd_m too, the first station's are the tie-in, unless `tie_in` is given. Other columns are ignored, so are empty lines and lines
/// that begin with '#'. The file is a regular one of at most 16 MiB. Throws SceneError with `file:LINE: column: ...` if it is unreadable or
/// survey_problems() finds anything: a first station below 0 needs a tie-in.
SurveyTable read_survey_csv(const std::string& file, const std::optional<TieIn>& tie_in = std::nullopt);

}  // namespace drill_rig_sim

#endif
