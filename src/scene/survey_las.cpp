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

// What a line begins, of "~Inclinometry_Data[1] | Inclinometry_Definition[1]"; in LAS 1.2 and 2.0 the first letter counts.
enum class LasSection
{
  version,
  well,
  curves,
  data,
  other
};

// in small letters without blanks, up to the bar
std::string las_title(const std::string& line)
{
  std::string title;
  for (const char c : lowered(line.substr(1, line.find('|') - 1)))
    if (c != ' ' && c != '\t') title += c;
  return title;
}

LasSection section_of(const std::string& line, bool inclinometry)
{
  const std::string title = las_title(line);
  if (inclinometry && title.rfind("inclinometry_", 0) == 0)
    return title.find("_definition") != std::string::npos ? LasSection::curves
           : title.find("_data") != std::string::npos     ? LasSection::data
                                                          : LasSection::other;
  const char letter = title.empty() ? ' ' : title[0];
  if (letter == 'v') return LasSection::version;
  if (letter == 'w') return LasSection::well;
  if (inclinometry) return LasSection::other;
  return letter == 'c' || title.rfind("log_definition", 0) == 0 ? LasSection::curves
         : letter == 'a' || title.rfind("log_data", 0) == 0     ? LasSection::data
                                                                : LasSection::other;
}

// What the sections before the data say.
struct LasHead
{
  std::string version = "2.0", null, names;  // names of the curves with their units, parted by semicolons
  std::size_t curves = 0;
  char delimiter = ' ';
  bool wrapped = false;

  void take(LasSection section, const std::string& text)
  {
    const LasLine line = las_line(text);
    if (section == LasSection::version && line.name == "VERS") version = line.value;
    if (section == LasSection::version && line.name == "WRAP") wrapped = lowered(line.value) == "yes";
    if (section == LasSection::version && line.name == "DLM") delimiter = delimiter_of(lowered(line.value));
    if (section == LasSection::well && line.name == "NULL") null = line.value;
    if (section != LasSection::curves || line.name.empty()) return;
    ++curves;
    names += (names.empty() ? "" : ";") + line.name + (line.unit.empty() ? "" : " (" + line.unit + ")");
  }

  static char delimiter_of(const std::string& word) { return word == "comma" ? ',' : word == "tab" ? '\t' : ' '; }
};

// cells of the data as a row, parted by semicolons
std::string row_of(const Cells& cells, const LasHead& head)
{
  std::string row;
  bool first = true;
  for (const std::string& cell : cells)
  {
    row += (first ? "" : ";") + (!head.null.empty() && same_number(cell, head.null) ? "-" : cell);
    first = false;
  }
  return row;
}

/// Puts lines of the data together until they hold a value of each curve, where the file wraps its lines.
class LasRows
{
public:
  // the row that a line ends, empty while it goes on
  std::string take(const std::string& line, const LasHead& head)
  {
    const Cells cells = split(line, head.delimiter);
    if (!head.wrapped) return row_of(cells, head);
    pending_.insert(pending_.end(), cells.begin(), cells.end());
    return pending_.size() < head.curves ? "" : rest(head);
  }

  // what the last line leaves open
  std::string rest(const LasHead& head)
  {
    const std::string row = row_of(pending_, head);
    pending_.clear();
    return row;
  }

private:
  Cells pending_;
};

// whether a line begins a section of data of a survey of LAS 3.0; their number is counted
std::size_t inclinometries(const std::string& text)
{
  std::size_t count = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line[0] == '~' && las_title(line).rfind("inclinometry_data", 0) == 0) ++count;
  return count;
}

// The file as a table: a line for each of its own, so that their numbers stay; what stands above the data as comments.
std::string table_of(const std::string& text, bool inclinometry, LasHead& head)
{
  std::string table;
  LasSection section = LasSection::other;
  LasRows rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); table += '\n')
  {
    line = trimmed(line);
    if (line.empty() || line[0] == '#') continue;
    if (line[0] == '~')
    {
      section = section_of(line, inclinometry);
      if (section == LasSection::data) table += head.names;
    }
    else if (section == LasSection::data)
      table += rows.take(line, head);
    else
    {
      head.take(section, line);
      table += "# " + line;
    }
  }
  if (!table.empty()) table.insert(table.size() - 1, rows.rest(head));  // before the end of the last line
  return table;
}
}  // namespace

SurveyRows read_survey_las(const std::string& text, const SurveyFormat& format, Problems& problems)
{
  LasHead head;
  const std::size_t surveys = inclinometries(text);
  const std::string table = table_of(text, surveys > 0, head);
  const bool known = !head.version.empty() && head.version[0] >= '1' && head.version[0] <= '3';
  const std::string wrong = !known        ? "is LAS " + shortened(head.version) + ", allowed: 1.2, 2.0 and 3.0"
                            : surveys > 1 ? "holds " + std::to_string(surveys) + " surveys (~Inclinometry_Data), needed: one"
                            : head.names.empty() ? "has no curves (~C), needed: " + std::string(needed_survey)
                                                 : "";
  if (!wrong.empty()) problems.add_at(1, "", "begins as a LAS file and " + wrong);
  if (!problems.empty()) return {};
  SurveyFormat of_table = format;
  of_table.delimiter = ";";
  return read_survey_csv(table, of_table, problems);
}

}  // namespace drill_rig_sim
