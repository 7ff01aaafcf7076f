// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_python.h"
#include "drill_units.h"

namespace drill_rig_sim
{
namespace
{
struct WebOptions
{
  std::string run, name_space, units = "si";
  std::optional<double> port;
  bool control = false;
};

void web(const WebOptions& options)
{
  std::vector<std::string> words;
  add_word(words, "--namespace", options.name_space);
  add_word(words, "--units", options.units);
  if (options.port) words.push_back("--port=" + std::to_string(static_cast<int>(*options.port)));
  if (options.control) words.emplace_back("--control");
  if (!options.run.empty()) words.insert(words.end(), {"--", options.run});
  become_python("web_command", words);
}
}  // namespace

Command add_web_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("web", "shows a rig in the browser of this machine: a running node, or a bag");
  const auto options = std::make_shared<WebOptions>();
  add_file(*words, "BAG", options->run, "of drill run --bag, or recorded of a node; without it the node that runs is shown")
      ->required(false);
  add_text(*words, "--namespace", options->name_space, "NS", "of the rig; default: rig, in a bag the only one");
  add_number(*words, "--port", options->port, 0.0, 65535.0, "PORT", "at 127.0.0.1; default: any free port");
  words->add_flag("--control", options->control, "lets pages command the rig; without it they are read-only");
  add_units(*words, options->units);
  return {words, [options] { web(*options); }};
}

}  // namespace drill_rig_sim
