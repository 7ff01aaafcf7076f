// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_PROJECTION_H
#define DRILL_RIG_SIM_WELL_PROJECTION_H

#include <string>

#include "drill_rig_sim/well/well_spec.h"

/// The hole between the last station of a survey and its bottom, to which no survey tool comes.
namespace drill_rig_sim
{
/// Beyond the last station, about a stand [m MD].
constexpr double longest_projection = 30.5;

/// Adds a station at hole_depth where that lies up to longest_projection beyond the last one and the well is to be projected;
/// where it is nearer than least_station_spacing, the last station goes there. `straight` keeps the last direction t1.
/// `curvature` goes on with the last interval's arc: with t0 the direction before, b the angle between them over the length L of
/// the interval, the direction after a length s is
///   t = cos(b s/L) t1 + sin(b s/L) (cos(b) t1 - t0) / sin(b)
/// Returns what was done, in one line for the user, or nothing where nothing was.
std::string project_survey(WellSpec& well);

}  // namespace drill_rig_sim

#endif
