// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_WRITE_SCENE_H
#define DRILL_RIG_SIM_SCENE_WRITE_SCENE_H

#include <string>

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// A scene as a scene file that needs no other: what --set, a survey's file or a service have made of it is in its keys, its
/// survey in `stations`. Read again it is the same scene to the last bit (scene_hash.h), but for angles that are no number of
/// degrees in doubles, as those of a tie-in: these are the same to rounding. Keys that have their defaults are left out.
std::string write_scene(const Scene& scene);

}  // namespace drill_rig_sim

#endif
