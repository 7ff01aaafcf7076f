// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_READ_OPERATIONS_H
#define DRILL_RIG_SIM_SRC_SCENE_READ_OPERATIONS_H

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "drill_rig_sim/scene/operation.h"
#include "problems.h"

namespace drill_rig_sim
{
/// Reads a list of operations, key by key; what is wrong goes to `problems`.
void read_operations(const YAML::Node& list, const std::string& path, std::vector<Operation>& operations, Problems& problems);

}  // namespace drill_rig_sim

#endif
