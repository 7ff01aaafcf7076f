// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
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
struct PlotOptions
{
  SurveyFileOptions plan_file;
  std::string run, out, plan, string, scene, name_space, units = "si";
};

void plot(const PlotOptions& options)
{
  std::vector<std::string> words;
  add_plan_words(words, options.plan, options.plan_file);
  become_python("plot_command", words,
                {{"--out", options.out},
                 {"--string", options.string},
                 {"--scene", options.scene},
                 {"--namespace", options.name_space},
                 {"--units", options.units}},
                {options.run});
}
}  // namespace

Command add_plot_command(CLI::App& drill)
{
  CLI::App* words =
      drill.add_subcommand("plot", "draws a run: logs by time and depth, well, toolfaces, and a page with all of them");
  const auto options = std::make_shared<PlotOptions>();
  add_file(*words, "RUN", options->run,
           "of drill run --csv, or a bag (.bag) with truth/rig_state and truth/bit, or with rig_state only");
  add_text(*words, "--out", options->out, "DIR", "folder for PNG, SVG and index.html; default: beside the run");
  add_text(*words, "--plan", options->plan, "FILE", "planned survey, beside the drilled well");
  add_survey_file_options(*words, options->plan_file, "the plan's");
  add_text(*words, "--string", options->string, "FILE",
           "of drill run --profile or drill static --csv: the forces along the string");
  add_text(*words, "--scene", options->scene, "FILE", "of the run: computes the broomstick chart of web.html, in some seconds");
  add_text(*words, "--namespace", options->name_space, "NS", "namespace of the rig, where a bag has several");
  add_units(*words, options->units);
  return {words, [options] { plot(*options); }};
}

}  // namespace drill_rig_sim
