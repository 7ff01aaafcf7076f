// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_READ_HYDRAULICS_H
#define DRILL_RIG_SIM_SRC_SCENE_READ_HYDRAULICS_H

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene.h"
#include "problems.h"

/// Reads mud and pump, and the bit's nozzles.
namespace drill_rig_sim
{
/// The block mud.
void read_mud(const YAML::Node& node, const std::string& path, Scene& scene, Problems& problems);
/// The block rig.mud_pump.
void read_mud_pump(const YAML::Node& node, const std::string& path, MudPumpSpec& pump, Problems& problems);
/// string[].nozzles: diameters in 1/32 in, or with their unit.
void read_nozzles(const YAML::Node& node, const std::string& path, std::vector<double>& nozzles, Problems& problems);

/// Adds what contradicts, lacks or has no effect among the keys of a mud with a rheology and those that they stand for.
void check_hydraulics(const Scene& scene, Problems& problems);

}  // namespace drill_rig_sim

#endif
