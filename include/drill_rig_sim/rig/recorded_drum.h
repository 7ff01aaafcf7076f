// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RIG_RECORDED_DRUM_H
#define DRILL_RIG_SIM_RIG_RECORDED_DRUM_H

#include <vector>

#include "drill_rig_sim/rig/hoisting.h"

namespace drill_rig_sim
{
/// Where the block would hang on lines without load, with the drum as it is [m].
/// @param block_height  [m]
/// @param hook_load     on the lines [N]
double unloaded_height(const HoistingSpec& spec, double block_height, double hook_load) noexcept;

/// What the drum did in a record of the block's height and of the hook load, row by row: unloaded_height() [m].
///
/// By the dead line's gauge the load on the lines depends on the friction of the sheaves, this on how far the drum has turned,
/// and that on what the load stretches the lines. Several answers may agree with a row's gauges; the one is taken whose load
/// changed least since the row before. Drum heights that differ by less than a millimetre are those of a drum that stands. At the
/// first row the sheaves have no friction.
/// @param dead_line   where the hook load was read; false: at the block
/// @param heights     of the block, by rows [m]
/// @param hook_loads  as many [N]
std::vector<double> drum_heights(const HoistingSpec& spec, bool dead_line, const std::vector<double>& heights,
                                 const std::vector<double>& hook_loads);

}  // namespace drill_rig_sim

#endif
