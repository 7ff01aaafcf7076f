// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_SCENE_HASH_H
#define DRILL_RIG_SIM_SCENE_SCENE_HASH_H

#include <cstdint>

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// A number that two scenes share only if every key has the same value in both, digit for digit; where they were read from does
/// not matter. It walks the one table of keys.
std::uint64_t scene_hash(const Scene& scene);

/// Where a rig begins: its bit depth, which reset_well sets, and the hash of all else in its scene.
struct SceneStart
{
  std::uint64_t scene = 0;
  double bit_depth = 0.0;  ///< [m]
};
SceneStart scene_start(Scene scene);

}  // namespace drill_rig_sim

#endif
