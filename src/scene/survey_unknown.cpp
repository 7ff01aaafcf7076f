// SPDX-License-Identifier: BSD-3-Clause
#include "survey_unknown.h"

#include <algorithm>

#include "survey_split.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t most_lines = 50, fewest_columns = 3, most_below = 2;  // between names and numbers a line of units

bool is_number(const std::string& cell)
{
  double value = 0.0;
  return read_cell(cell, true, value) == CellKind::number;
}

std::size_t numbers_in(const Cells& cells)
{
  return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), is_number));
}

bool are_above_numbers(const Cells& names, std::size_t line, const std::vector<CsvLine>& lines, char delimiter)
{
  for (std::size_t i = line + 1; i < lines.size() && i <= line + most_below; ++i)
  {
    const Cells cells = split(lines[i].text, delimiter);
    if (cells.size() == names.size() && numbers_in(cells) >= fewest_columns) return true;
  }
  return false;
}
}  // namespace

std::string names_listed(const Cells& names, const CsvDelimiter& delimiter)
{
  std::string text;
  for (const std::string& name : names)
  {
    if (text.size() > 200)
    {
      text += ", ...";
      break;
    }
    if (!name.empty()) text += (text.empty() ? "" : ", ") + shortened(name);
  }
  return text.empty() ? "" : "; it has " + text + " (delimiter " + delimiter.name + ")";
}

UnknownTable unknown_table(const std::vector<CsvLine>& lines, const CsvDelimiters& delimiters)
{
  for (std::size_t i = 0; i < lines.size() && i < most_lines; ++i)
  {
    for (const CsvDelimiter& delimiter : delimiters)
    {
      const Cells names = split(lines[i].text, delimiter.character);
      const bool are_names = names.size() >= fewest_columns && numbers_in(names) == 0;
      if (are_names && are_above_numbers(names, i, lines, delimiter.character)) return {names, lines[i].number, delimiter};
    }
  }
  return {};
}

}  // namespace drill_rig_sim
