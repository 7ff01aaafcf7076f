// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SETTINGS_H
#define DRILL_RIG_SIM_SRC_SCENE_SETTINGS_H

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "problems.h"

namespace drill_rig_sim
{
/// Puts settings such as `numerics.step=0.002` or `well.sections[0].friction=0` (the value is YAML) into a parsed scene, over
/// what the file says. Blocks that the file leaves out are made; a list item must exist. What is wrong goes to `problems`, named
/// as settings.
void apply_settings(const YAML::Node& root, const std::vector<std::string>& settings, Problems& problems);

}  // namespace drill_rig_sim

#endif
