// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_LINES_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_LINES_H

#include <string>
#include <vector>

#include "survey_body.h"

namespace drill_rig_sim
{
constexpr int most_lines_above_header = 50;

/// The lines of a table that are neither empty nor comments nor rules; they end in LF, CR LF or CR. A cell in quotes may go on in
/// the next line.
std::vector<CsvLine> lines_of(const std::string& text);

}  // namespace drill_rig_sim

#endif
