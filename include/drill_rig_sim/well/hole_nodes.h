// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_HOLE_NODES_H
#define DRILL_RIG_SIM_WELL_HOLE_NODES_H

#include <vector>

#include "drill_rig_sim/well/well_spec.h"
#include "drill_rig_sim/well/survey.h"
#include "drill_rig_sim/well/well_node.h"

namespace drill_rig_sim
{
/// Length over which the hole passes from one section to the next [m].
constexpr double section_step = 1e-3;
/// How closely the nodes' cubic Hermite follows the minimum-curvature arcs [m]; half the 0.1 mm that is asked for.
constexpr double hermite_tolerance = 5e-5;

/// Nodes from the first station down to exactly `spec.hole_depth`: one at each station, two `section_step` apart where a section
/// ends (the upper one at its end) and where the hole's last diameter gives way to the bit's, and as many between as the cubic
/// Hermite needs to stay within `hermite_tolerance` of the arc. Interpolating an arc of curvature k over a length h by position
/// and tangent errs by k^3 h^4 / 384 at most (the cubic Hermite's remainder). Throws std::invalid_argument with one line (what,
/// where, what is allowed) if well_problems() (well_checks.h) finds anything.
std::vector<WellNode> place_nodes(const WellSpec& spec, const Survey& survey, double bit_radius);

}  // namespace drill_rig_sim

#endif
