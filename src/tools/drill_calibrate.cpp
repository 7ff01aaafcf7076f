// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <optional>
#include <string>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_python.h"

namespace drill_rig_sim
{
namespace
{
struct CalibrateOptions
{
  std::string fit, apply, json, plots, scheduler;
  std::optional<double> workers;
};

void calibrate(const CalibrateOptions& options)
{
  const std::string workers = options.workers ? std::to_string(static_cast<int>(*options.workers)) : "";
  become_python("calibrate_command", {},
                {{"--apply", options.apply},
                 {"--json", options.json},
                 {"--plots", options.plots},
                 {"--scheduler", options.scheduler},
                 {"--workers", workers}},
                {options.fit});
}
}  // namespace

Command add_calibrate_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("calibrate", "fits a scene's parameters to a rig's record or to a table of weights");
  const auto options = std::make_shared<CalibrateOptions>();
  add_file(*words, "FIT", options->fit, "the fit: its parameters and data (.yaml)");
  add_text(*words, "--apply", options->apply, "FILE",
           "file of --json of an earlier fit: predicts this record or table by its parameters, with their confidence band");
  add_text(*words, "--json", options->json, "FILE", "writes parameters, confidence and residuals, or what --apply predicts");
  add_text(*words, "--plots", options->plots, "FILE", "draws recorded and predicted values, with the band (.png, .svg, .pdf)");
  add_number(*words, "--workers", options->workers, 1.0, 1024.0, "N",
             "processes of this machine; default: one for each core where a point takes long");
  add_text(*words, "--scheduler", options->scheduler, "ADDRESS", "of a running Dask cluster");
  return {words, [options] { calibrate(*options); }};
}

}  // namespace drill_rig_sim
