// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STRING_STRING_CHECKS_H
#define DRILL_RIG_SIM_STRING_STRING_CHECKS_H

#include <vector>

#include "drill_rig_sim/string/element_lengths.h"
#include "drill_rig_sim/string/part.h"
#include "drill_rig_sim/well/problem.h"

/// The one set of rules for a drillstring and the mesh that it is cut into.
namespace drill_rig_sim
{
constexpr double least_element_length = 0.01;  ///< [m]
constexpr int most_mesh_nodes = 40000;         ///< 20 km in elements of half a metre

/// What is wrong with a string of `parts`, bit first, that reaches over `length` from the bit's face to the top drive's shaft and
/// is cut into elements of `longest` at most: one bit, at the lower end; at most one motor and one mwd, bend and sensor inside
/// them; `fill` for the last part, whose length what the string stretches by decides; no element shorter than
/// least_element_length, no more than most_mesh_nodes nodes. Each part's values are in range by themselves. Empty when all is
/// well.
ProblemList string_problems(const std::vector<PartSpec>& parts, double length, const ElementLengths& longest);

}  // namespace drill_rig_sim

#endif
