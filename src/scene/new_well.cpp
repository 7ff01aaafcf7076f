// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/scene/new_well.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "drill_rig_sim/scene/scene_problems.h"
#include "drill_rig_sim/scene/survey_file.h"
#include "drill_rig_sim/well/projection.h"

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

std::vector<SurveyStation> stations_of(const NewWell& well)
{
  if (well.md.size() != well.inclination.size() || well.md.size() != well.azimuth.size())
    refuse("md, inclination and azimuth have ", well.md.size(), ", ", well.inclination.size(), " and ", well.azimuth.size(),
           " entries; needed: the same number of each");
  std::vector<SurveyStation> stations(well.md.size());
  for (std::size_t i = 0; i < stations.size(); ++i) stations[i] = {well.md[i], well.inclination[i], well.azimuth[i]};
  return stations;
}

/// The stations from the rotary table down; `remarks` of their file.
std::vector<SurveyStation> whole_survey(const NewWell& well, std::vector<std::string>& remarks)
{
  SurveyTable table;
  table.tie_in = well.tie_in;
  if (well.file.empty())
    table.stations = stations_of(well);
  else
    table = read_survey_file(well.file, well.format, table.tie_in);
  remarks = table.remarks;
  const std::vector<SurveyProblem> problems = survey_problems(table.stations, table.tie_in);
  if (!problems.empty()) refuse("station ", problems.front().station, ": ", problems.front().text);
  if (!well.tie_in && table.stations.front().md == 0.0) return table.stations;
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

double off_bottom(const Scene& scene)
{
  return scene.well.hole_depth - scene.start.bit_depth;
}

Scene with_well(const Scene& scene, double off_bottom, const NewWell& well)
{
  if (well.file.empty() == well.md.empty()) refuse("needed: either file, or md, inclination and azimuth");
  Scene next = scene;
  next.well.survey = whole_survey(well, next.remarks);

  const double last = next.well.survey.back().md;
  const bool projected = next.well.project != Projection::none;
  if (!(well.hole_depth >= 0.0 && well.hole_depth <= last + (projected ? longest_projection : 0.0)))
    refuse("hole_depth is ", well.hole_depth, "; allowed is 0 (the last station) to ", last, " m",
           projected ? ", and " + metres(longest_projection) + " further by the scene's well.project" : "");
  next.well.hole_depth = well.hole_depth > 0.0 ? well.hole_depth : last;
  const std::string done = project_survey(next.well);
  if (!done.empty()) next.remarks.push_back(done);

  if (!(well.bit_depth >= 0.0 && well.bit_depth <= next.well.hole_depth))
    refuse("bit_depth is ", well.bit_depth, "; allowed is 0 (", off_bottom, " m off bottom) to ", next.well.hole_depth, " m");
  next.start.bit_depth = well.bit_depth > 0.0 ? well.bit_depth : next.well.hole_depth - off_bottom;
  next.well.pilot_depth = next.well.pilot_diameter = 0.0;  // of the scene's own hole
  next.well.sections = fitted(next.well.sections, next.well.hole_depth);
  const ProblemList problems = scene_problems(next);
  if (!problems.empty()) refuse(problems.front().key, ": ", problems.front().text);
  return next;
}

Scene with_bit_depth(const Scene& scene, double bit_depth)
{
  if (!(bit_depth >= 0.0 && bit_depth <= scene.well.hole_depth))
    throw std::runtime_error("bit_depth is " + std::to_string(bit_depth) +
                             "; allowed is 0 (as the scene says) to the hole's depth, " + std::to_string(scene.well.hole_depth) +
                             " m");
  Scene next = scene;
  if (bit_depth > 0.0) next.start.bit_depth = bit_depth;
  return next;
}

}  // namespace drill_rig_sim
