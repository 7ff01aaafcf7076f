// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_READ_FILL_H
#define DRILL_RIG_SIM_SRC_SCENE_READ_FILL_H

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "drill_rig_sim/string/mud.h"
#include "problems.h"

namespace drill_rig_sim
{
/// Reads mud.fill: one level [m], or rows of bit depth and level [m].
void read_fill(const YAML::Node& node, const std::string& path, std::vector<FillLevel>& fill, Problems& problems);

}  // namespace drill_rig_sim

#endif
