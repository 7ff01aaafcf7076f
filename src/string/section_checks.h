// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_STRING_SECTION_CHECKS_H
#define DRILL_RIG_SIM_SRC_STRING_SECTION_CHECKS_H

#include <vector>

#include "drill_rig_sim/string/part.h"
#include "drill_rig_sim/well/problem.h"

namespace drill_rig_sim
{
/// Whether what is given outright of a part's section can be of one section inside its diameter.
void check_sections(const std::vector<PartSpec>& parts, ProblemList& problems);

}  // namespace drill_rig_sim

#endif
