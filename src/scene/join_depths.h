// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_JOIN_DEPTHS_H
#define DRILL_RIG_SIM_SCENE_JOIN_DEPTHS_H

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// Depths that differ only by the rounding of their units become one: 5123 ft as the survey's last station, as the end of the
/// last section, as hole depth and as the bit's. Within a micrometre.
void join_depths(Scene& scene);

}  // namespace drill_rig_sim

#endif
