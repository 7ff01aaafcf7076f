#include "drill_rig_sim/ros/survey_request.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "drill_rig_sim/ros/parameters.h"
#include "drill_rig_sim/scene/scene_problems.h"
#include "drill_rig_sim/scene/survey_csv.h"
#include "drill_rig_sim/well/tie_in.h"

namespace drill_rig_sim
{
namespace
{
template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  throw std::runtime_error(text.str());
}

std::vector<SurveyStation> stations_of(const LoadSurvey::Request& request)
{
  if (request.md.size() != request.inclination.size() || request.md.size() != request.azimuth.size())
    refuse("md, inclination and azimuth have ", request.md.size(), ", ", request.inclination.size(), " and ",
           request.azimuth.size(), " entries; allowed is one of each per station");
  std::vector<SurveyStation> stations(request.md.size());
  for (std::size_t i = 0; i < stations.size(); ++i) stations[i] = {request.md[i], request.inclination[i], request.azimuth[i]};
  return stations;
}

/// What the request says of the first station's place, if it says anything.
std::optional<TieIn> tie_in_of(const LoadSurvey::Request& request)
{
  const TieIn tie_in{request.tie_in_north, request.tie_in_east, request.tie_in_tvd};
  if (tie_in.north == 0.0 && tie_in.east == 0.0 && tie_in.tvd == 0.0) return std::nullopt;
  return tie_in;
}

/// The request's stations from the rotary table down.
std::vector<SurveyStation> whole_survey(const LoadSurvey::Request& request)
{
  SurveyTable table;
  table.tie_in = tie_in_of(request);
  const bool asked = table.tie_in.has_value();
  if (request.file.empty())
    table.stations = stations_of(request);
  else
    table = read_survey_csv(find_file("file", request.file, "config/surveys"), table.tie_in);
  const std::vector<SurveyProblem> problems = survey_problems(table.stations, table.tie_in.has_value());
  if (!problems.empty()) refuse("station ", problems.front().station, ": ", problems.front().text);
  if (!asked && table.stations.front().md == 0.0) return table.stations;
  const std::string problem = tie_survey_in(*table.tie_in, table.stations);
  if (!problem.empty()) refuse("tie_in: ", problem);
  return table.stations;
}

// Sections that begin below the bottom go, the last one reaches it.
std::vector<HoleSection> fitted(std::vector<HoleSection> sections, double hole_depth)
{
  const auto last = std::find_if(sections.begin(), sections.end() - 1, [=](const HoleSection& s) { return s.to >= hole_depth; });
  sections.erase(last + 1, sections.end());
  sections.back().to = std::max(sections.back().to, hole_depth);
  return sections;
}
}  // namespace

Scene with_survey(const Scene& scene, double off_bottom, const LoadSurvey::Request& request)
{
  if (request.file.empty() == request.md.empty()) refuse("allowed is either a file or stations");
  Scene next = scene;
  next.well.survey = whole_survey(request);

  const double last = next.well.survey.back().md;
  if (!(request.hole_depth >= 0.0 && request.hole_depth <= last))
    refuse("hole_depth is ", request.hole_depth, "; allowed is 0 (the last station) to ", last, " m");
  next.well.hole_depth = request.hole_depth > 0.0 ? request.hole_depth : last;

  if (!(request.bit_depth >= 0.0 && request.bit_depth <= next.well.hole_depth))
    refuse("bit_depth is ", request.bit_depth, "; allowed is 0 (", off_bottom, " m off bottom) to ", next.well.hole_depth, " m");
  next.start.bit_depth = request.bit_depth > 0.0 ? request.bit_depth : next.well.hole_depth - off_bottom;
  next.well.pilot_depth = next.well.pilot_diameter = 0.0;  // of the scene's own hole
  next.well.sections = fitted(next.well.sections, next.well.hole_depth);
  const ProblemList problems = scene_problems(next);
  if (!problems.empty()) refuse(problems.front().key, ": ", problems.front().text);
  return next;
}

}  // namespace drill_rig_sim
