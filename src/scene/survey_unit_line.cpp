// SPDX-License-Identifier: BSD-3-Clause
// What stands beside a survey's header: the line of units below it, the north in a line above it.
#include <algorithm>
#include <set>

#include "survey_header.h"
#include "survey_words.h"

namespace drill_rig_sim
{
namespace
{
/// A unit alone in its cell, in brackets or not. Words that are no part of it may stand beside: decimal degrees, ft RKB, deg
/// grid.
const UnitName* unit_alone(std::size_t quantity, const std::string& cell)
{
  Words brackets;
  const std::string bare = without_brackets(cell, brackets), text = brackets.size() == 1 ? brackets.front() : bare;
  if (const UnitName* unit = unit_for(quantity, text)) return unit;
  static const std::set<std::string> beside = {"decimal", "dec", "rkb", "kb",  "rt",    "dfe", "rte",
                                               "msl",     "ahd", "md",  "tvd", "north", "n",   "azimuth"};
  std::string left;
  for (const std::string& word : name_words(text))
    if ((quantity == survey_md && (word == "msl" || word == "tvd")) || (beside.count(word) == 0 && norths().count(word) == 0))
      left += word;
  return left.empty() ? nullptr : unit_for(quantity, left);
}

const std::string* cell_of(std::size_t quantity, const std::vector<std::string>& cells, const SurveyHeader& header)
{
  return header.place[quantity] && *header.place[quantity] < cells.size() ? &cells[*header.place[quantity]] : nullptr;
}
}  // namespace

bool take_units(const std::vector<std::string>& cells, SurveyHeader& header)
{
  std::array<const UnitName*, survey_quantities> units = header.unit;
  for (std::size_t i = 0; i < survey_quantities; ++i)
  {
    const std::string* cell = cell_of(i, cells, header);
    if (!cell) continue;
    const UnitName* unit = unit_alone(i, *cell);
    if (i < needed_quantities && !unit) return false;
    if (unit && units[i] && unit != units[i]) return false;
    if (unit) units[i] = unit;
  }
  header.unit = units;
  if (const std::string* azimuth = cell_of(survey_azimuth, cells, header))
  {
    HeaderCell& named = header.cells[*header.place[survey_azimuth]];
    for (const std::string& word : name_words(*azimuth))
      if (named.north.empty() && norths().count(word) > 0) named.north = norths().at(word);
  }
  return true;
}

std::optional<std::size_t> unknown_unit(const std::vector<std::string>& cells, const SurveyHeader& header)
{
  std::optional<std::size_t> unknown;
  bool any_known = false;
  for (std::size_t i = 0; i < needed_quantities; ++i)
  {
    const std::string* cell = cell_of(i, cells, header);
    if (!cell || cell->empty()) continue;
    if (unit_alone(i, *cell))
      any_known = true;
    else if (!unknown && cell->find_first_of("0123456789") == std::string::npos)
      unknown = i;
  }
  return any_known ? unknown : std::nullopt;
}

std::string north_of_line(const std::string& line)
{
  const Words words = name_words(line);
  const auto says = [&](const char* word) { return std::find(words.begin(), words.end(), word) != words.end(); };
  const bool of_azimuths = says("north") || says("azimuth") || says("azimuths") || says("azi") || says("bearings");
  if (says("true") || !of_azimuths) return "";
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const auto north = norths().find(words[i]);
    if (north == norths().end() || words[i].size() < 3) continue;  // MN is a state too
    const std::string next = i + 1 < words.size() ? words[i + 1] : "";
    if (next != "convergence" && next != "declination" && next != "correction" && next != "field") return north->second;
  }
  return "";
}

std::string datum_of_line(const std::string& line)
{
  const Words words = name_words(line);
  const auto says = [&](std::initializer_list<const char*> any)
  {
    return std::any_of(any.begin(), any.end(),
                       [&](const char* word) { return std::find(words.begin(), words.end(), word) != words.end(); });
  };
  const bool of_depth = says({"md", "depth", "depths"}) && says({"reference", "ref", "datum"});
  if (!of_depth || says({"tvd", "vertical", "permanent", "rkb", "kb", "brt", "rt", "rte", "df", "rotary", "kelly", "drill"}))
    return "";
  if (says({"msl", "sea"})) return "mean sea level";
  if (says({"gl", "ground"})) return "ground level";
  return says({"seabed", "mudline", "bml"}) ? "the seabed" : "";
}

}  // namespace drill_rig_sim
