// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_SCORE_OPTIONS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_SCORE_OPTIONS_H

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "drill_survey_file.h"

namespace drill_rig_sim
{
/// What a run is judged by: planned survey, bit and set points.
struct ScoreOptions
{
  SurveyFileOptions plan_file;
  std::string plan;
  std::optional<double> bit_diameter, wob, wob_band, toolface, toolface_band;
};

void add_score_options(CLI::App& command, ScoreOptions& options);

/// The same for Python's side. Throws UsageError where an option lacks the one that it belongs to.
std::vector<std::string> words_of(const ScoreOptions& options);

}  // namespace drill_rig_sim

#endif
