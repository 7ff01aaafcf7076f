// SPDX-License-Identifier: BSD-3-Clause
#include "survey_las.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "survey_csv.h"
#include "survey_split.h"

namespace drill_rig_sim
{
namespace
{
// "DEPT.M   : measured depth": mnemonic, unit and what stands up to the colon
struct LasLine
{
  std::string name, unit, value;
};

LasLine las_line(const std::string& text)
{
  const std::size_t point = text.find('.');
  if (point == std::string::npos) return {};
  const std::size_t end = std::min(text.find_first_of(" \t:", point), text.size()),
                    colon = std::min(text.rfind(':'), text.size());
  return {trimmed(text.substr(0, point)), text.substr(point + 1, end - point - 1),
          colon > end ? trimmed(text.substr(end, colon - end)) : ""};
}

bool same_number(const std::string& one, const std::string& other)
{
  double a = 0.0, b = 0.0;
  return one == other || (std::istringstream(one) >> a && std::istringstream(other) >> b && a == b);
}

// What the sections before the data say.
struct LasHead
{
  std::string version = "2.0", null, names;  // names of the curves with their units, parted by semicolons
  bool wrapped = false, commas = false;

  void take(char section, const std::string& text)
  {
    const LasLine line = las_line(text);
    if (section == 'V' && line.name == "VERS") version = line.value;
    if (section == 'V' && line.name == "WRAP") wrapped = lowered(line.value) == "yes";
    if (section == 'V' && line.name == "DLM") commas = lowered(line.value) == "comma";
    if (section == 'W' && line.name == "NULL") null = line.value;
    if (section == 'C' && !line.name.empty())
      names += (names.empty() ? "" : ";") + line.name + (line.unit.empty() ? "" : " (" + line.unit + ")");
  }
};

// a line of the data, its values parted by semicolons
std::string row_of(const std::string& text, const LasHead& head)
{
  std::string row;
  for (const std::string& cell : split(text, head.commas ? ',' : ' '))
    row += (row.empty() ? "" : ";") + (!head.null.empty() && same_number(cell, head.null) ? "-" : cell);
  return row;
}
}  // namespace

SurveyRows read_survey_las(const std::string& text, const SurveyFormat& format, Problems& problems)
{
  LasHead head;
  std::string table;  // a line for each of the file, so that their numbers stay
  char section = ' ';
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); table += '\n')
  {
    line = trimmed(line);
    if (line.empty() || line[0] == '#') continue;
    if (line[0] == '~')
    {
      section = line.size() > 1 ? static_cast<char>(std::toupper(static_cast<unsigned char>(line[1]))) : ' ';
      if (section == 'A') table += head.names;
    }
    else if (section == 'A')
      table += row_of(line, head);
    else
      head.take(section, line);
  }
  if (head.wrapped || head.version[0] == '3' || head.names.empty())
    problems.add_at(1, "",
                    "begins as a LAS file and " +
                        std::string(head.wrapped         ? "wraps its lines"
                                    : head.names.empty() ? "has no curves (~C)"
                                                         : "is LAS 3") +
                        ", needed: LAS 1.2 or 2.0 without wrapped lines, or " + needed_survey);
  if (!problems.empty()) return {};
  SurveyFormat of_table = format;
  of_table.delimiter = ";";
  return read_survey_csv(table, of_table, problems);
}

}  // namespace drill_rig_sim
