// SPDX-License-Identifier: BSD-3-Clause
#include "survey_beside.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "survey_words.h"

namespace drill_rig_sim
{
namespace
{
bool is_mapped(std::size_t angle, const SurveyFormat& format)
{
  return !(angle == survey_inclination ? format.inclination : format.azimuth).column.empty();
}

// a column that is not known, with a word for an angle in its name: "Observed Inc"
const HeaderCell* unknown_column_of(std::size_t angle, const SurveyHeader& header)
{
  for (const HeaderCell& cell : header.cells)
  {
    if (cell.quantity) continue;
    Words brackets;
    const Words words = name_words(without_brackets(cell.text, brackets));
    const auto is_angle_word = [angle](const std::string& word) { return header_cell(word).quantity == angle; };
    if (std::any_of(words.begin(), words.end(), is_angle_word)) return &cell;
  }
  return nullptr;
}

// Only columns of the path that is not asked for are known, and others may be of the one that is: "Planned Inc" beside
// "Observed Inc".
void check_path(const SurveyFormat& format, SurveyHeader& header)
{
  const SurveyPath asked = format.plan ? SurveyPath::planned : SurveyPath::actual;
  if (header.path == SurveyPath::unsaid || header.path == asked || is_mapped(survey_inclination, format)) return;
  const HeaderCell *inclination = unknown_column_of(survey_inclination, header),
                   *azimuth = unknown_column_of(survey_azimuth, header);
  if (!inclination || !azimuth) return;
  header.wrong_where = inclination->text;
  header.wrong = "may be of the " + std::string(format.plan ? "plan" : "survey") + ", beside \"" +
                 shortened(header.cells[*header.place[survey_inclination]].text) + "\"; needed: a map `columns` (" + how_to_map +
                 ")";
}

// whether a name says minutes, alone or of this angle: "Inc min"
bool names_minutes_of(std::size_t angle, const std::string& name)
{
  static const std::set<std::string> minutes = {"min", "mins", "minute", "minutes", "arcmin"};
  Words others;
  const Words words = name_words(name);
  std::copy_if(words.begin(), words.end(), std::back_inserter(others),
               [](const std::string& word) { return minutes.count(word) == 0; });
  return others.size() < words.size() && (others.empty() || header_cell(in_one(others, others.size())).quantity == angle);
}

// An angle's degrees and minutes are in two columns.
void check_minutes(const SurveyFormat& format, SurveyHeader& header)
{
  for (const std::size_t angle : {survey_inclination, survey_azimuth})
  {
    const std::size_t place = *header.place[angle], next = place + 1;
    if (is_mapped(angle, format) || next >= header.cells.size() || !names_minutes_of(angle, header.cells[next].text)) continue;
    header.wrong_where = header.cells[next].text;
    header.wrong = "holds minutes of \"" + shortened(header.cells[place].text) +
                   "\"; needed: each angle in one column, in degrees with decimals or as 12\xc2\xb0" + "30'";
    return;
  }
}
}  // namespace

void check_columns_beside(const SurveyFormat& format, SurveyHeader& header)
{
  check_path(format, header);
  if (header.wrong.empty()) check_minutes(format, header);
}

}  // namespace drill_rig_sim
