// SPDX-License-Identifier: BSD-3-Clause
#include "survey_lines.h"

#include <algorithm>
#include <cstring>

#include "drill_rig_sim/well/well_checks.h"
#include "survey_split.h"

namespace drill_rig_sim
{
namespace
{
// a column that numbers the stations may be called #
bool is_comment(const std::string& text)
{
  const bool is_name = text.size() > 1 && std::strchr(",;|\t\"", text[1]) != nullptr;
  return (text[0] == '#' && !is_name) || text[0] == '!' || text[0] == '%' || text.compare(0, 2, "//") == 0;
}

// of signs that part a header from its rows
bool is_rule(const std::string& text)
{
  const bool has_run =
      text.find("---") != std::string::npos || text.find("===") != std::string::npos || text.find("___") != std::string::npos;
  return has_run && text.find_first_not_of(" \t\r,;|+-=_") == std::string::npos;
}

// whether a cell in quotes goes on in the next line: "MD / (ft)", as spreadsheets write names in two lines
bool ends_in_quotes(const std::string& line)
{
  bool quoted = false;
  char before = ',';
  for (const char c : line)
  {
    if (c == '"' && (quoted || std::strchr(",;\t|", before)))
    {
      quoted = !quoted;
      before = c;
    }
    else if (c != ' ' && c != '\r')
      before = c;
  }
  return quoted;
}

// the end of the line that begins at `begin`, with those that belong to a cell in quotes
std::size_t end_of_line(const std::string& text, std::size_t begin, char end)
{
  constexpr int most_lines = 12;  // of a header with a cell in quotes for each column
  const std::size_t first = std::min(text.find(end, begin), text.size());
  std::size_t last = first;
  for (int n = 1; n < most_lines; ++n)
  {
    if (!ends_in_quotes(text.substr(begin, last - begin))) return last;
    if (last == text.size()) break;
    last = std::min(text.find(end, last + 1), text.size());
  }
  return first;
}
}  // namespace

std::vector<CsvLine> lines_of(const std::string& text)
{
  const char end = text.find('\n') == std::string::npos ? '\r' : '\n';
  std::vector<CsvLine> lines;
  std::size_t begin = 0;
  for (int number = 1; begin < text.size() && lines.size() <= most_stations + most_lines_above_header; ++number)
  {
    const std::size_t last = end_of_line(text, begin, end);
    std::string line = text.substr(begin, last - begin);
    const auto further = static_cast<int>(std::count(line.begin(), line.end(), end));
    std::replace(line.begin(), line.end(), '\f', ' ');  // begins a page
    std::replace(line.begin(), line.end(), end, ' ');
    if (line.find_first_not_of(" \t\r\",;") != std::string::npos && !is_rule(line) && !is_comment(trimmed(line)))
      lines.push_back({number, line});
    number += further;
    begin = last + 1;
  }
  return lines;
}

}  // namespace drill_rig_sim
