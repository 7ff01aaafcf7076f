// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_SCENE_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_SCENE_H

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "drill_command.h"
#include "drill_rig_sim/realtime/threads.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// Lines about how a file was read, on stderr.
inline void print_remarks(const std::vector<std::string>& remarks)
{
  for (const std::string& remark : remarks) std::fprintf(stderr, "%s\n", remark.c_str());
}

/// read_scene(), with its remarks on stderr.
inline Scene open_scene(const std::string& file, const std::vector<std::string>& settings)
{
  Scene scene = read_scene(file, settings);
  print_remarks(scene.remarks);
  return scene;
}

/// A simulator for the scene, whose companion has a thread of its own where there is a core for it; a scene that is well written
/// but cannot be built becomes a UsageError that names its file.
inline Simulator build_simulator(const Scene& scene, std::uint64_t seed)
{
  try
  {
    Simulator simulator(scene, seed);
    if (available_cores() > 1) simulator.set_companion_pace(CompanionPace::own_thread);
    return simulator;
  }
  catch (const std::exception& e)
  {
    throw UsageError(scene.file + ": " + e.what());
  }
}

}  // namespace drill_rig_sim

#endif
