// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_ANGLES_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_ANGLES_H

#include <string>

namespace drill_rig_sim
{
/// Degrees, minutes and seconds (45°30'15") as degrees; with `bearing`, one of a quadrant too (N45.5E, S 10°30' W), clockwise
/// from north. False if it is neither.
bool read_degrees(const std::string& cell, bool decimal_commas, bool bearing, double& degrees);

}  // namespace drill_rig_sim

#endif
