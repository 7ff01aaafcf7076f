// SPDX-License-Identifier: BSD-3-Clause
#include "survey_body.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "drill_rig_sim/well/well_checks.h"
#include "survey_marks.h"
#include "survey_path.h"
#include "survey_split.h"
#include "survey_titles.h"
#include "survey_words.h"

namespace drill_rig_sim
{
namespace
{
// blanks of any width count as one
std::string with_single_blanks(const std::string& text)
{
  std::istringstream in(text);
  std::string words;
  for (std::string word; in >> word;) words += word + " ";
  return words;
}

bool has_digit(const std::string& cell)
{
  return cell.find_first_of("0123456789") != std::string::npos;
}

bool any_from(const Cells& cells, std::size_t first, bool (*is)(const std::string&))
{
  return cells.size() > first && std::any_of(cells.begin() + static_cast<std::ptrdiff_t>(first), cells.end(), is);
}

// A row of more cells than its header has decimal commas; delimiters at its end do no harm, but where as many cells are empty as
// values may have a comma. `named`: up to its last name.
bool has_more_cells(const Cells& cells, std::size_t header, std::size_t named, char delimiter)
{
  if (any_from(cells, header, [](const std::string& cell) { return !cell.empty(); })) return true;
  if (delimiter != ',') return false;
  const auto is_whole = [](const std::string& cell)
  { return !cell.empty() && cell.find_first_not_of("0123456789") == std::string::npos; };
  const bool any_point = any_from(cells, 0, [](const std::string& cell) { return cell.find('.') != std::string::npos; });
  const auto filled =
      static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [](const std::string& cell) { return !cell.empty(); }));
  const std::size_t more = cells.size() - std::min(cells.size(), header);
  return !any_point && ((more > 1 && filled == 2 * more) || any_from(cells, named, is_whole));
}

// The rows of a table, taken one after the other.
class Body
{
public:
  Body(const std::vector<CsvLine>& lines, const CsvTable& table, const SurveyFormat& format, SurveyRows& survey,
       Problems& problems)
      : lines_(lines),
        table_(table),
        format_(format),
        survey_(survey),
        problems_(problems),
        named_(table.header.cells.size()),
        wells_(named_)
  {
    while (named_ > 0 && table.header.cells[named_ - 1].text.empty()) --named_;
    for (std::size_t i = 0; i < table.header.cells.size(); ++i)
      if (marks_stations(table.header.cells[i].text, format))
      {
        marks_.push_back(i);
        survey.marks.push_back(table.header.cells[i].text);
      }
  }

  void take()
  {
    std::size_t skipped = 0, first = 0;
    for (std::size_t i = table_.first_row; i < lines_.size() && survey_.rows.size() <= most_stations && problems_.empty(); ++i)
    {
      const std::size_t end = survey_.rows.empty() ? i : end_of_text(i);
      if (end == i)
      {
        take_row(lines_[i]);
        continue;
      }
      check_path(i, end);
      if (skipped == 0) first = i;
      skipped += end - i;
      i = end - 1;
    }
    if (skipped > 0)
      survey_.remarks.push_back(std::to_string(skipped) + (skipped == 1 ? " line" : " lines") +
                                " without a station, text or the header again, skipped (first: line " +
                                std::to_string(lines_[first].number) + ": " + shortened(trimmed(lines_[first].text)) + ")");
  }

private:
  // A title such as Plan or Actual between stations begins another table, but where it also stands above the first one, at the
  // head of each page.
  void check_path(std::size_t first, std::size_t end)
  {
    for (std::size_t i = first; i < end; ++i)
      for (const std::string& text : is_above_header(i) ? Cells() : cells_of(lines_[i]))
        if (end < lines_.size() && path_of_cell(text) != SurveyPath::unsaid)
          return problems_.add_at(lines_[i].number, "",
                                  "\"" + shortened(text) +
                                      "\" stands between stations: it is not clear whether those below are planned or drilled, "
                                      "needed: a file for the plan and one for the drilled well");
  }

  Cells cells_of(const CsvLine& line) const { return split(line.text, table_.delimiter.character); }

  bool fits(const Cells& cells) const
  {
    const std::size_t columns = table_.header.cells.size();
    return !has_more_cells(cells, columns, named_, table_.delimiter.character) &&
           (table_.delimiter.character != ' ' || cells.size() == columns);
  }

  std::string cell(const Cells& cells, std::size_t quantity) const
  {
    const auto place = table_.header.place[quantity];
    return place && *place < cells.size() ? with_hyphen(cells[*place]) : std::string();
  }

  // whether a line is a station, perhaps with something wrong in it
  bool may_be_station(const CsvLine& line) const
  {
    const Cells cells = cells_of(line);
    std::size_t digits = 0, texts = 0;
    for (std::size_t i = 0; i < needed_quantities; ++i)
    {
      double value = 0.0;
      const bool is_text = read_cell(cell(cells, i), survey_.decimal_commas, value) == CellKind::wrong;
      if (i == survey_md && !fits(cells)) return !is_text;
      digits += has_digit(cell(cells, i)) ? 1U : 0U;
      texts += is_text ? 1U : 0U;
    }
    return digits >= 2 || texts == 0;
  }

  bool same(std::size_t i, std::size_t other) const
  {
    return i < lines_.size() && with_single_blanks(lines_[i].text) == with_single_blanks(lines_[other].text);
  }

  bool is_above_header(std::size_t i) const
  {
    for (std::size_t k = 0; k < table_.first_name; ++k)
      if (same(i, k)) return true;
    return false;
  }

  // the line after the header that stands again at line i, with its line of units; i where it does not
  std::size_t end_of_header(std::size_t i) const
  {
    for (std::size_t k = 0; k < table_.names; ++k)
      if (!same(i + k, table_.first_name + k)) return i;
    std::size_t end = i + table_.names;
    for (std::size_t k = table_.first_name + table_.names; k < table_.first_row && same(end, k); ++k) ++end;
    return end;
  }

  // the line after the text that begins at line i and ends with the header again or with the file; i where it is none
  std::size_t end_of_text(std::size_t i) const
  {
    for (std::size_t k = i; k < lines_.size(); ++k)
    {
      const std::size_t end = end_of_header(k);
      if (end > k) return end;
      if (may_be_station(lines_[k])) return i;
    }
    return lines_.size();
  }

  void take_row(const CsvLine& line)
  {
    const Cells cells = cells_of(line);
    const std::size_t columns = table_.header.cells.size();
    if (!fits(cells))
    {
      const char* hint = table_.delimiter.character == ',' ? ", with decimal points" : "";
      return problems_.add_at(line.number, "",
                              "has " + std::to_string(cells.size()) + " cells, the header " +
                                  std::to_string(cells.size() > columns ? columns : named_) + ", allowed: the same number" +
                                  hint);
    }
    check_names(line, cells);
    check_places(line);
    check_well(line, cells);
    SurveyRow row;
    row.line = line.number;
    for (std::size_t i = 0; i < survey_quantities; ++i) row.cells[i] = cell(cells, i);
    for (const std::size_t place : marks_) row.marks.push_back(place < cells.size() ? cells[place] : "");
    survey_.rows.push_back(std::move(row));
    before_ = &line;
  }

  // another header between the rows begins another table
  void check_names(const CsvLine& line, const Cells& cells)
  {
    if (may_be_station(line) || find_columns(cells, format_).found < needed_quantities) return;
    problems_.add_at(line.number, "",
                     "names the columns anew with other names or units than line " + std::to_string(table_.line) +
                         ", needed: one header, or a file for each part");
  }

  // an empty cell of aligned columns is seen by the place of those after it
  void check_places(const CsvLine& line)
  {
    if (table_.delimiter.character != ' ' || !before_) return;
    const auto place = place_left_out(line.text, before_->text);
    if (place)
      problems_.add_at(line.number, "",
                       "its cells are not aligned with those of line " + std::to_string(before_->number) + " from " +
                           shortened(table_.header.cells[*place].text) +
                           " on: a cell is empty in one of these lines, needed: - in empty cells");
  }

  // the hole is its well too, but where the column holds its diameter
  static bool is_of_well(const std::string& name, const std::string& cell)
  {
    const bool is_size = cell[0] >= '0' && cell[0] <= '9';
    return names_well(name) || (name_words(name) == Words{"hole"} && !is_size);
  }

  void check_well(const CsvLine& line, const Cells& cells)
  {
    for (std::size_t i = 0; i < cells.size() && i < wells_.size(); ++i)
    {
      if (cells[i].empty() || !is_of_well(table_.header.cells[i].text, cells[i])) continue;
      if (wells_[i].empty()) wells_[i] = cells[i];
      if (lowered(cells[i]) != lowered(wells_[i]))
        problems_.add_at(
            line.number, table_.header.cells[i].text,
            "is " + shortened(cells[i]) + ", in the rows above " + shortened(wells_[i]) + ", needed: one well in a file");
    }
  }

  const std::vector<CsvLine>& lines_;
  const CsvTable& table_;
  const SurveyFormat& format_;
  SurveyRows& survey_;
  Problems& problems_;
  std::size_t named_;                // cells of the header up to the last name
  std::vector<std::size_t> marks_;   // places of SurveyRows::marks
  std::vector<std::string> wells_;   // by column, where it names the well
  const CsvLine* before_ = nullptr;  // the row taken last
};
}  // namespace

void take_rows(const std::vector<CsvLine>& lines, const CsvTable& table, const SurveyFormat& format, SurveyRows& survey,
               Problems& problems)
{
  Body(lines, table, format, survey, problems).take();
}

}  // namespace drill_rig_sim
