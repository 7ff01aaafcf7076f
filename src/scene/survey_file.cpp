// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/scene/survey_file.h"

#include <algorithm>

#include "problems.h"
#include "survey_csv.h"
#include "survey_las.h"
#include "survey_stations.h"
#include "survey_witsml.h"
#include "text_file.h"
#include "unlikely_values.h"

namespace drill_rig_sim
{
namespace
{
// the first character that is neither a blank nor of a comment (#), NUL in an empty file
char first_of(const std::string& text)
{
  std::size_t first = text.find_first_not_of(" \t\r\n");
  while (first != std::string::npos && text[first] == '#')
    first = text.find_first_not_of(" \t\r\n", std::min(text.find_first_of("\r\n", first), text.size()));
  return first == std::string::npos ? '\0' : text[first];
}
}  // namespace

SurveyTable read_survey_file(const std::string& file, const SurveyFormat& format, const std::optional<TieIn>& tie_in)
{
  Problems problems(file);
  const TextFile whole = read_text_file(file, needed_survey);
  const char first = first_of(whole.text);
  const SurveyRows rows = first == '<'   ? read_survey_witsml(whole.text, format, problems)
                          : first == '~' ? read_survey_las(whole.text, format, problems)
                                         : read_survey_csv(whole.text, format, problems);
  problems.raise();
  SurveyTable table = stations_of(rows, format.pass_over != 0.0, tie_in, problems);
  problems.raise();
  const auto& units = rows.rows.front().units;
  const bool in_degrees = units[survey_inclination] == angle_unit("deg") && units[survey_azimuth] == angle_unit("deg");
  for (const std::string& unlikely : unlikely_stations(table.stations, *units[survey_md], in_degrees))
    table.remarks.push_back(unlikely);
  for (std::string& remark : table.remarks) remark.insert(0, one_line(file) + ": ");
  if (!whole.remark.empty()) table.remarks.insert(table.remarks.begin(), whole.remark);
  return table;
}

SurveyTable read_survey_file(const std::string& file, const std::optional<TieIn>& tie_in)
{
  return read_survey_file(file, {}, tie_in);
}

}  // namespace drill_rig_sim
