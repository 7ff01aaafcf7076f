// The offline runner: reads scenes, computes, writes files. Needs no ROS master.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "drill_command.h"
#include "drill_rig_sim/scene/read_scene.h"

namespace
{
using drill_rig_sim::Command;

constexpr int good = 0, bad_input = 2, computation_failed = 3;

const std::vector<const Command*> commands = {&drill_rig_sim::run_command, &drill_rig_sim::check_command,
                                              &drill_rig_sim::static_command, &drill_rig_sim::survey_command,
                                              &drill_rig_sim::reference_command};

void print_usage(std::FILE* out)
{
  std::fprintf(out, "usage: drill COMMAND ...\n");
  for (const Command* c : commands) std::fprintf(out, "  %-10s %-6s  %s\n", c->name, c->positional, c->summary);
  std::fprintf(
      out, "drill COMMAND --help lists a command's options. Exit status: 0 success, 2 bad input, 3 the computation failed.\n");
}

int run(const Command& command, const std::vector<std::string>& words)
{
  for (const std::string& word : words)
  {
    if (word != "--help") continue;
    std::fputs(help(command).c_str(), stdout);
    return good;
  }
  try
  {
    command.run(parse_arguments(command, words));
    return good;
  }
  catch (const drill_rig_sim::SceneError& e)
  {
    std::fprintf(stderr, "%s\n", e.what());
    return bad_input;
  }
  catch (const drill_rig_sim::UsageError& e)
  {
    std::fprintf(stderr, "drill %s: %s\n", command.name, e.what());
    return bad_input;
  }
  catch (const std::exception& e)
  {
    std::fprintf(stderr, "drill %s: %s\n", command.name, e.what());
    return computation_failed;
  }
}
}  // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && (words[0] == "--help" || words[0] == "help"))
  {
    print_usage(stdout);
    return good;
  }
  for (const Command* command : commands)
  {
    if (!words.empty() && words[0] == command->name) return run(*command, {words.begin() + 1, words.end()});
  }
  if (words.empty())
  {
    print_usage(stderr);
  }
  else
  {
    std::fprintf(stderr, "drill: '%s' is no command, allowed: run, check, static, survey or reference\n", words[0].c_str());
  }
  return bad_input;
}
