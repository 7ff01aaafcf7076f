// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_PROGRAM_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_PROGRAM_H

#include <optional>

#include "drill_command.h"
#include "drill_rig_sim/crew/rehearsal.h"

namespace drill_rig_sim
{
/// UsageError for a line of the scene's program, up to simulated time `until` [s], that a run is sure to refuse.
inline void require_program(const Scene& scene, double until)
{
  const std::optional<Problem> refused = refused_line(scene, until);
  if (refused) throw UsageError(scene.file + ": " + refused->key + ": " + refused->text);
}

}  // namespace drill_rig_sim

#endif
