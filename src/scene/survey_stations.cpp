// SPDX-License-Identifier: BSD-3-Clause
#include "survey_stations.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/tie_in_reach.h"
#include "drill_rig_sim/well/well_checks.h"
#include "survey_angles.h"
#include "survey_positions.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t most_lines_listed = 10;
constexpr double farthest_tie_in = 2e4;                     // from the rotary table, as well.tie_in [m]
constexpr double same_depth = 1e-6, same_direction = 1e-6;  // what rounding of equal stations may leave [m], [rad]

using Values = std::array<double, needed_quantities>;

// equal but for rounding; azimuths of vertical stations may be any
bool are_equal(const SurveyStation& a, const SurveyStation& b)
{
  const double apart = (tangent_from(a.inclination, a.azimuth) - tangent_from(b.inclination, b.azimuth)).norm();
  return std::abs(a.md - b.md) <= same_depth && apart <= same_direction;
}

std::string lines_listed(const std::vector<int>& lines)
{
  std::string text = lines.size() == 1 ? "line " : "lines ";
  for (std::size_t i = 0; i < lines.size() && i < most_lines_listed; ++i) text += (i == 0 ? "" : ", ") + std::to_string(lines[i]);
  return lines.size() > most_lines_listed ? text + " and " + std::to_string(lines.size() - most_lines_listed) + " more" : text;
}

/// Makes stations of rows and remembers what it left out.
class StationReader
{
public:
  StationReader(const SurveyRows& survey, bool pass_over, Problems& problems)
      : survey_(survey), pass_over_(pass_over), problems_(problems)
  {
  }

  // up to the first row that is wrong: what follows it is likely wrong for the same reason
  void read()
  {
    for (const SurveyRow& row : survey_.rows)
    {
      Values values{};
      bool complete = true;
      for (std::size_t i = 0; i < needed_quantities; ++i)
        if (!read_value(row, i, values, complete)) return;
      if (!complete)
        without_value_.push_back(row.line);
      else
        add({values[survey_md], values[survey_inclination], values[survey_azimuth]}, row);
    }
  }

  std::vector<SurveyStation> stations;
  std::vector<const SurveyRow*> rows;  // of the stations

  void add_remarks(std::vector<std::string>& remarks) const
  {
    if (!without_azimuth_.empty())
      remarks.push_back("vertical stations without an azimuth were given 0 deg: " + lines_listed(without_azimuth_));
    if (!without_value_.empty()) remarks.push_back("stations without a value were skipped: " + lines_listed(without_value_));
    if (!equal_.empty()) remarks.push_back("stations equal to the one before were skipped: " + lines_listed(equal_));
  }

private:
  // false: a problem was noted
  bool read_value(const SurveyRow& row, std::size_t i, Values& values, bool& complete)
  {
    double value = 0.0;
    CellKind kind = read_cell(row.cells[i], survey_.decimal_commas, value);
    const bool in_degrees = is_angle(i) && row.units[i] == angle_unit("deg");
    if (kind == CellKind::wrong && in_degrees && read_degrees(row.cells[i], survey_.decimal_commas, i == survey_azimuth, value))
      kind = CellKind::number;
    values[i] = value * row.units[i]->factor();
    if (kind == CellKind::number) return true;
    const bool vertical = i == survey_azimuth && complete && values[survey_inclination] == 0.0;
    if (kind == CellKind::wrong || !pass_over_)
    {
      problems_.add_at(row.line, survey_.names[i], problem_of(row.cells[i], kind));
      return false;
    }
    values[i] = 0.0;
    if (vertical)
      without_azimuth_.push_back(row.line);
    else
      complete = false;
    return true;
  }

  std::string problem_of(const std::string& cell, CellKind kind) const
  {
    const std::string none = "has no value (got " + shown_cell(cell) + "); " + how_to_pass_over;
    return (kind == CellKind::wrong ? number_problem(cell) : none) + "; " + survey_.taken;
  }

  void add(const SurveyStation& station, const SurveyRow& row)
  {
    if (pass_over_ && !stations.empty() && are_equal(stations.back(), station)) return equal_.push_back(row.line);
    stations.push_back(station);
    rows.push_back(&row);
  }

  const SurveyRows& survey_;
  bool pass_over_;
  Problems& problems_;
  std::vector<int> without_azimuth_, without_value_, equal_;
};

// where the row of the first station lies; nothing without the columns. A cell that is no number is a problem where the tie-in is
// needed.
std::optional<TieIn> tie_in_of(const SurveyRows& survey, const SurveyRow& row, bool needed, Problems& problems)
{
  std::array<double, 3> place{};
  for (std::size_t i = survey_north; i < survey_quantities; ++i)
  {
    if (survey.names[i].empty()) return std::nullopt;
    const bool good = read_cell(row.cells[i], survey.decimal_commas, place[i - survey_north]) == CellKind::number;
    if (needed && !good) problems.add_at(row.line, survey.names[i], number_problem(row.cells[i]));
    if (needed && good && !row.units[i])
      problems.add_at(row.line, survey.names[i],
                      "the header gives no unit of the tie-in, needed: " + survey_unit_names(false) + " (" + how_to_map + ")");
    if (!good || !row.units[i]) return std::nullopt;
    place[i - survey_north] *= row.units[i]->factor();
  }
  return TieIn{place[0], place[1], place[2]};
}
// the simulator counts from the rotary table, as `well.tie_in` does; of a first station below it the place is needed, and is
// checked
void leave_map(TieIn& tie_in, std::vector<std::string>& remarks)
{
  if (std::abs(tie_in.north) <= farthest_tie_in && std::abs(tie_in.east) <= farthest_tie_in) return;
  char line[200];
  std::snprintf(line, sizeof line,
                "north %.2f m and east %.2f m look like map coordinates: positions are relative to the first station",
                tie_in.north, tie_in.east);
  remarks.push_back(line);
  tie_in.north = tie_in.east = 0.0;
}
// of a first station below the rotary table: no hole of its measured depth leads there
void check_reach(const TieIn& tie_in, const SurveyStation& first, int line, Problems& problems)
{
  if (is_within_reach(tie_in, first.md)) return;
  char text[300];
  std::snprintf(
      text, sizeof text,
      "lies %.2f m from the rotary table (north %.2f, east %.2f, tvd %.2f m), allowed: up to its measured depth, %.2f m; "
      "needed: positions from the rotary table, or tie_in",
      tie_in.position().norm(), tie_in.north, tie_in.east, tie_in.tvd, first.md);
  problems.add_at(line, "station 1", text);
}
}  // namespace

SurveyTable stations_of(const SurveyRows& survey, bool pass_over, const std::optional<TieIn>& tie_in, Problems& problems)
{
  StationReader reader(survey, pass_over, problems);
  reader.read();
  SurveyTable table{reader.stations, tie_in, survey.remarks};
  reader.add_remarks(table.remarks);
  if (!problems.empty()) return table;
  if (!tie_in && !table.stations.empty())
    table.tie_in = tie_in_of(survey, *reader.rows.front(), table.stations.front().md != 0.0, problems);
  if (!problems.empty()) return table;
  if (!tie_in && table.tie_in && table.stations.front().md == 0.0) leave_map(*table.tie_in, table.remarks);
  if (!tie_in && table.tie_in && table.stations.front().md > 0.0)
    check_reach(*table.tie_in, table.stations.front(), reader.rows.front()->line, problems);
  if (!problems.empty()) return table;
  const UnitName& unit = survey.rows.empty() ? *length_unit("m") : *survey.rows.front().units[survey_md];
  for (const SurveyProblem& p : survey_problems(table.stations, table.tie_in, {unit.name, unit.factor()}))
  {
    const bool equal =
        p.station > 0 && p.station < table.stations.size() && are_equal(table.stations[p.station - 1], table.stations[p.station]);
    problems.add_at(p.station < reader.rows.size() ? reader.rows[p.station]->line : 1, "station " + std::to_string(p.station + 1),
                    p.text + (equal ? std::string("; ") + how_to_pass_over : ""));
  }
  if (!problems.empty()) return table;
  for (const std::string& differing :
       {differing_tvd(survey, table.stations, reader.rows), differing_displacement(survey, table.stations, reader.rows)})
    if (!differing.empty()) table.remarks.push_back(differing);
  return table;
}

}  // namespace drill_rig_sim
