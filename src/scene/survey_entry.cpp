// SPDX-License-Identifier: BSD-3-Clause
#include "survey_entry.h"

#include "scene_keys.h"
#include "survey_units.h"
#include "text_file.h"
#include "yaml_document.h"
#include "yaml_reader.h"

namespace drill_rig_sim
{
namespace
{
void read_column(const YAML::Node& node, const std::string& path, bool is_angle, SurveyColumn& column, Problems& problems)
{
  read_block(node, path, survey_column_keys, every_kind, column, problems);
  const bool known = column.unit.empty() || (is_angle ? angle_unit(column.unit) : length_unit(column.unit));
  if (!known) problems.add(join(path, "unit"), "\"" + shortened(column.unit) + "\" " + why_no_unit(is_angle, column.unit));
}

void read_columns(const YAML::Node& node, const std::string& path, SurveyFormat& format, Problems& problems)
{
  const auto entries = read_block(node, path, survey_columns_keys, every_kind, format, problems);
  const auto read = [&](const char* key, bool is_angle, SurveyColumn& column)
  {
    const auto found = entries.find(key);
    if (found != entries.end()) read_column(found->second, join(path, key), is_angle, column, problems);
  };
  read("md", false, format.md);
  read("inclination", true, format.inclination);
  read("azimuth", true, format.azimuth);
  read("north", false, format.north);
  read("east", false, format.east);
  read("tvd", false, format.tvd);
}

// the entries of a format; gives all entries back
std::map<std::string, YAML::Node> read_format(const YAML::Node& node, const std::string& path, unsigned kind,
                                              SurveyFormat& format, Problems& problems)
{
  auto entries = read_block(node, path, survey_keys, kind, format, problems);
  const auto columns = entries.find("columns");
  if (columns != entries.end()) read_columns(columns->second, join(path, "columns"), format, problems);
  const auto quality = entries.find("quality");
  if (quality != entries.end())
    read_block(quality->second, join(path, "quality"), survey_quality_keys, every_kind, format.quality, problems);
  std::string& delimiter = format.delimiter;
  if (delimiter == "\t") delimiter = "tab";
  if (delimiter == " ") delimiter = "space";
  if (delimiter == "|") delimiter = "bar";
  if (!delimiter.empty() && delimiter != "," && delimiter != ";" && delimiter != "bar" && delimiter != "tab" &&
      delimiter != "space")
    problems.add(join(path, "delimiter"),
                 "\"" + shortened(delimiter) + "\" is not known, allowed: \",\", \";\", bar, tab or space");
  return entries;
}
}  // namespace

bool read_survey_entry(const YAML::Node& node, const std::string& path, SurveyEntry& entry, Problems& problems)
{
  if (!node.IsMap()) return read_text(node, path, entry.file, problems);
  const auto entries = read_format(node, path, survey_of_scene, entry.format, problems);
  const auto file = entries.find("file");
  return file != entries.end() && read_text(file->second, join(path, "file"), entry.file, problems) && problems.empty();
}

SurveyFormat read_survey_format(const std::string& file)
{
  Problems problems(file);
  const TextFile text = read_text_file(file, "a map of a survey's columns");
  SurveyFormat format;
  read_format(load_document(text.text, problems).root, "", survey_of_command, format, problems);
  problems.raise();
  return format;
}

SurveyFormat survey_format(const std::string& columns, bool pass_over, bool plan)
{
  SurveyFormat format = columns.empty() ? SurveyFormat() : read_survey_format(columns);
  if (pass_over) format.pass_over = 1.0;
  format.plan = plan;
  return format;
}

}  // namespace drill_rig_sim
