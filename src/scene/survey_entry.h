// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_ENTRY_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_ENTRY_H

#include <yaml-cpp/yaml.h>

#include <string>

#include "drill_rig_sim/scene/survey_format.h"
#include "problems.h"

namespace drill_rig_sim
{
/// What stands under well.survey.
struct SurveyEntry
{
  std::string file;
  SurveyFormat format;
};

/// Reads a file's name, or a block of it and its format. False, and problems noted, if it is neither.
bool read_survey_entry(const YAML::Node& node, const std::string& path, SurveyEntry& entry, Problems& problems);

}  // namespace drill_rig_sim

#endif
