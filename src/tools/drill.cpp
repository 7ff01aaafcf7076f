// SPDX-License-Identifier: BSD-3-Clause
// The offline runner: reads scenes, computes, writes files. Needs no ROS master.
#include <cstdio>
#include <exception>
#include <string>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_rig_sim/scene/read_scene.h"

namespace
{
constexpr int good = 0, wrong = 1, bad_input = 2, computation_failed = 3;

int run(const drill_rig_sim::Command& command)
{
  const std::string name = "drill " + command.words->get_name();
  try
  {
    command.run();
    return good;
  }
  catch (const drill_rig_sim::SceneError& e)
  {
    std::fprintf(stderr, "%s\n", e.what());
    return bad_input;
  }
  catch (const drill_rig_sim::ToleranceExceeded&)
  {
    return wrong;
  }
  catch (const drill_rig_sim::UsageError& e)
  {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), e.what());
    return bad_input;
  }
  catch (const std::exception& e)
  {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), e.what());
    return computation_failed;
  }
}

// Before the commands are added: they take these over.
void set_help(CLI::App& drill)
{
  drill.set_help_flag("--help", "prints this");
  drill.get_formatter()->column_width(28);
  drill.get_formatter()->label("SUBCOMMAND", "COMMAND");
  drill.get_formatter()->label("OPTIONS", "options");
}

int play(int argc, char** argv)
{
  CLI::App drill("", "drill");
  set_help(drill);
  drill.require_subcommand(0, 1);
  const drill_rig_sim::Command commands[] = {
      drill_rig_sim::add_run_command(drill),     drill_rig_sim::add_check_command(drill),
      drill_rig_sim::add_static_command(drill),  drill_rig_sim::add_modes_command(drill),
      drill_rig_sim::add_survey_command(drill),  drill_rig_sim::add_score_command(drill),
      drill_rig_sim::add_plot_command(drill),    drill_rig_sim::add_replay_command(drill),
      drill_rig_sim::add_weights_command(drill), drill_rig_sim::add_calibrate_command(drill),
      drill_rig_sim::add_verify_command(drill),  drill_rig_sim::add_reference_command(drill),
      drill_rig_sim::add_web_command(drill),     drill_rig_sim::add_fmu_command(drill),
      drill_rig_sim::add_live_command(drill)};
  drill.footer(
      "drill COMMAND --help lists a command's options. Exit status: 0 success, 1 verify found a run wrong without a warning, 2 "
      "bad input, 3 the computation failed.");
  try
  {
    drill.parse(argc, argv);
  }
  catch (const CLI::CallForHelp&)
  {
    std::fputs(drill.help().c_str(), stdout);
    return good;
  }
  catch (const CLI::ParseError& e)
  {
    std::fprintf(stderr, "%s\n", drill_rig_sim::problem_of(drill, e).c_str());
    return bad_input;
  }
  for (const drill_rig_sim::Command& command : commands)
  {
    if (command.words->parsed()) return run(command);
  }
  std::fputs(drill.help().c_str(), stderr);
  return bad_input;
}
}  // namespace

int main(int argc, char** argv)
{
  try
  {
    return play(argc, argv);
  }
  catch (const std::exception& e)
  {
    std::fprintf(stderr, "drill: %s\n", e.what());
    return computation_failed;
  }
}
