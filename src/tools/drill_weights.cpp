// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string>
#include <vector>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_python.h"
#include "drill_record.h"
#include "drill_units.h"

namespace drill_rig_sim
{
namespace
{
struct WeightsOptions
{
  RecordOptions record;
  std::string csv, json, units = "si";
  bool no_flow = false;
};

void weights(const WeightsOptions& options)
{
  std::vector<std::string> words = words_of(options.record);
  if (options.no_flow) words.emplace_back("--no-flow");
  become_python("weights_command", words, {{"--csv", options.csv}, {"--json", options.json}, {"--units", options.units}},
                {options.record.record});
}
}  // namespace

Command add_weights_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand(
      "weights", "finds steady pick-up, slack-off and rotating weights and the empty block in a rig's record");
  const auto options = std::make_shared<WeightsOptions>();
  add_record(*words, options->record);
  add_record_options(*words, options->record);
  words->add_flag("--no-flow", options->no_flow, "leaves out moves while the pump runs");
  add_text(*words, "--csv", options->csv, "FILE", "writes the table that drill calibrate fits: `table: {file: FILE}`");
  add_text(*words, "--json", options->json, "FILE", "writes the moves");
  add_units(*words, options->units);
  return {words, [options] { weights(*options); }};
}

}  // namespace drill_rig_sim
