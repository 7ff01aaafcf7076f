// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_HEADER_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_HEADER_H

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/survey_format.h"
#include "survey_path.h"
#include "survey_rows.h"
#include "survey_units.h"

namespace drill_rig_sim
{
/// What a cell of a header says.
struct HeaderCell
{
  std::string text;
  std::optional<std::size_t> quantity;                   ///< of SurveyQuantity
  bool own = false;                                      ///< one of this package's own names (md_m)
  bool weak = false;                                     ///< "Depth", "Dir": only where no other column is
  const UnitName* unit = nullptr;                        ///< nullptr: it names none
  std::string unit_in_brackets;                          ///< as it is written, "" without one
  std::string north;                                     ///< "true", "grid" or "magnetic" of an azimuth with such a name
  SurveyPath path = SurveyPath::unsaid;                  ///< "Plan MD", "Actual MD"
  std::optional<std::size_t> quantity_without_brackets;  ///< where what stands in brackets is no unit: MD (fathoms)
};

/// Reads a cell by the usual spellings: MD (ft), Incl [deg], azimuth_deg, "Azi Grid", N/S, ...
HeaderCell header_cell(const std::string& text);

/// Where a header has the quantities of a survey.
struct SurveyHeader
{
  std::array<std::optional<std::size_t>, survey_quantities> place;
  std::array<const UnitName*, survey_quantities> unit{};
  std::vector<HeaderCell> cells;
  SurveyPath path = SurveyPath::unsaid;  ///< of the columns of angles
  std::string wrong;                     ///< why it is no header of a survey, in one line; else empty
  std::string wrong_where;               ///< the column of that
  std::size_t found = 0;                 ///< how many of measured depth, inclination and azimuth it names, once or more
};

/// Finds the columns by the format's map, else by the usual spellings.
SurveyHeader find_columns(const std::vector<std::string>& cells, const SurveyFormat& format);

/// Takes the units out of a line of them below the header, "(ft);(deg);(deg)"; false if the line is none.
bool take_units(const std::vector<std::string>& cells, SurveyHeader& header);

/// The column whose cell in such a line is no unit that is known while another's is; none where the line is not of units.
std::optional<std::size_t> unknown_unit(const std::vector<std::string>& cells, const SurveyHeader& header);

/// "grid" or "magnetic" where a line above the header says that azimuths count from that north: "North reference: Grid North".
/// Else "".
std::string north_of_line(const std::string& line);

/// "mean sea level", "ground level" or "the seabed" where a line above the header says that measured depths count from there:
/// "Depth Reference: MSL". Else "".
std::string datum_of_line(const std::string& line);

/// Why the columns' units are not clear, in one line; empty if they can. Those of angles may be left to the values.
std::string unit_problem(const SurveyHeader& header, std::size_t quantity);

/// What the columns were taken for, for messages: `md "MD (ft)" [ft], ...`.
std::string description(const SurveyHeader& header);

}  // namespace drill_rig_sim

#endif
