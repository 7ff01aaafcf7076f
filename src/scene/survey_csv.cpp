#include "drill_rig_sim/scene/survey_csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <sstream>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "problems.h"
#include "text_file.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t most_columns = 256;  // what stands beyond is not looked at
constexpr const char* needed = "a CSV file with the columns md_m, inclination_deg, azimuth_deg";
constexpr std::array<const char*, 3> columns = {"md_m", "inclination_deg", "azimuth_deg"};
constexpr std::array<const char*, 3> tie_in_columns = {"north_m", "east_m", "tvd_m"};

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
    if (c == ',' && cells.size() == most_columns) break;
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
  bool good = true;
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    const auto found = std::find(header.begin(), header.end(), columns[i]);
    place[i] = static_cast<std::size_t>(found - header.begin());
    if (found == header.end()) missing += (missing.empty() ? "" : ", ") + std::string(columns[i]);
    if (std::count(header.begin(), header.end(), columns[i]) < 2) continue;
    good = false;
    problems.add_at(line, columns[i], "stands more than once in the header, allowed: once");
  }
  if (!missing.empty())
    problems.add_at(line, missing, "no such column in the header, needed: md_m, inclination_deg, azimuth_deg");
  return good && missing.empty();
}

// A row longer than its header is one whose numbers have decimal commas; commas alone at its end do no harm.
bool has_more_cells(const std::vector<std::string>& cells, std::size_t header)
{
  return cells.size() > header && std::any_of(cells.begin() + static_cast<std::ptrdiff_t>(header), cells.end(),
                                              [](const std::string& cell) { return !cell.empty(); });
}

// one station out of a line's cells; a cell that is missing or no number is a problem
void read_station(const std::vector<std::string>& cells, std::size_t header, const std::array<std::size_t, 3>& place, int line,
                  SurveyStation& station, Problems& problems)
{
  std::array<double, 3> value{};
  if (has_more_cells(cells, header))
    problems.add_at(line, "", "has " + std::to_string(cells.size()) + " cells, the header " + std::to_string(header) +
                                  ", allowed: as many, with decimal points");
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    const std::string cell = place[i] < cells.size() ? cells[place[i]] : "";
    if (!is_number(cell, value[i])) problems.add_at(line, columns[i], "is not a finite number");
  }
  station = {value[0], value[1] * degree, value[2] * degree};
}

// where the first station lies, out of its line's cells; nothing without the columns. A cell that is no number is a problem where the tie-in
// is needed.
std::optional<TieIn> tie_in_of(const std::vector<std::string>& header, const std::vector<std::string>& cells, bool needed, int line, Problems& problems)
{
  std::array<double, 3> value{};
  bool good = true;
  for (std::size_t i = 0; i < tie_in_columns.size(); ++i)
  {
    const auto place = static_cast<std::size_t>(std::find(header.begin(), header.end(), tie_in_columns[i]) - header.begin());
    if (place == header.size()) return std::nullopt;
    if (place < cells.size() && is_number(cells[place], value[i])) continue;
    good = false;
    if (needed) problems.add_at(line, tie_in_columns[i], "is not a finite number");
  }
  if (!good) return std::nullopt;
  return TieIn{value[0], value[1], value[2]};
}
}  // namespace

SurveyTable read_survey_csv(const std::string& file, const std::optional<TieIn>& tie_in)
{
  Problems problems(file);
  std::string whole;
  const std::string wrong = read_text_file(file, needed, whole);
  if (!wrong.empty()) problems.fail(0, "", wrong);
  const std::string byte_order_mark = "\xef\xbb\xbf";
  if (whole.compare(0, byte_order_mark.size(), byte_order_mark) == 0) whole.erase(0, byte_order_mark.size());
  std::istringstream in(whole);
  SurveyTable table;
  table.tie_in = tie_in;
  std::vector<SurveyStation>& stations = table.stations;
  std::vector<int> lines;
  std::array<std::size_t, 3> place{};
  std::vector<std::string> header;  // empty before it is read
  std::string text;
  for (int line = 1; stations.size() <= most_stations && std::getline(in, text); ++line)
  {
    if (trimmed(text).empty() || trimmed(text)[0] == '#') continue;
    const std::vector<std::string> cells = cells_of(text);
    if (header.empty())
    {
      header = cells;
      if (!find_columns(cells, line, place, problems)) break;
      continue;
    }
    SurveyStation station;
    read_station(cells, header.size(), place, line, station, problems);
    if (stations.empty() && !tie_in) table.tie_in = tie_in_of(header, cells, station.md != 0.0, line, problems);
    stations.push_back(station);
    lines.push_back(line);
  }
  if (header.empty() && problems.empty())
    problems.add_at(0, "", std::string("is empty, needed: ") + needed);
  if (!header.empty() && problems.empty())
  {
    for (const SurveyProblem& p : survey_problems(stations, table.tie_in))
    {
      problems.add_at(p.station < lines.size() ? lines[p.station] : 1, "station " + std::to_string(p.station + 1), p.text);
    }
  }
  problems.raise();
  return table;
}

}  // namespace drill_rig_sim
