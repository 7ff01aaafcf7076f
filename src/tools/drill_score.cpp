// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_python.h"
#include "drill_score_options.h"
#include "drill_units.h"

namespace drill_rig_sim
{
namespace
{
struct ScoreCommand
{
  ScoreOptions score;
  std::string run, name_space, json, plots, units = "si";
};

void judge(const ScoreCommand& options)
{
  become_python(
      "score_command", words_of(options.score),
      {{"--namespace", options.name_space}, {"--json", options.json}, {"--plots", options.plots}, {"--units", options.units}},
      {options.run});
}
}  // namespace

Command add_score_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("score", "scores a controller's run from its time series or bag");
  const auto options = std::make_shared<ScoreCommand>();
  add_file(*words, "RUN", options->run,
           "of drill run --csv, or a bag (.bag) with truth/rig_state and truth/bit, or with rig_state only");
  add_score_options(*words, options->score);
  add_text(*words, "--namespace", options->name_space, "NS", "namespace of the rig, where a bag has several");
  add_text(*words, "--json", options->json, "FILE", "writes the scores");
  add_text(*words, "--plots", options->plots, "FILE", "draws a page (.png, .svg, .pdf)");
  add_units(*words, options->units);
  return {words, [options] { judge(*options); }};
}

}  // namespace drill_rig_sim
