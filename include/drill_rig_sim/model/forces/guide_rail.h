// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_GUIDE_RAIL_H
#define DRILL_RIG_SIM_MODEL_FORCES_GUIDE_RAIL_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// What the guide rail holds of the top node: all but height and spin.
constexpr int held_by_rail[] = {0, 1, 3, 4};

/// The guide rail of the top drive. Rows and columns of the held coordinates become those of the identity. In statics all six
/// coordinates are held; the forces that hold height and spin are stored in work.result. Must be last in the list.
extern const Force guide_rail;

}  // namespace drill_rig_sim

#endif
