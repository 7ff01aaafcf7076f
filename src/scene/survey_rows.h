// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_ROWS_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_ROWS_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "problems.h"
#include "survey_units.h"

namespace drill_rig_sim
{
/// What a survey says of a station; indices of arrays.
enum SurveyQuantity : std::size_t
{
  survey_md,
  survey_inclination,
  survey_azimuth,
  survey_north,
  survey_east,
  survey_tvd,
  survey_quantities
};
/// The first three are needed; the others are the tie-in, of the first station.
constexpr std::size_t needed_quantities = 3;
constexpr std::array<const char*, survey_quantities> quantity_keys = {"md", "inclination", "azimuth", "north", "east", "tvd"};
/// For messages: what a survey's file should have been, where a map of its columns is given, and what its nulls need.
constexpr const char* needed_survey =
    "a survey: a table with the columns md_m, inclination_deg, azimuth_deg, or a WITSML trajectory";
constexpr const char* how_to_map = "in a scene's well.survey, or --columns MAP.yaml";
constexpr const char* how_to_pass_over = "to skip it, use pass_over: true in a scene's well.survey, or --pass-over";

constexpr bool is_angle(std::size_t quantity)
{
  return quantity == survey_inclination || quantity == survey_azimuth;
}

/// A station as its file has it.
struct SurveyRow
{
  int line = 0;
  std::array<std::string, survey_quantities> cells;
  std::array<const UnitName*, survey_quantities> units{};
  std::vector<std::string> marks;  ///< cells of SurveyRows::marks
};

/// A survey as its file has it, before its cells are numbers.
struct SurveyRows
{
  std::array<std::string, survey_quantities> names;  ///< of the columns, for messages; empty: there is none
  std::vector<std::string> marks;                    ///< names of columns that mark stations as good or bad, planned or drilled
  std::vector<SurveyRow> rows;
  bool decimal_commas = false;  ///< a comma in a cell is its decimal sign
  std::string taken;            ///< what the columns were taken for, for messages
  std::vector<std::string> remarks;
};

/// Tells nulls and cells that are no number apart.
enum class CellKind
{
  number,
  missing,  ///< empty, or a null value such as -999.25
  wrong
};

/// A cell with a typeset minus sign or dash in front of its number, with a hyphen instead.
std::string with_hyphen(const std::string& cell);

/// A cell's number, in its own unit. nan and inf are wrong.
CellKind read_cell(const std::string& cell, bool decimal_commas, double& value);

/// Remark on azimuths from another north than the true one ("grid", "magnetic"): they are taken as they stand.
std::string north_remark(const std::string& north);

/// A cell for a message: what could not be read as a number, but no text, for the file may be a wrong one.
std::string shown_cell(const std::string& cell);

/// Why a cell that read_cell() calls wrong is no number.
std::string number_problem(const std::string& cell);

}  // namespace drill_rig_sim

#endif
