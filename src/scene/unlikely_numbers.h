// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_UNLIKELY_NUMBERS_H
#define DRILL_RIG_SIM_SRC_SCENE_UNLIKELY_NUMBERS_H

#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// Numbers of a scene's rig, string, hole, rock and temperatures that are in range and of a size that no rig has, as of a number
/// whose unit is missing or wrong; a line each: key, value and what is usual.
std::vector<std::string> unlikely_numbers(const Scene& scene);

}  // namespace drill_rig_sim

#endif
