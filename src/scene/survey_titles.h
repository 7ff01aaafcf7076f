// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_TITLES_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_TITLES_H

#include <string>

#include "problems.h"
#include "survey_units.h"

/// What the lines of a survey's file say of its table that are neither its header nor its rows.
namespace drill_rig_sim
{
/// What `said` finds in the lines above a header, comments included.
std::string said_above(const std::string& text, int header_line, std::string (*said)(const std::string&));

/// A unit of depth that such a line names, and that line's number, 0 where none does.
struct TitleUnit
{
  const UnitName* unit = nullptr;
  int line = 0;
};

/// The unit of depths in the lines above a header: `All depths in feet`, `Depth Units: ft`, `XYZ-UNITS: m, MD-UNITS: ft`.
TitleUnit unit_above(const std::string& text, int header_line);

/// A problem where one line names a well or wellbore and a later one another (`Well: A-1`, `Well: B-2`).
void check_one_well(const std::string& text, Problems& problems);

}  // namespace drill_rig_sim

#endif
