// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_UNITS_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_UNITS_H

#include <string>

#include "drill_rig_sim/math/unit_table.h"

namespace drill_rig_sim
{
/// A survey's unit of length or angle by a header's, a map's or WITSML's spelling ("feet", "mRKB", "dega"), of math/unit_table.h;
/// nullptr if it is none.
const UnitName* length_unit(const std::string& spelling);
const UnitName* angle_unit(const std::string& spelling);
/// Why a spelling is no unit, in brackets or not: `is ambiguous, allowed: gon or deg`, `is not known, allowed: rad, deg, ...`.
std::string why_no_unit(bool of_angle, const std::string& spelling);
/// Their symbols, for messages.
std::string survey_unit_names(bool of_angle);

/// In small letters (ASCII).
std::string lowered(std::string text);

}  // namespace drill_rig_sim

#endif
