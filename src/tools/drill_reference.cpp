#include <cstdio>

#include "drill_command.h"
#include "drill_rig_sim/scene/read_scene.h"

namespace drill_rig_sim
{
namespace
{
void print_reference(const Arguments&)
{
  std::fputs(scene_reference().c_str(), stdout);
}
}  // namespace

const Command reference_command = {"reference", "", "prints the scene file's reference as Markdown", {}, print_reference};

}  // namespace drill_rig_sim
