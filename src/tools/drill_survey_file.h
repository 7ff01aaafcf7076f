// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_SURVEY_FILE_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_SURVEY_FILE_H

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace drill_rig_sim
{
/// How a survey's file is to be read, where its header does not define it (survey_format()).
struct SurveyFileOptions
{
  std::string columns;
  bool pass_over = false;
};

/// `--columns` and `--pass-over`; `whose`: columns they are of.
void add_survey_file_options(CLI::App& command, SurveyFileOptions& options, const std::string& whose);

/// The same for Python's side, with the plan that they are of. Throws UsageError where there is no plan.
void add_plan_words(std::vector<std::string>& words, const std::string& plan, const SurveyFileOptions& options);

}  // namespace drill_rig_sim

#endif
