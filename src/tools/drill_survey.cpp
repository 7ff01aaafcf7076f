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

namespace drill_rig_sim
{
namespace
{
struct SurveyOptions
{
  std::string file;
  SurveyFileOptions reading;
};

void print_survey(const SurveyOptions& options)
{
  const SurveyTable table = read_survey_file(options.file, survey_format(options.reading.columns, options.reading.pass_over));
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
  add_survey_file_options(*words, options->reading, "its");
  return {words, [options] { print_survey(*options); }};
}

}  // namespace drill_rig_sim
