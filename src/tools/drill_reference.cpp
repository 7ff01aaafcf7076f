#include <CLI/App.hpp>
#include <cstdio>

#include "drill_command.h"
#include "drill_rig_sim/scene/read_scene.h"

namespace drill_rig_sim
{
Command add_reference_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("reference", "prints the scene file's reference as Markdown");
  return {words, [] { std::fputs(scene_reference().c_str(), stdout); }};
}

}  // namespace drill_rig_sim
