// SPDX-License-Identifier: BSD-3-Clause
#include "drill_survey_file.h"

#include "drill_command.h"
#include "drill_options.h"
#include "drill_python.h"

namespace drill_rig_sim
{
void add_survey_file_options(CLI::App& command, SurveyFileOptions& options, const std::string& whose)
{
  add_text(command, "--columns", options.columns, "MAP.yaml",
           "a map of " + whose + " columns, units and delimiter (.yaml): the keys of a scene's well.survey");
  command.add_flag("--pass-over", options.pass_over, "skip stations without a value and those equal to the one before");
}

void add_plan_words(std::vector<std::string>& words, const std::string& plan, const SurveyFileOptions& options)
{
  if (plan.empty() && !options.columns.empty()) throw UsageError("--columns: needs --plan");
  if (plan.empty() && options.pass_over) throw UsageError("--pass-over: needs --plan");
  add_word(words, "--plan", plan);
  add_word(words, "--columns", options.columns);
  if (options.pass_over) words.push_back("--pass-over");
}

}  // namespace drill_rig_sim
