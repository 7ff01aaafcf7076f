// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SIZED_NUMBER_H
#define DRILL_RIG_SIM_SRC_SCENE_SIZED_NUMBER_H

#include <limits>
#include <string>

namespace drill_rig_sim
{
constexpr double any_size = std::numeric_limits<double>::infinity();

/// A number of a scene and the sizes that it has on rigs.
struct SizedNumber
{
  std::string key;
  double value;
  double least, most;
  std::string unit;
  std::string usual;  ///< what has such sizes, for the line
};

}  // namespace drill_rig_sim

#endif
