// SPDX-License-Identifier: BSD-3-Clause
#include "survey_titles.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include "survey_split.h"
#include "survey_words.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t longest_line = 300, most_words = 3;

// the unit that the first words of a text are
const UnitName* unit_in_front(const std::string& text)
{
  std::istringstream in(text.substr(0, text.find_first_of(",;|\t()")));
  const Words words{std::istream_iterator<std::string>(in), {}};
  for (std::size_t count = std::min(most_words, words.size()); count > 0; --count)
    if (const UnitName* unit = length_unit(in_one(words, count))) return unit;
  return nullptr;
}

const UnitName* unit_of_line(const std::string& line)
{
  static const std::regex forms[] = {
      std::regex("(?:^|[^a-z])(?:md|measured depths?|depths?|lengths?|distances?)[ "
                 "_-]*(?:units?|uom)[^a-z0-9]*[:=,;\\t ][ \"]*([a-z].*)"),
      std::regex("(?:^|[^a-z])(?:all +|units? of +)?(?:md|depths?|lengths?|distances?|units?|survey)(?: "
                 "+are)?(?: +(?:given|measured|expressed|reported))? +in "
                 "+([a-z].*)"),
      std::regex("^[^a-z]*(?:units?|units? of (?:depths?|lengths?)) *[:=,;][ \"]*([a-z].*)")};
  const std::string text = lowered(line.substr(0, longest_line));
  for (const std::regex& form : forms)
  {
    std::smatch found;
    if (!std::regex_search(text, found, form)) continue;
    if (const UnitName* unit = unit_in_front(found[1])) return unit;
  }
  return nullptr;
}

// `Well Name: A-1` as its key in one word and its value; two empty texts where a line names none
std::pair<std::string, std::string> well_in(const std::string& line)
{
  const std::string text = trimmed(line.substr(0, longest_line));
  const std::size_t sign = text.find_first_of(":=");
  if (sign == std::string::npos || !names_well(text.substr(0, sign))) return {};
  const std::string value = trimmed(text.substr(sign + 1));
  const std::size_t end = std::min({value.find("  "), value.find('\t'), value.find_first_of(",;|")});
  const Words words = name_words(text.substr(0, sign));
  return {in_one(words, words.size()), trimmed(value.substr(0, end))};
}
}  // namespace

std::string said_above(const std::string& text, int header_line, std::string (*said)(const std::string&))
{
  std::istringstream lines(text);
  std::string line, found;
  for (int number = 1; number < header_line && found.empty() && std::getline(lines, line); ++number) found = said(line);
  return found;
}

TitleUnit unit_above(const std::string& text, int header_line)
{
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; number < header_line && std::getline(lines, line); ++number)
    if (const UnitName* unit = unit_of_line(line)) return {unit, number};
  return {};
}

bool names_well(const std::string& text)
{
  static const std::set<std::string> names = {
      "well",           "wellname", "wellid",     "wellno",       "wellnumber", "wellbore", "wellborename", "wellboreid",
      "wellborenumber", "borehole", "boreholeid", "boreholename", "uwi",        "api",      "apino",        "apinumber",
      "holeid",         "holename", "bhid",       "dhid",         "bohrung",    "puits",    "pozo",         "poco",
      "pozzo",          "bronn",    "skvazhina",  "odwiert",      "otwor"};
  const Words words = name_words(text);
  return names.count(in_one(words, words.size())) > 0;
}

OtherWell other_well(const std::string& text)
{
  std::map<std::string, std::string> wells;  // by their keys
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    const auto [key, well] = well_in(line);
    if (well.empty()) continue;
    const std::string& above = wells.emplace(key, well).first->second;
    if (lowered(above) != lowered(well)) return {number, well, above};
  }
  return {};
}

}  // namespace drill_rig_sim
