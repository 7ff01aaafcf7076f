// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_python.h"
#include "drill_record.h"
#include "drill_units.h"

namespace drill_rig_sim
{
namespace
{
struct ReplayOptions
{
  RecordOptions record;
  std::string scene, start, json, csv, plots, units = "si";
};

void replay(const ReplayOptions& options)
{
  become_python("replay_command", words_of(options.record),
                {{"--start", options.start},
                 {"--json", options.json},
                 {"--csv", options.csv},
                 {"--plots", options.plots},
                 {"--units", options.units}},
                {options.record.record, options.scene});
}
}  // namespace

Command add_replay_command(CLI::App& drill)
{
  CLI::App* words =
      drill.add_subcommand("replay", "replays a rig's record on a scene and compares hook load, torque and pressure");
  const auto options = std::make_shared<ReplayOptions>();
  add_record(*words, options->record);
  add_file(*words, "SCENE", options->scene, "the scene's file; its start is where the record begins");
  add_record_options(*words, options->record);
  add_text(*words, "--start", options->start, "scene|record",
           "where bit and block begin; default: scene, or record if the scene has no start.bit_depth")
      ->check(CLI::IsMember({"scene", "record"}));
  add_text(*words, "--json", options->json, "FILE", "writes the residuals");
  add_text(*words, "--csv", options->csv, "FILE", "writes recorded and simulated values");
  add_text(*words, "--plots", options->plots, "FILE", "draws both (.png, .svg, .pdf)");
  add_units(*words, options->units);
  return {words, [options] { replay(*options); }};
}

}  // namespace drill_rig_sim
