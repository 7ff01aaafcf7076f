// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_SPLIT_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_SPLIT_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace drill_rig_sim
{
using Cells = std::vector<std::string>;

/// Without blanks at both ends.
std::string trimmed(const std::string& text);

/// The cells of a line, without blanks at their ends. A blank as delimiter stands for any number of blanks.
Cells split(const std::string& line, char delimiter);

/// The names of columns that blanks align, out of lines one below the other: each name stands above a cell of `row`, a line of
/// data. Names in a line are parted by two blanks or more. Empty where `row` has fewer than three cells or begins with no number.
Cells names_by_place(const std::vector<std::string>& lines, const std::string& row);

/// The place of a cell that one of two lines of aligned columns leaves empty: the cells before it overlap, in the gap after them
/// the other line has its whole cell, and the next cell stands at the column after that. None where no cell is left out, where
/// the lines have different numbers of cells, or hold tabs.
std::optional<std::size_t> place_left_out(const std::string& line, const std::string& other);

}  // namespace drill_rig_sim

#endif
