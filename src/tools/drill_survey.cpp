// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <memory>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/survey_file.h"
#include "drill_rig_sim/well/survey.h"
#include "drill_scene.h"
#include "drill_survey_file.h"
#include "drill_units.h"

namespace drill_rig_sim
{
namespace
{
struct SurveyOptions
{
  std::string file;
  SurveyFileOptions reading;
  std::string units = "si";
};

void print_survey(const SurveyOptions& options)
{
  const SurveyTable table = read_survey_file(options.file, survey_format(options.reading.columns, options.reading.pass_over));
  print_remarks(table.remarks);
  const Survey survey(table.stations, table.tie_in);
  const Printed printed(options.units);
  constexpr Printed::InSI depth{"%.2f", "m"}, place{"%.3f", "m"}, per_30_m{"%.3f", "deg/30 m", 30.0 / degree};
  const std::string unit = printed.unit(Dimension::length, depth);
  const auto length = [&](double si, const Printed::InSI& in_si) { return printed.number(si, Dimension::length, in_si); };
  std::printf("%10s %8s %8s %11s %11s %11s %9s\n", ("MD " + unit).c_str(), "incl deg", "azi deg", ("north " + unit).c_str(),
              ("east " + unit).c_str(), ("TVD " + unit).c_str(), printed.unit(Dimension::dogleg, per_30_m));
  for (int i = 0; i < survey.size(); ++i)
  {
    const SurveyStation& station = table.stations[static_cast<std::size_t>(i)];
    const Eigen::Vector3d& p = survey.station(i).position;
    const double severity = i == 0 ? 0.0 : survey.dogleg_severity(i - 1) / 30.0;
    std::printf("%10s %8.2f %8.2f %11s %11s %11s %9s\n", length(station.md, depth).c_str(), station.inclination / degree,
                station.azimuth / degree, length(p.y(), place).c_str(), length(p.x(), place).c_str(),
                length(0.0 - p.z(), place).c_str(), printed.number(severity, Dimension::dogleg, per_30_m).c_str());
  }
}
}  // namespace

Command add_survey_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("survey", "prints a survey's minimum-curvature table");
  const auto options = std::make_shared<SurveyOptions>();
  add_file(*words, "FILE", options->file, "the survey's table (.csv, .las), or a WITSML trajectory (.xml)");
  add_survey_file_options(*words, options->reading, "its");
  add_units(*words, options->units);
  return {words, [options] { print_survey(*options); }};
}

}  // namespace drill_rig_sim
