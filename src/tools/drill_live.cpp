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
struct LiveOptions
{
  std::string feed, scene, name_space, wits_units, start, topics, csv, units = "si";
  std::optional<double> every;
};

void live(const LiveOptions& options)
{
  std::vector<std::string> words;
  if (options.every) words.push_back("--every=" + std::to_string(*options.every));
  become_python("live_command", words,
                {{"--namespace", options.name_space},
                 {"--wits-units", options.wits_units},
                 {"--start", options.start},
                 {"--topics", options.topics},
                 {"--csv", options.csv},
                 {"--units", options.units}},
                {options.feed, options.scene});
}
}  // namespace

Command add_live_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand(
      "live", "drives a simulation with a rig's WITS level 0 stream or a bag and shows measured minus simulated");
  const auto options = std::make_shared<LiveOptions>();
  add_file(*words, "FEED", options->feed, "HOST:PORT of a WITS level 0 server, or a bag with rig_state");
  add_file(*words, "SCENE", options->scene, "the scene's file; its start is where the feed begins");
  add_text(*words, "--wits-units", options->wits_units, "metric|fps", "of the stream, by the WITS specification; default: metric")
      ->check(CLI::IsMember({"metric", "fps"}));
  add_number(*words, "--every", options->every, 0.05, 60.0, "S", "between the rows that are taken of a bag; default: 1 s");
  add_text(*words, "--namespace", options->name_space, "NS", "of the rig in a bag; default: the only one");
  add_text(*words, "--start", options->start, "scene|record",
           "where bit and block begin; default: scene, or record if the scene has no start.bit_depth")
      ->check(CLI::IsMember({"scene", "record"}));
  add_text(*words, "--topics", options->topics, "NS",
           "publishes residuals on NS/residual/SIGNAL as std_msgs/Float64 in SI; needs a ROS master");
  add_text(*words, "--csv", options->csv, "FILE", "writes measured and simulated values in SI");
  add_units(*words, options->units);
  return {words, [options] { live(*options); }};
}

}  // namespace drill_rig_sim
