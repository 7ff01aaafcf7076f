// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_SURVEY_FILE_H
#define DRILL_RIG_SIM_SCENE_SURVEY_FILE_H

#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/scene/survey_format.h"
#include "drill_rig_sim/well/tie_in.h"
#include "drill_rig_sim/well/well_checks.h"

namespace drill_rig_sim
{
/// What a survey file holds.
struct SurveyTable
{
  std::vector<SurveyStation> stations;
  std::optional<TieIn> tie_in;       ///< where the first station lies, if that is known
  std::vector<std::string> remarks;  ///< what is to be reported of how it was read, one line each
};

/// Reads a survey: a table in text (CSV) or a WITSML trajectory (1.3.1.1, 1.4.1.1). A table's header names measured depth,
/// inclination and azimuth by their usual spellings with their units (`MD (ft)`, `Incl`, `azimuth_deg`), or as `format` says;
/// where it has north, east and true vertical depth too, the first station's are the tie-in, unless `tie_in` is given. Depths
/// without a unit are refused; angles without one are degrees where they are too large for radians, else refused. Other columns
/// are ignored, so are empty lines and lines that begin with '#'. The file is a regular one of at most 16 MiB. Throws SceneError
/// with `file:LINE: column: ...` if it is unreadable or survey_problems() finds anything: a first station below 0 needs a tie-in.
SurveyTable read_survey_file(const std::string& file, const SurveyFormat& format,
                             const std::optional<TieIn>& tie_in = std::nullopt);
SurveyTable read_survey_file(const std::string& file, const std::optional<TieIn>& tie_in = std::nullopt);

}  // namespace drill_rig_sim

#endif
