// SPDX-License-Identifier: BSD-3-Clause
#include "drill_score_options.h"

#include <cstdio>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_python.h"

namespace drill_rig_sim
{
namespace
{
void add_number_word(std::vector<std::string>& words, const char* name, const std::optional<double>& value)
{
  if (!value) return;
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", *value);
  add_word(words, name, text);
}
}  // namespace

void add_score_options(CLI::App& command, ScoreOptions& options)
{
  add_text(command, "--plan", options.plan, "FILE", "planned survey, for distance and tortuosity");
  add_survey_file_options(command, options.plan_file, "the plan's");
  add_number(command, "--bit-diameter", options.bit_diameter, 0.01, 2.0, "M", "for the mechanical specific energy");
  add_number(command, "--wob", options.wob, 0.0, 1e7, "N", "set point of the weight on bit");
  add_number(command, "--wob-band", options.wob_band, 0.0, 1e7, "N", "tolerance about that set point; default: a tenth of it");
  add_number(command, "--toolface", options.toolface, -360.0, 360.0, "DEG", "set point of the toolface");
  add_number(command, "--toolface-band", options.toolface_band, 0.0, 180.0, "DEG", "tolerance about that set point; default: 15");
}

std::vector<std::string> words_of(const ScoreOptions& options)
{
  if (options.wob_band && !options.wob) throw UsageError("--wob-band: needs --wob");
  if (options.toolface_band && !options.toolface) throw UsageError("--toolface-band: needs --toolface");
  std::vector<std::string> words;
  add_plan_words(words, options.plan, options.plan_file);
  add_number_word(words, "--bit-diameter", options.bit_diameter);
  add_number_word(words, "--wob", options.wob);
  add_number_word(words, "--wob-band", options.wob_band);
  add_number_word(words, "--toolface", options.toolface);
  add_number_word(words, "--toolface-band", options.toolface_band);
  return words;
}

}  // namespace drill_rig_sim
