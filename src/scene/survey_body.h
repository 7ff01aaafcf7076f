// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_BODY_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_BODY_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "problems.h"
#include "survey_header.h"
#include "survey_rows.h"

namespace drill_rig_sim
{
/// A line of a file that is neither empty nor a comment.
struct CsvLine
{
  int number = 0;
  std::string text;
};

struct CsvDelimiter
{
  char character;
  const char* name;  ///< for messages
};

using CsvDelimiters = std::array<CsvDelimiter, 5>;

/// Where a survey's table stands among the lines of its file.
struct CsvTable
{
  std::size_t first_name = 0;  ///< first of the lines with the names of the columns
  std::size_t names = 1;       ///< how many lines these are
  std::size_t first_row = 0;   ///< of the lines
  int line = 0;                ///< of the header, in the file; 0: there is none
  CsvDelimiter delimiter{',', ","};
  SurveyHeader header;
};

/// Takes the rows below a header into `survey.rows`. Texts that are followed by the same header again (the foot and the head of
/// a page) or by no station are skipped and reported. What is wrong goes to `problems`: a row of another number of cells, a cell
/// that is left out of aligned columns, rows of several wells.
void take_rows(const std::vector<CsvLine>& lines, const CsvTable& table, const SurveyFormat& format, SurveyRows& survey,
               Problems& problems);

}  // namespace drill_rig_sim

#endif
