// SPDX-License-Identifier: BSD-3-Clause
#include "survey_csv.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/well_checks.h"
#include "survey_body.h"
#include "survey_digits.h"
#include "survey_header.h"
#include "survey_lines.h"
#include "survey_marks.h"
#include "survey_split.h"
#include "survey_titles.h"
#include "survey_unknown.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t most_lines_of_header = 3;
constexpr double same_unit = 1e-5;  // share by which the foot of surveys differs from the international one, and more
constexpr CsvDelimiters delimiters = {{{',', ","}, {';', ";"}, {'\t', "tab"}, {'|', "bar"}, {' ', "space"}}};

// of columns that blanks align, by the first row of data below them
Cells joined_by_place(const std::vector<CsvLine>& lines, std::size_t first, std::size_t count)
{
  Cells texts;
  for (std::size_t i = first; i < first + count; ++i) texts.push_back(lines[i].text);
  // between them a line of units
  for (std::size_t i = first + count; i < lines.size() && i < first + count + 2; ++i)
  {
    Cells names = names_by_place(texts, lines[i].text);
    if (!names.empty()) return names;
  }
  return {};
}

// the cells of lines one below the other, as one header
Cells joined(const std::vector<CsvLine>& lines, std::size_t first, std::size_t count, char delimiter)
{
  if (delimiter == ' ') return joined_by_place(lines, first, count);
  Cells names;
  for (std::size_t i = first; i < first + count; ++i)
  {
    const Cells cells = split(lines[i].text, delimiter);
    if (cells.size() > names.size()) names.resize(cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k) names[k] += (names[k].empty() || cells[k].empty() ? "" : " ") + cells[k];
  }
  return names;
}

// The header where its names go over two or three lines; one that names no column where there is none.
CsvTable find_header_over_lines(const std::vector<CsvLine>& lines, const SurveyFormat& format)
{
  for (std::size_t count = 2; count <= most_lines_of_header; ++count)
  {
    for (std::size_t i = 0; i + count <= lines.size() && i < most_lines_above_header; ++i)
    {
      for (const CsvDelimiter& delimiter : delimiters)
      {
        if (!format.delimiter.empty() && format.delimiter != delimiter.name) continue;
        SurveyHeader header = find_columns(joined(lines, i, count, delimiter.character), format);
        if (header.found == needed_quantities) return {i, count, i + count, lines[i].number, delimiter, std::move(header)};
      }
    }
  }
  return {};
}

// A line that calls a column only Depth, with the line above it where that says which depth: Measured, True Vertical.
CsvTable with_line_above(CsvTable table, const std::vector<CsvLine>& lines, const SurveyFormat& format)
{
  const std::size_t place = *table.header.place[survey_md];
  if (!table.header.cells[place].weak || table.first_row < 2 || !format.md.column.empty()) return table;
  SurveyHeader both = find_columns(joined(lines, table.first_row - 2, 2, table.delimiter.character), format);
  if (both.cells.size() < table.header.cells.size()) return table;
  const HeaderCell& cell = both.cells[place];
  if (cell.quantity && !cell.weak && both.place[survey_inclination] && both.place[survey_azimuth]) table.header = std::move(both);
  return table;
}

// A line that names columns twice, with the path of each by the line above it: Plan and Actual over groups of columns.
CsvTable with_paths_above(CsvTable table, const std::vector<CsvLine>& lines, const SurveyFormat& format)
{
  if (table.header.wrong.empty() || table.first_row < 2 || table.delimiter.character == ' ') return table;
  const Cells groups = split(lines[table.first_row - 2].text, table.delimiter.character);
  Cells names = split(lines[table.first_row - 1].text, table.delimiter.character);
  std::string group;
  bool any = false;
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    if (k < groups.size() && !groups[k].empty()) group = groups[k];
    const bool of_path = path_of_cell(group) != SurveyPath::unsaid;
    if (of_path) names[k].insert(0, std::string(path_word(path_of_cell(group))) + " ");
    any = any || of_path;
  }
  if (any) table.header = find_columns(names, format);
  return table;
}

// The header in the first lines: the first that names all columns, else lines that do so together, else the one that names most
// of them.
CsvTable find_header(const std::vector<CsvLine>& lines, const SurveyFormat& format)
{
  CsvTable best;
  for (std::size_t i = 0; i < lines.size() && i < most_lines_above_header; ++i)
  {
    for (const CsvDelimiter& delimiter : delimiters)
    {
      if (!format.delimiter.empty() && format.delimiter != delimiter.name) continue;
      SurveyHeader header = find_columns(split(lines[i].text, delimiter.character), format);
      const bool first = best.line == 0;
      if (!first && header.found <= best.header.found) continue;
      best = {i, 1, i + 1, lines[i].number, delimiter, std::move(header)};
      if (best.header.found == needed_quantities)
      {
        best = with_paths_above(std::move(best), lines, format);
        return best.header.place[survey_md] ? with_line_above(std::move(best), lines, format) : best;
      }
    }
  }
  CsvTable over_lines = find_header_over_lines(lines, format);
  return over_lines.line == 0 ? best : over_lines;
}

// What is wrong with a header. A line that names no column may be of any file: it is shown above rows of numbers only.
void add_header_problem(const CsvTable& table, const std::vector<CsvLine>& lines, Problems& problems)
{
  const SurveyHeader& header = table.header;
  if (header.wrong != "no such column in the header") return problems.add_at(table.line, header.wrong_where, header.wrong);
  Cells names;
  for (const HeaderCell& cell : header.cells) names.push_back(cell.text);
  const bool none = header.found == 0;
  const UnknownTable unknown = none ? unknown_table(lines, delimiters) : UnknownTable{names, table.line, table.delimiter};
  const std::string found = names_listed(unknown.names, unknown.delimiter);
  problems.add_at(
      unknown.line > 0 ? unknown.line : table.line, none ? "" : header.wrong_where,
      (none ? "no line names measured depth, inclination and azimuth" : header.wrong) + found +
          "; needed: md_m, inclination_deg, azimuth_deg or the usual names of these, with their units, or a map `columns` (" +
          how_to_map + ")");
}

// Angles without a unit are degrees where they are too large for radians.
void settle_angles(SurveyHeader& header, const SurveyRows& survey, Problems& problems, int line)
{
  double largest = 0.0;
  bool any_named = false;
  for (const std::size_t i : {survey_inclination, survey_azimuth})
  {
    any_named = any_named || header.unit[i];
    for (const SurveyRow& row : survey.rows)
    {
      double value = 0.0;
      if (read_cell(row.cells[i], survey.decimal_commas, value) == CellKind::number) largest = std::max(largest, std::abs(value));
    }
  }
  for (const std::size_t i : {survey_inclination, survey_azimuth})
  {
    const UnitName* other = header.unit[i == survey_azimuth ? survey_inclination : survey_azimuth];
    if (header.unit[i]) continue;
    if (problems.empty() && !any_named && largest > 0.0 && largest <= 2.0 * pi + 1e-3)
      problems.add_at(line, header.cells[*header.place[i]].text, unit_problem(header, i));
    header.unit[i] = any_named ? other : angle_unit("deg");
  }
}

// 1,000 is a thousand to some and one to others
bool may_be_thousands(const std::string& cell)
{
  const std::size_t comma = cell.find(',');
  const std::size_t first = cell.find_first_of("123456789");
  return comma != std::string::npos && comma >= 1 && comma <= 3 && first < comma && cell.size() == comma + 4 &&
         cell.find('.') == std::string::npos;
}

// whether cells in quotes between commas have decimal commas
bool has_quoted_commas(const SurveyRows& survey)
{
  bool comma = false;
  for (const SurveyRow& row : survey.rows)
    for (std::size_t i = 0; i < needed_quantities; ++i)
    {
      if (row.cells[i].find('.') != std::string::npos) return false;
      comma = comma || row.cells[i].find(',') != std::string::npos;
    }
  return comma;
}

// A file has decimal points or decimal commas: beside these, 1.000 may be a thousand. Cells that are no numbers are reported
// later.
void check_points(const SurveyRows& survey, Problems& problems)
{
  const auto find = [&](char sign) -> std::pair<int, std::string>
  {
    double value = 0.0;
    for (const SurveyRow& row : survey.rows)
      for (std::size_t i = 0; i < needed_quantities; ++i)
        if (row.cells[i].find(sign) != std::string::npos && read_cell(row.cells[i], true, value) == CellKind::number)
          return {row.line, row.cells[i]};
    return {0, ""};
  };
  const auto [comma_line, comma] = find(',');
  const auto [point_line, point] = find('.');
  if (comma_line == 0 || point_line == 0) return;
  problems.add_at(std::max(comma_line, point_line), "",
                  "the file mixes decimal commas and decimal points (got " + shown_cell(comma) + " and " + shown_cell(point) +
                      "), allowed: one of them");
}

// Depths must not all look like thousands where nothing else shows that a comma is a decimal one.
void check_commas(const SurveyRows& survey, Problems& problems)
{
  const SurveyRow* doubtful = nullptr;
  for (const SurveyRow& row : survey.rows)
  {
    for (const std::size_t i : {survey_inclination, survey_azimuth})
      if (row.cells[i].find(',') != std::string::npos) return;
    const std::string& depth = row.cells[survey_md];
    if (depth.find(',') != std::string::npos && !may_be_thousands(depth)) return;
    if (may_be_thousands(depth) && !doubtful) doubtful = &row;
  }
  if (doubtful)
    problems.add_at(doubtful->line, survey.names[survey_md],
                    "the comma may be a decimal comma or a thousands separator (got " + shown_cell(doubtful->cells[survey_md]) +
                        "), needed: decimal points and no thousands separators");
}

// `MD, m,Inc, deg`: names that hold the delimiter make two columns of one, as decimal commas do in the rows.
void check_names(const CsvTable& table, Problems& problems)
{
  if (table.delimiter.character != ',') return;
  const SurveyHeader& header = table.header;
  std::size_t parted = 0;
  std::string first;
  for (std::size_t i = 0; i < needed_quantities; ++i)
  {
    const std::size_t next = *header.place[i] + 1;
    if (next >= header.cells.size() || !unit_for(i, header.cells[next].text)) continue;
    if (parted++ == 0) first = header.cells[next - 1].text + ", " + header.cells[next].text;
  }
  if (parted > 1)
    problems.add_at(table.line, first,
                    "a name contains the delimiter, a comma before the unit, needed: names in quotes, or units in brackets");
}

// The line of units below the header, where there is one; false if it has one that is not known.
bool take_unit_line(const std::vector<CsvLine>& lines, CsvTable& table, Problems& problems)
{
  if (table.first_row >= lines.size()) return true;
  const CsvLine& line = lines[table.first_row];
  const Cells cells = split(line.text, table.delimiter.character);
  if (take_units(cells, table.header))
  {
    ++table.first_row;
    return true;
  }
  const auto unknown = unknown_unit(cells, table.header);
  if (!unknown) return true;
  const std::size_t place = *table.header.place[*unknown];
  problems.add_at(line.number, table.header.cells[place].text,
                  "unit \"" + shortened(cells[place]) + "\" " + why_no_unit(is_angle(*unknown), cells[place]));
  return false;
}

// the unit of depth where only a line above the names has it; reported where that is another one
void take_unit_above(const std::string& text, CsvTable& table, const SurveyFormat& format, SurveyRows& survey)
{
  const TitleUnit above = unit_above(text, table.line);
  const UnitName*& unit = table.header.unit[survey_md];
  if (!above.unit || !format.md.unit.empty()) return;
  const std::string line = "line " + std::to_string(above.line) + " says that depths are in " + above.unit->name;
  if (!unit)
    survey.remarks.push_back(line + ": they are read so");
  else if (std::abs(unit->factor() / above.unit->factor() - 1.0) > same_unit)
    survey.remarks.push_back(line + ", the names of the columns say " + unit->name + ": they are read in " + unit->name +
                             "; is that right?");
  if (!unit) unit = above.unit;
}

// what the reader has to report of a header
void add_remarks(const CsvTable& table, const std::string& text, const SurveyFormat& format, SurveyRows& survey)
{
  const bool plan = format.plan;
  const SurveyHeader& header = table.header;
  const HeaderCell& depth = header.cells[*header.place[survey_md]];
  const HeaderCell& azimuth = header.cells[*header.place[survey_azimuth]];
  if (depth.weak && format.md.column.empty())
    survey.remarks.push_back("\"" + shortened(depth.text) + "\" is read as measured depth");
  if (header.path != SurveyPath::unsaid && header.path != (plan ? SurveyPath::planned : SurveyPath::actual))
    survey.remarks.push_back("its columns are " + std::string(path_word(header.path)) + " ones: they are read as the " +
                             (plan ? "plan" : "survey"));
  const std::string title = said_above(text, table.line, path_of_title);
  // a title over a group of columns is not one of the others
  const bool of_group = std::any_of(header.cells.begin(), header.cells.end(),
                                    [](const HeaderCell& cell) { return cell.path != SurveyPath::unsaid; });
  if (header.path == SurveyPath::unsaid && !of_group && !title.empty() &&
      title != path_word(plan ? SurveyPath::planned : SurveyPath::actual))
    survey.remarks.push_back("a line above its names calls it " + title + ": it is read as the " + (plan ? "plan" : "survey"));
  const std::string north = azimuth.north.empty() ? said_above(text, table.line, north_of_line) : azimuth.north;
  const std::string datum = said_above(text, table.line, datum_of_line);
  if (!datum.empty())
    survey.remarks.push_back("measured depths count from " + datum +
                             ", as the file says, and are not converted: they are taken from the rotary table");
  if (north == "grid" || north == "magnetic") survey.remarks.push_back(north_remark(north));
  std::string angles;
  for (const std::size_t i : {survey_inclination, survey_azimuth})
    if (!header.unit[i])
      angles += (angles.empty() ? "" : " and ") + std::string("\"") + shortened(header.cells[*header.place[i]].text) + "\"";
  const bool one = header.unit[survey_inclination] || header.unit[survey_azimuth];
  if (!angles.empty())
    survey.remarks.push_back(angles + (one ? " has no unit and is" : " have no unit and are") + " read as degrees");
}
}  // namespace

SurveyRows read_survey_csv(const std::string& text, const SurveyFormat& format, Problems& problems)
{
  SurveyRows survey;
  const std::vector<CsvLine> lines = lines_of(text);
  if (lines.empty())
  {
    problems.add_at(0, "", std::string("is empty, needed: ") + needed_survey);
    return survey;
  }
  CsvTable table = find_header(lines, format);
  SurveyHeader& header = table.header;
  if (!header.wrong.empty())
  {
    add_header_problem(table, lines, problems);
    return survey;
  }
  for (std::size_t i = 0; i < survey_quantities; ++i)
    if (header.place[i]) survey.names[i] = header.cells[*header.place[i]].text;
  check_names(table, problems);
  if (!problems.empty()) return survey;
  survey.decimal_commas = table.delimiter.character != ',';
  if (!take_unit_line(lines, table, problems)) return survey;
  take_unit_above(text, table, format, survey);
  const std::string no_unit = unit_problem(header, survey_md);
  if (!no_unit.empty()) problems.add_at(table.line, survey.names[survey_md], no_unit);
  if (const OtherWell other = other_well(text); other.line > 0)
    problems.add_at(
        other.line, "",
        "is of " + shortened(other.well) + ", the lines above of " + shortened(other.above) + ", needed: one well in a file");
  if (problems.empty()) take_rows(lines, table, format, survey, problems);
  if (problems.empty()) leave_out_marked(format, survey, problems);
  if (!problems.empty()) return survey;
  survey.decimal_commas = survey.decimal_commas || has_quoted_commas(survey);
  take_groups(table.delimiter.character, survey, problems);
  if (survey.decimal_commas && problems.empty()) check_points(survey, problems);
  if (survey.decimal_commas && problems.empty()) check_commas(survey, problems);
  add_remarks(table, text, format, survey);
  settle_angles(header, survey, problems, table.line);
  for (SurveyRow& row : survey.rows) row.units = header.unit;
  survey.taken = "the header was read as " + description(header) + ", delimiter " + table.delimiter.name;
  return survey;
}

}  // namespace drill_rig_sim
