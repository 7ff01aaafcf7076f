// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_UNLIKELY_PARTS_H
#define DRILL_RIG_SIM_SRC_SCENE_UNLIKELY_PARTS_H

#include <vector>

#include "drill_rig_sim/scene/scene.h"
#include "sized_number.h"

namespace drill_rig_sim
{
/// The numbers of a scene's string whose size the trade limits: bit with nozzles and torque, motor, steerable tool, lengths,
/// clearances, strength.
std::vector<SizedNumber> part_sizes(const Scene& scene);

}  // namespace drill_rig_sim

#endif
