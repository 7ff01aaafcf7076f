#include "drill_rig_sim/scene/survey_csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "problems.h"

namespace drill_rig_sim
{
namespace
{
constexpr double deepest = 20000.0;  // [m]
constexpr std::array<const char*, 3> columns = {"md_m", "inclination_deg", "azimuth_deg"};

std::string trimmed(const std::string& text)
{
  const char* blanks = " \t\r\"";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> cells_of(const std::string& line)
{
  std::vector<std::string> cells(1);
  for (const char c : line)
  {
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  }
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

bool is_number(const std::string& text, double& value)
{
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  return static_cast<bool>(in >> value) && in.peek() == std::istringstream::traits_type::eof();
}

// where the three columns stand; false (and problems noted) if one is missing
bool find_columns(const std::vector<std::string>& header, int line, std::array<std::size_t, 3>& place, Problems& problems)
{
  std::string missing;
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    const auto found = std::find(header.begin(), header.end(), columns[i]);
    place[i] = static_cast<std::size_t>(found - header.begin());
    if (found == header.end()) missing += (missing.empty() ? "" : ", ") + std::string(columns[i]);
  }
  if (!missing.empty())
    problems.add_at(line, missing, "no such column in the header, needed: md_m, inclination_deg, azimuth_deg");
  return missing.empty();
}

// one station out of a line's cells; false (and problems noted) if a cell is missing or no number
bool read_station(const std::vector<std::string>& cells, const std::array<std::size_t, 3>& place, int line,
                  SurveyStation& station, Problems& problems)
{
  std::array<double, 3> value{};
  bool good = true;
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    const std::string cell = place[i] < cells.size() ? cells[place[i]] : "";
    if (is_number(cell, value[i])) continue;
    good = false;
    problems.add_at(line, columns[i], "'" + cell.substr(0, 40) + "' is not a finite number");
  }
  station = {value[0], value[1] * degree, value[2] * degree};
  return good;
}

double angle_between(const SurveyStation& a, const SurveyStation& b)
{
  const double cosine = std::cos(a.inclination) * std::cos(b.inclination) +
                        std::sin(a.inclination) * std::sin(b.inclination) * std::cos(b.azimuth - a.azimuth);
  return std::acos(std::min(1.0, std::max(-1.0, cosine)));
}

std::string problem_of(const SurveyStation& s)
{
  if (!std::isfinite(s.md) || !std::isfinite(s.inclination) || !std::isfinite(s.azimuth)) return "a value is not a finite number";
  if (s.md < 0.0 || s.md > deepest) return "md " + plain(s.md) + " m is out of range, allowed: 0 to 20000 m";
  if (s.inclination < 0.0 || s.inclination > pi)
    return "inclination " + plain(s.inclination / degree) + " deg is out of range, allowed: 0 to 180 deg";
  if (std::abs(s.azimuth) > 2.0 * pi + 1e-9)
    return "azimuth " + plain(s.azimuth / degree) + " deg is out of range, allowed: -360 to 360 deg";
  return "";
}
}  // namespace

std::vector<SurveyProblem> survey_problems(const std::vector<SurveyStation>& stations)
{
  // minimum curvature knows no arc between opposite directions; a real well never comes near
  constexpr double sharpest = 179.0 * degree;
  std::vector<SurveyProblem> problems;
  if (stations.size() < 2)
    problems.push_back({0, plain(static_cast<double>(stations.size())) + " station, needed: at least two"});
  bool before_is_good = false;
  for (std::size_t i = 0; i < stations.size(); ++i)
  {
    const SurveyStation& s = stations[i];
    const std::string alone = problem_of(s);
    if (!alone.empty())
      problems.push_back({i, alone});
    else if (i == 0 && s.md != 0.0)
      problems.push_back({i, "the first md is " + plain(s.md) + " m, needed: 0, the rotary table"});
    else if (before_is_good && s.md <= stations[i - 1].md)
      problems.push_back({i, "md " + plain(s.md) + " m does not exceed the " + plain(stations[i - 1].md) + " m before it"});
    else if (before_is_good && angle_between(stations[i - 1], s) > sharpest)
      problems.push_back({i, "the direction turns round from the station before it, allowed: up to 179 deg"});
    before_is_good = alone.empty();
  }
  return problems;
}

std::vector<SurveyStation> read_survey_csv(const std::string& file)
{
  Problems problems(file);
  std::ifstream in(file);
  std::vector<SurveyStation> stations;
  std::vector<int> lines;
  std::array<std::size_t, 3> place{};
  bool has_header = false;
  bool well_formed = true;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line)
  {
    if (trimmed(text).empty() || trimmed(text)[0] == '#') continue;
    if (!has_header)
    {
      has_header = true;
      if (!find_columns(cells_of(text), line, place, problems)) break;
      continue;
    }
    SurveyStation station;
    well_formed = read_station(cells_of(text), place, line, station, problems) && well_formed;
    stations.push_back(station);
    lines.push_back(line);
  }
  if (!has_header && problems.empty())
    problems.add_at(0, "", "cannot be read or is empty, needed: a CSV file with the columns md_m, inclination_deg, azimuth_deg");
  if (has_header && problems.empty() && well_formed)
  {
    for (const SurveyProblem& p : survey_problems(stations))
    {
      problems.add_at(p.station < lines.size() ? lines[p.station] : 1, "station " + std::to_string(p.station + 1), p.text);
    }
  }
  problems.raise();
  return stations;
}

}  // namespace drill_rig_sim
