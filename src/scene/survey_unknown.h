// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_UNKNOWN_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_UNKNOWN_H

#include <string>
#include <vector>

#include "survey_body.h"

namespace drill_rig_sim
{
/// A table whose names of columns are not known: the names are above rows of numbers, as many as these.
struct UnknownTable
{
  std::vector<std::string> names;  ///< empty: the file holds no such table
  int line = 0;                    ///< of the names, in the file
  CsvDelimiter delimiter{',', ","};
};

/// `; it has A, B, C (delimiter ,)` for a message; empty without names.
std::string names_listed(const std::vector<std::string>& names, const CsvDelimiter& delimiter);

/// The first such table of these lines, by one of these delimiters.
UnknownTable unknown_table(const std::vector<CsvLine>& lines, const CsvDelimiters& delimiters);

}  // namespace drill_rig_sim

#endif
