#include <cmath>
#include <cstdio>
#include <memory>

#include "drill_command.h"
#include "drill_options.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/survey_file.h"
#include "drill_rig_sim/well/survey.h"
#include "drill_scene.h"

namespace drill_rig_sim
{
namespace
{
struct SurveyOptions
{
  std::string file, columns;
  bool pass_over = false;
};

SurveyFormat format_of(const SurveyOptions& options)
{
  SurveyFormat format;
  if (!options.columns.empty()) format = read_survey_format(options.columns);
  if (options.pass_over) format.pass_over = 1.0;
  return format;
}

void print_survey(const SurveyOptions& options)
{
  const SurveyTable table = read_survey_file(options.file, format_of(options));
  print_remarks(table.remarks);
  const Survey survey(table.stations, table.tie_in);
  std::printf("%10s %8s %8s %11s %11s %11s %9s\n", "MD m", "incl deg", "azi deg", "north m", "east m", "TVD m", "deg/30 m");
  for (int i = 0; i < survey.size(); ++i)
  {
    const SurveyStation& station = table.stations[static_cast<std::size_t>(i)];
    const Eigen::Vector3d& p = survey.station(i).position;
    const double severity = i == 0 ? 0.0 : survey.dogleg_severity(i - 1) / degree;
    std::printf("%10.2f %8.2f %8.2f %11.3f %11.3f %11.3f %9.3f\n", station.md, station.inclination / degree,
                station.azimuth / degree, p.y(), p.x(), -p.z(), severity);
  }
}
}  // namespace

Command add_survey_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("survey", "prints a survey's minimum-curvature table");
  const auto options = std::make_shared<SurveyOptions>();
  add_file(*words, "FILE", options->file, "the survey's table (.csv), or a WITSML trajectory (.xml)");
  add_text(*words, "--columns", options->columns, "MAP.yaml", "a map of its columns, units and delimiter (.yaml): the keys of a scene's well.survey");
  words->add_flag("--pass-over", options->pass_over, "pass over stations without a value and those that equal the one before");
  return {words, [options] { print_survey(*options); }};
}

}  // namespace drill_rig_sim
