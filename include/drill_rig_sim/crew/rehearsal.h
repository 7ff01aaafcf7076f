// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_REHEARSAL_H
#define DRILL_RIG_SIM_CREW_REHEARSAL_H

#include <limits>
#include <optional>

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/well/problem.h"

namespace drill_rig_sim
{
/// The first line of a scene's program, up to simulated time `until` [s], that a run is sure to refuse, with the run's own words.
/// The program is played on a rig without forces: its winch moves as commanded, slips, connections and faults obey refusals.h.
/// What depends on loads is left to the run. The bit is taken to be as deep as it can be at that time: as far as the winch has
/// lowered it, and a margin for the string's stretch; where operations or a crew move the block, as far as the winch's largest
/// speed takes it. None: no line is sure to be refused.
std::optional<Problem> refused_line(const Scene& scene, double until = std::numeric_limits<double>::infinity());

}  // namespace drill_rig_sim

#endif
