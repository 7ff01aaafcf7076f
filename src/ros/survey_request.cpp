// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/survey_request.h"

#include "drill_rig_sim/ros/parameters.h"

namespace drill_rig_sim
{
namespace
{
/// What the request says of the first station's place, if it says anything.
std::optional<TieIn> tie_in_of(const LoadSurvey::Request& request)
{
  const TieIn tie_in{request.tie_in_north, request.tie_in_east, request.tie_in_tvd};
  if (tie_in.north == 0.0 && tie_in.east == 0.0 && tie_in.tvd == 0.0) return std::nullopt;
  return tie_in;
}
}  // namespace

NewWell to_new_well(const LoadSurvey::Request& request)
{
  const std::string file = request.file.empty() ? "" : find_file("file", request.file, "config/surveys");
  const std::string columns = request.columns.empty() ? "" : find_file("columns", request.columns, "config/surveys");
  return {file,
          request.md,
          request.inclination,
          request.azimuth,
          tie_in_of(request),
          request.hole_depth,
          request.bit_depth,
          survey_format(columns, request.pass_over != 0)};
}

}  // namespace drill_rig_sim
