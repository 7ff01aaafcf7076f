// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_TITLES_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_TITLES_H

#include <string>

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

/// Whether a column or a line's key names the well: Well Name, UWI, Borehole.
bool names_well(const std::string& text);

/// The first line that names another well or wellbore than a line above it (`Well: A-1`, `Well: B-2`).
struct OtherWell
{
  int line = 0;  ///< 0: all lines are of one well
  std::string well, above;
};
OtherWell other_well(const std::string& text);

}  // namespace drill_rig_sim

#endif
