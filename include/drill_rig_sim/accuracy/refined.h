// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_REFINED_H
#define DRILL_RIG_SIM_ACCURACY_REFINED_H

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// The same numerics with elements and steps `times` shorter; below 1: longer.
NumericsSpec refined(NumericsSpec numerics, double times) noexcept;

/// The same numerics with free nodes all along the string: level beam3d.
NumericsSpec with_free_nodes(NumericsSpec numerics) noexcept;

/// What numerics.companion `auto` is: `coarser` where the program chooses the level, else `none`.
CompanionKind chosen_companion(const NumericsSpec& numerics) noexcept;

/// Why the error is not measured, one line in static storage; empty where it is.
const char* why_not_measured(const NumericsSpec& numerics) noexcept;

}  // namespace drill_rig_sim

#endif
