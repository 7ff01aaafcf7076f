// SPDX-License-Identifier: BSD-3-Clause
#include "survey_header.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "survey_beside.h"
#include "survey_names.h"
#include "survey_words.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::array<const char*, survey_quantities> own_names = {"md_m",    "inclination_deg", "azimuth_deg",
                                                                  "north_m", "east_m",          "tvd_m"};
constexpr std::array<const char*, survey_quantities> full_names = {"measured depth", "inclination", "azimuth",
                                                                   "north",          "east",        "true vertical depth"};

// the degree sign is a word of its own, and the Cyrillic word for it is that sign
std::string with_degree_apart(std::string text)
{
  for (const std::string sign :
       {"\xc2\xb0", "\xc2\xba", "\u0433\u0440\u0430\u0434\u0443\u0441\u044b", "\u0433\u0440\u0430\u0434"})
  {
    const std::size_t at = text.find(sign);
    if (at != std::string::npos) text = text.substr(0, at) + " \xc2\xb0 " + text.substr(at + sign.size());
  }
  return text;
}

bool match_name(const std::string& name, HeaderCell& cell)
{
  const auto found = survey_names().find(name);
  if (found == survey_names().end()) return false;
  cell.quantity = found->second.quantity;
  cell.weak = found->second.weak;
  return true;
}

// by the words of a name, at their end perhaps a unit; false if they are no name
bool match(const Words& words, HeaderCell& cell)
{
  cell.unit = nullptr;
  if (match_name(in_one(words, words.size()), cell)) return true;
  // "md_ft", "Depth m RKB": one or two words of a unit
  for (std::size_t last = 1; last <= 2 && last < words.size(); ++last)
  {
    if (!match_name(in_one(words, words.size() - last), cell)) continue;
    std::string spelling;
    for (std::size_t i = words.size() - last; i < words.size(); ++i) spelling += words[i];
    cell.unit = unit_for(*cell.quantity, spelling);
    if (cell.unit) return true;
  }
  cell.quantity.reset();
  return false;
}

// takes the word for a north out
Words without_north(const Words& words, std::string& north)
{
  Words rest;
  for (const std::string& word : words)
  {
    const auto found = norths().find(word);
    if (found != norths().end())
      north = found->second;
    else if (word != "north")
      rest.push_back(word);
  }
  return rest;
}

// takes the words of a list out
Words without(const Words& words, const std::set<std::string>& list)
{
  Words rest;
  std::copy_if(words.begin(), words.end(), std::back_inserter(rest),
               [&list](const std::string& word) { return list.count(word) == 0; });
  return rest;
}

// takes the names of the rotary table out, from which depths count anyway
Words without_datum(const Words& words)
{
  static const std::set<std::string> data = {"rkb", "kb", "brt", "rt", "brkb", "bkb", "rte", "df", "below", "from"};
  return without(words, data);
}

// takes out what was done to a value: which of "Inc" and "Inc Corrected" is meant, the file does not say
Words without_treatment(const Words& words)
{
  static const std::set<std::string> treatments = {"raw", "uncorrected", "corrected", "corr", "cor",   "sag",  "ifr",
                                                   "msa", "scc",         "final",     "gyro", "short", "long", "collar"};
  return without(words, treatments);
}

// AziGN, AZIM_T, AzimuthTrueNorth: the north as a word of its own
Words with_north_apart(const Words& words)
{
  static const std::set<std::string> ends = {"t",  "tn",  "true",     "g",         "gn",        "grid",
                                             "mn", "mag", "magnetic", "truenorth", "gridnorth", "magneticnorth"};
  Words apart;
  for (const std::string& word : words)
  {
    apart.push_back(word);
    for (const std::string& name : {std::string("azimuth"), std::string("azim"), std::string("azi"), std::string("az")})
    {
      if (word.rfind(name, 0) != 0 || ends.count(word.substr(name.size())) == 0) continue;
      apart.back() = name;
      apart.push_back(word.substr(name.size()));
      break;
    }
  }
  return apart;
}

void match_any(const Words& name, HeaderCell& cell)
{
  const Words words = with_north_apart(without_treatment(name));
  std::string north;
  const Words rest = without_north(words, north);
  if (match(words, cell) || (match(without_datum(words), cell) && !is_angle(*cell.quantity)))
  {
    if (cell.quantity == survey_azimuth) cell.north = north;
    return;
  }
  const bool is_azimuth = match(rest, cell) && cell.quantity == survey_azimuth;
  if (is_azimuth) cell.north = north;
  if (!is_azimuth) cell.quantity.reset();
}

std::string quoted(const std::string& text)
{
  return "\"" + shortened(text) + "\"";
}

// "MD" of "MD (ft)"
std::string before_brackets(const std::string& text)
{
  const std::string name = text.substr(0, text.find_first_of("([{"));
  return name.substr(0, name.find_last_not_of(' ') + 1);
}

// the place of a map's column, whose name may leave out the unit in brackets; what is wrong with it
std::string find_named(const std::string& column, const std::vector<HeaderCell>& cells, std::optional<std::size_t>& place)
{
  const std::array<std::function<bool(const std::string&)>, 3> is_it = {
      [&](const std::string& text) { return text == column; },
      [&](const std::string& text) { return lowered(text) == lowered(column); },
      [&](const std::string& text) { return lowered(before_brackets(text)) == lowered(column); }};
  for (const auto& is_named : is_it)
  {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (is_named(cells[i].text)) found.push_back(i);
    if (found.size() > 1) return "appears more than once in the header, allowed: once";
    if (found.empty()) continue;
    place = found.front();
    return "";
  }
  return "no such column in the header";
}

// the places of a quantity's columns of a path
std::vector<std::size_t> places_of(std::size_t quantity, SurveyPath path, const std::vector<HeaderCell>& cells)
{
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i].quantity == quantity && cells[i].path == path) found.push_back(i);
  return found;
}

// The path whose angles are read: the one that is asked for where it is named, else that without a name, else the other one.
SurveyPath path_to_read(const std::vector<HeaderCell>& cells, bool plan)
{
  const SurveyPath asked = plan ? SurveyPath::planned : SurveyPath::actual,
                   other = plan ? SurveyPath::actual : SurveyPath::planned;
  for (const SurveyPath path : {asked, SurveyPath::unsaid, other})
    for (const std::size_t angle : {survey_inclination, survey_azimuth})
      if (!places_of(angle, path, cells).empty()) return path;
  return SurveyPath::unsaid;
}

// The columns of a quantity on a path; depths and a place may be of both paths and without its name.
std::vector<std::size_t> places_on(std::size_t quantity, SurveyPath path, bool plan, const std::vector<HeaderCell>& cells)
{
  std::vector<std::size_t> found = places_of(quantity, path, cells);
  if (!found.empty() || is_angle(quantity)) return found;
  const SurveyPath asked = plan ? SurveyPath::planned : SurveyPath::actual;
  return places_of(quantity, path == SurveyPath::unsaid ? asked : SurveyPath::unsaid, cells);
}

// the place of a quantity by the usual spellings; own names go before others, and any before "Depth"
std::string find_usual(std::size_t quantity, const std::vector<std::size_t>& places, const std::vector<HeaderCell>& cells,
                       std::optional<std::size_t>& place)
{
  std::array<std::vector<std::size_t>, 3> ranks;
  for (const std::size_t i : places) ranks[cells[i].own ? 0 : cells[i].weak ? 2 : 1].push_back(i);
  const auto found = std::find_if(ranks.begin(), ranks.end(), [](const auto& rank) { return !rank.empty(); });
  if (found == ranks.end()) return "";
  place = found->front();
  if (found->size() == 1) return "";
  const auto named_as_first = [&](std::size_t i) { return cells[i].text == cells[found->front()].text; };
  if (std::all_of(found->begin(), found->end(), named_as_first)) return "appears more than once in the header, allowed: once";
  std::string names;
  for (const std::size_t i : *found) names += (names.empty() ? "" : ", ") + quoted(cells[i].text);
  return "several columns fit: " + names + "; needed: one column, or `columns: {" + quantity_keys[quantity] +
         ": {column: NAME}}` (" + how_to_map + ")";
}

const SurveyColumn& column_of(const SurveyFormat& format, std::size_t quantity)
{
  const std::array<const SurveyColumn*, survey_quantities> all = {&format.md,    &format.inclination, &format.azimuth,
                                                                  &format.north, &format.east,        &format.tvd};
  return *all[quantity];
}

// a tie-in's column that is not clear is none: few surveys need it
void find_column(std::size_t quantity, const SurveyColumn& asked, bool plan, SurveyHeader& header)
{
  std::optional<std::size_t>& place = header.place[quantity];
  std::string wrong = asked.column.empty()
                          ? find_usual(quantity, places_on(quantity, header.path, plan, header.cells), header.cells, place)
                          : find_named(asked.column, header.cells, place);
  if (place && quantity < needed_quantities) ++header.found;
  if (!wrong.empty() && quantity >= needed_quantities && asked.column.empty()) return place.reset();
  if (!wrong.empty() && header.wrong.empty())
  {
    header.wrong = wrong;
    header.wrong_where = !asked.column.empty()               ? asked.column
                         : place && header.cells[*place].own ? own_names[quantity]
                                                             : full_names[quantity];
  }
  if (!place) return;
  const HeaderCell& cell = header.cells[*place];
  // a name that only the map knows has its unit in brackets too
  const UnitName* said = !cell.quantity                                   ? unit_for(quantity, cell.unit_in_brackets)
                         : is_angle(*cell.quantity) == is_angle(quantity) ? cell.unit
                                                                          : nullptr;
  header.unit[quantity] = asked.unit.empty() ? said : unit_for(quantity, asked.unit);
  if (!asked.unit.empty() && said && said != header.unit[quantity] && header.wrong.empty())
  {
    header.wrong = "the unit is " + std::string(said->name) + " in the header and " + shortened(asked.unit) +
                   " in the map, needed: the same unit";
    header.wrong_where = cell.text;
  }
}

// a column that would be the missing quantity but for its unit
void find_unknown_unit(std::size_t quantity, SurveyHeader& header)
{
  const auto found = std::find_if(header.cells.begin(), header.cells.end(),
                                  [&](const HeaderCell& cell) { return cell.quantity_without_brackets == quantity; });
  if (found == header.cells.end()) return;
  header.wrong_where = found->text;
  Words brackets;
  without_brackets(found->text, brackets);
  header.wrong = "the unit in brackets " + why_no_unit(is_angle(quantity), brackets.empty() ? "" : brackets.front()) +
                 ", or a map `columns` (" + how_to_map + ")";
}

// where a quantity has no column but of the other path than an angle's
void find_other_path(SurveyHeader& header)
{
  const auto angle = header.place[survey_inclination] ? header.place[survey_inclination] : header.place[survey_azimuth];
  for (std::size_t quantity = 0; quantity < needed_quantities && angle; ++quantity)
  {
    const auto of_other =
        std::find_if(header.cells.begin(), header.cells.end(),
                     [&](const HeaderCell& cell) { return cell.quantity == quantity && cell.path != header.path; });
    if (header.place[quantity] || of_other == header.cells.end()) continue;
    header.wrong_where = of_other->text;
    header.wrong = "is not of the same path as " + quoted(header.cells[*angle].text) +
                   ", needed: all columns of the plan or all of the drilled well, or a map `columns` (" + how_to_map + ")";
    return;
  }
}

std::string missing_columns(const SurveyHeader& header)
{
  std::string missing;
  for (std::size_t i = 0; i < needed_quantities; ++i)
    if (!header.place[i]) missing += (missing.empty() ? "" : ", ") + std::string(own_names[i]);
  return missing;
}
}  // namespace

HeaderCell header_cell(const std::string& text)
{
  HeaderCell cell;
  cell.text = text;
  Words brackets;
  Words words = without_path(name_words(with_degree_apart(without_brackets(text, brackets))), cell.path);
  const Words outside = words;
  std::string in_brackets;
  for (const std::string& bracket : brackets)
  {
    if (length_unit(bracket) || angle_unit(bracket))
      in_brackets = bracket;
    else
      for (const std::string& word : without_path(name_words(with_degree_apart(bracket)), cell.path)) words.push_back(word);
  }
  cell.unit_in_brackets = in_brackets;
  match_any(words, cell);
  if (!cell.quantity)
  {
    HeaderCell bare;
    match_any(outside, bare);
    if (!brackets.empty()) cell.quantity_without_brackets = bare.quantity;
    return cell;
  }
  if (!in_brackets.empty()) cell.unit = unit_for(*cell.quantity, in_brackets);
  for (const std::string& bracket : brackets)
  {
    const UnitName* other = unit_for(*cell.quantity, bracket);
    if (!other || other == cell.unit) continue;
    cell.quantity_without_brackets = cell.quantity;  // two units
    cell.quantity.reset();
    return cell;
  }
  cell.own = text == own_names[*cell.quantity];
  return cell;
}

SurveyHeader find_columns(const std::vector<std::string>& cells, const SurveyFormat& format)
{
  SurveyHeader header;
  for (const std::string& cell : cells) header.cells.push_back(header_cell(cell));
  header.path = path_to_read(header.cells, format.plan);
  for (std::size_t i = 0; i < survey_quantities; ++i) find_column(i, column_of(format, i), format.plan, header);
  const std::string missing = missing_columns(header);
  if (!missing.empty() && header.wrong.empty())
  {
    header.wrong_where = missing;
    header.wrong = "no such column in the header";
    find_other_path(header);
    for (std::size_t i = needed_quantities; i-- > 0;)
      if (!header.place[i]) find_unknown_unit(i, header);
  }
  if (header.wrong.empty()) check_columns_beside(format, header);
  return header;
}

std::string unit_problem(const SurveyHeader& header, std::size_t quantity)
{
  if (!header.place[quantity] || header.unit[quantity]) return "";
  const std::string key = quantity_keys[quantity];
  const std::string allowed = survey_unit_names(is_angle(quantity));
  return "the header gives no unit, needed: " +
         quoted(header.cells[*header.place[quantity]].text + (is_angle(quantity) ? " (deg)" : " (m)")) +
         " in the header, or `columns: {" + key + ": {unit: " + (is_angle(quantity) ? "deg" : "m") + "}}` with " + allowed +
         " (" + how_to_map + ")";
}

std::string description(const SurveyHeader& header)
{
  std::string text;
  for (std::size_t i = 0; i < needed_quantities; ++i)
  {
    if (!header.place[i]) continue;
    text += (text.empty() ? "" : ", ") + std::string(quantity_keys[i]) + " " + quoted(header.cells[*header.place[i]].text);
    if (header.unit[i]) text += std::string(" [") + header.unit[i]->name + "]";
  }
  return text;
}

}  // namespace drill_rig_sim
