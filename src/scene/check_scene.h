#ifndef DRILL_RIG_SIM_SRC_SCENE_CHECK_SCENE_H
#define DRILL_RIG_SIM_SRC_SCENE_CHECK_SCENE_H

#include "drill_rig_sim/scene/scene.h"
#include "problems.h"

namespace drill_rig_sim
{
/// Checks between keys that are each in range: that sections reach the bottom, that parts fit the hole, that times ascend, ...
void check_scene(const Scene& scene, Problems& problems);

}  // namespace drill_rig_sim

#endif
