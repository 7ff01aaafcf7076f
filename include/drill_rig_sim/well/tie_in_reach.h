// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_TIE_IN_REACH_H
#define DRILL_RIG_SIM_WELL_TIE_IN_REACH_H

#include "drill_rig_sim/well/tie_in.h"

namespace drill_rig_sim
{
/// By how much a hole may miss a measured depth that is no better known (tie_in_share, tie_in_rounding) [m].
double tie_in_tolerance(double md);

/// Whether a hole of this measured depth can lead from the rotary table to a place.
bool is_within_reach(const TieIn& place, double md);

}  // namespace drill_rig_sim

#endif
