// SPDX-License-Identifier: BSD-3-Clause
#include "survey_marks.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "drill_rig_sim/scene/quality_flags.h"
#include "survey_header.h"
#include "survey_path.h"
#include "survey_split.h"
#include "survey_words.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t most_listed = 10, most_codes = 8;

// without what stands in brackets
std::string bare_name(const std::string& name)
{
  Words inside;
  return without_brackets(name, inside);
}

// a column that says of which path a station is
bool names_path(const std::string& name)
{
  static const std::set<std::string> names = {"type",       "surveytype", "stationtype", "datatype", "kind",      "source",
                                              "path",       "pathtype",   "trajectory",  "survey",   "phase",     "plan",
                                              "planactual", "actualplan", "status",      "comment",  "surveyname"};
  const Words words = name_words(bare_name(name));
  return names.count(in_one(words, words.size())) > 0;
}

// flags of a station, or of one of its numbers
bool names_flags(const std::string& name)
{
  const FlagName found = flag_name(bare_name(name));
  if (found.sense == FlagSense::none || found.of.empty()) return found.sense != FlagSense::none;
  const std::optional<std::size_t> of = header_cell(found.of).quantity;
  return of && *of < needed_quantities;
}

bool is_asked(const std::string& name, const SurveyFormat& format)
{
  return !format.quality.column.empty() && lowered(name) == lowered(format.quality.column);
}

std::string quoted_text(const std::string& text)
{
  return "\"" + shortened(text) + "\"";
}

// rows of one column, of those that stay
class Marks
{
public:
  Marks(std::size_t column, const SurveyFormat& format, SurveyRows& survey, Problems& problems)
      : column_(column), name_(survey.marks[column]), format_(format), survey_(survey), problems_(problems)
  {
    for (const SurveyRow& row : survey_.rows)
      if (std::find(kinds_.begin(), kinds_.end(), row.marks[column_]) == kinds_.end()) kinds_.push_back(row.marks[column_]);
  }

  // the rows of the path that is not asked for, where there are two
  void leave_out_other_path()
  {
    if (!names_path(name_) || !(any(SurveyPath::planned) || any(SurveyPath::actual))) return;
    check_unmarked();
    if (!problems_.empty()) return;
    const SurveyPath other = format_.plan ? SurveyPath::actual : SurveyPath::planned;
    const auto is_other = [&](const std::string& cell)
    {
      const SurveyPath path = path_in(cell);
      return path == other || (format_.plan && path == SurveyPath::unsaid);
    };
    const auto count = std::count_if(kinds_.begin(), kinds_.end(), is_other);
    if (any(SurveyPath::planned) && count > 0 && static_cast<std::size_t>(count) < kinds_.size())
      leave_out(is_other, format_.plan ? "of the plan" : "of the drilled well");
    else if (kinds_.size() == 1 && path_in(kinds_[0]) == other)
      survey_.remarks.push_back("all stations are marked " + shown_mark(kinds_[0]) + " by " + quoted_text(name_) +
                                ": they are read as the " + (format_.plan ? "plan" : "survey"));
    if (!format_.plan) list([](const std::string& cell) { return cell.empty(); }, "is", "are", "used as of the drilled well");
  }

  void leave_out_bad()
  {
    if (is_asked(name_, format_)) return leave_out([&](const std::string& cell) { return !is_good(cell); }, "");
    const FlagSense named = flag_name(bare_name(name_)).sense, sense = named == FlagSense::none ? FlagSense::status : named;
    const FlagCells cells = flag_cells(sense, kinds_);
    if (!cells.known && named != FlagSense::none) say_unclear(sense, cells);
    if (!cells.known) return;
    const auto means = [&](const std::string& cell, FlagMeaning meaning)
    {
      const auto kind = std::find(kinds_.begin(), kinds_.end(), cell) - kinds_.begin();
      return cells.meanings[static_cast<std::size_t>(kind)] == meaning;
    };
    if (sense != FlagSense::status)
      list([&](const std::string& cell) { return means(cell, FlagMeaning::other); }, "is", "are", "used");
    leave_out([&](const std::string& cell) { return means(cell, FlagMeaning::bad); }, "");
  }

private:
  // a comment names a target that the hole goes through
  SurveyPath path_in(const std::string& cell) const
  {
    const Words words = name_words(bare_name(name_));
    const std::string name = in_one(words, words.size());
    return (name == "comment" || name == "status") && lowered(trimmed(cell)) == "target" ? SurveyPath::unsaid
                                                                                         : path_of_cell(cell);
  }

  bool any(SurveyPath path) const
  {
    return std::any_of(kinds_.begin(), kinds_.end(), [&](const std::string& cell) { return path_in(cell) == path; });
  }

  // A row without a mark may be of the path of the mark above it, as where cells were joined, or of the other one.
  void check_unmarked()
  {
    SurveyPath above = SurveyPath::unsaid;
    for (const SurveyRow& row : survey_.rows)
    {
      const std::string& cell = row.marks[column_];
      const bool is_clear = above != SurveyPath::planned && !(format_.plan && !any(SurveyPath::planned));
      if (cell.empty() && !is_clear)
        return problems_.add_at(row.line, name_,
                                "has no mark, others are marked planned or actual: it is not known which of both the station is, "
                                "needed: a mark in every row");
      if (!cell.empty()) above = path_in(cell);
    }
  }

  bool is_good(const std::string& cell) const
  {
    std::istringstream good(format_.quality.good);
    for (std::string one; good >> one;)
      if (lowered(one) == lowered(trimmed(cell))) return true;
    return false;
  }

  // a measure of quality, as in per cent, and what the tool does are no flags
  void say_unclear(FlagSense sense, const FlagCells& cells)
  {
    const bool codes =
        std::all_of(kinds_.begin(), kinds_.end(),
                    [](const std::string& cell) { return cell.find_first_not_of("0123456789+-. ") == std::string::npos; });
    if (!cells.unclear || kinds_.size() > most_codes || (sense == FlagSense::status && !(codes && kinds_.size() == 2))) return;
    const std::string line = "holds " + shown_mark(kinds_[0]) + " and " + shown_mark(kinds_[1]) +
                             ": which of them mark bad stations is not known, needed: words such as good and bad, or `quality: "
                             "{column: NAME, good: CELLS}` (" +
                             how_to_map + ")";
    if (sense == FlagSense::status)
      survey_.remarks.push_back(quoted_text(name_) + " " + line);
    else
      problems_.add_at(survey_.rows.front().line, name_, line);
  }

  static std::string shown_mark(const std::string& cell) { return cell.empty() ? "nothing" : quoted_text(cell); }

  template <class Is>
  void leave_out(const Is& is, const std::string& read)
  {
    if (!list(is, "was", "were", read.empty() ? "left out" : "left out: it is read as a survey " + read)) return;
    auto& rows = survey_.rows;
    rows.erase(std::remove_if(rows.begin(), rows.end(), [&](const SurveyRow& row) { return is(row.marks[column_]); }),
               rows.end());
    if (rows.empty()) problems_.add_at(0, name_, "marks all stations as bad, needed: two good stations or more");
  }

  // a remark on the rows whose cells are such, with the verb of one and of several; false where there are none
  template <class Is>
  bool list(const Is& is, const char* one, const char* several, const std::string& what)
  {
    std::string cells, lines;
    std::size_t count = 0;
    for (const std::string& kind : kinds_)
      if (is(kind)) cells += (cells.empty() ? "" : ", ") + shown_mark(kind);
    for (const SurveyRow& row : survey_.rows)
      if (is(row.marks[column_]) && count++ < most_listed) lines += (lines.empty() ? "" : ", ") + std::to_string(row.line);
    if (count == 0) return false;
    survey_.remarks.push_back(std::to_string(count) + (count == 1 ? " station" : " stations") + " marked " + cells + " by " +
                              quoted_text(name_) + " " + (count == 1 ? one : several) + " " + what + " (" +
                              (count == 1 ? "line " : "lines ") + lines + (count > most_listed ? ", ..." : "") + ")");
    return true;
  }

  std::size_t column_;
  std::string name_;
  const SurveyFormat& format_;
  SurveyRows& survey_;
  Problems& problems_;
  std::vector<std::string> kinds_;  // the different cells
};
}  // namespace

bool marks_stations(const std::string& name, const SurveyFormat& format)
{
  return names_path(name) || names_flags(name) || is_asked(name, format);
}

void leave_out_marked(const SurveyFormat& format, SurveyRows& survey, Problems& problems)
{
  for (std::size_t i = 0; i < survey.marks.size() && !survey.rows.empty() && problems.empty(); ++i)
  {
    Marks(i, format, survey, problems).leave_out_other_path();
    if (!survey.rows.empty()) Marks(i, format, survey, problems).leave_out_bad();
  }
}

}  // namespace drill_rig_sim
