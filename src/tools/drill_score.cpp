#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_python.h"
#include "drill_survey_file.h"
#include "drill_units.h"

namespace drill_rig_sim
{
namespace
{
struct ScoreOptions
{
  SurveyFileOptions plan_file;
  std::string run, plan, name_space, json, plots, units = "si";
  std::optional<double> bit_diameter, wob, wob_band, toolface, toolface_band;
};

std::string written(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// The command line of Python's side.
std::vector<std::string> words_of(const ScoreOptions& o)
{
  std::vector<std::string> words;
  const auto add_number = [&](const char* name, const std::optional<double>& value)
  {
    if (value) add_word(words, name, written(*value));
  };
  add_plan_words(words, o.plan, o.plan_file);
  add_word(words, "--namespace", o.name_space);
  add_word(words, "--json", o.json);
  add_word(words, "--plots", o.plots);
  add_number("--bit-diameter", o.bit_diameter);
  add_number("--wob", o.wob);
  add_number("--wob-band", o.wob_band);
  add_number("--toolface", o.toolface);
  add_number("--toolface-band", o.toolface_band);
  add_word(words, "--units", o.units);
  words.insert(words.end(), {"--", o.run});
  return words;
}

void judge(const ScoreOptions& options)
{
  if (options.wob_band && !options.wob) throw UsageError("--wob-band: needs --wob");
  if (options.toolface_band && !options.toolface) throw UsageError("--toolface-band: needs --toolface");
  become_python("score_command", words_of(options));
}
}  // namespace

Command add_score_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("score", "judges a controller's run from its time series or bag");
  const auto options = std::make_shared<ScoreOptions>();
  add_file(*words, "RUN", options->run,
           "of drill run --csv, or a bag (.bag) with truth/rig_state and truth/bit, or with rig_state alone");
  add_text(*words, "--plan", options->plan, "FILE", "planned survey, for distance and tortuosity");
  add_survey_file_options(*words, options->plan_file, "the plan's");
  add_number(*words, "--bit-diameter", options->bit_diameter, 0.01, 2.0, "M", "for the mechanical specific energy");
  add_number(*words, "--wob", options->wob, 0.0, 1e7, "N", "set point of the weight on bit");
  add_number(*words, "--wob-band", options->wob_band, 0.0, 1e7, "N", "so far from it counts as held; default: a tenth of it");
  add_number(*words, "--toolface", options->toolface, -360.0, 360.0, "DEG", "set point of the toolface");
  add_number(*words, "--toolface-band", options->toolface_band, 0.0, 180.0, "DEG", "so far from it counts as held; default: 15");
  add_text(*words, "--namespace", options->name_space, "NS", "which rig of a bag with several");
  add_text(*words, "--json", options->json, "FILE", "writes the scores");
  add_text(*words, "--plots", options->plots, "FILE", "draws a page (.png, .svg, .pdf)");
  add_units(*words, options->units);
  return {words, [options] { judge(*options); }};
}

}  // namespace drill_rig_sim
