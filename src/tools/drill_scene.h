#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_SCENE_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_SCENE_H

#include <cstdint>
#include <stdexcept>

#include "drill_command.h"
#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// A simulator for the scene; a scene that is well written but cannot be built becomes a UsageError that names its file.
inline Simulator build_simulator(const Scene& scene, std::uint64_t seed)
{
  try
  {
    return Simulator(scene, seed);
  }
  catch (const std::exception& e)
  {
    throw UsageError(scene.file + ": " + e.what());
  }
}

}  // namespace drill_rig_sim

#endif
