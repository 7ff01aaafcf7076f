// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/projection.h"

#include <cmath>

#include "drill_rig_sim/math/unit_table.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/problem.h"
#include "drill_rig_sim/well/well_checks.h"

namespace drill_rig_sim
{
namespace
{
using Eigen::Vector3d;

Vector3d tangent_of(const SurveyStation& station)
{
  return tangent_from(station.inclination, station.azimuth);
}

// of the last interval
double last_dogleg(const std::vector<SurveyStation>& survey)
{
  const Vector3d before = tangent_of(survey[survey.size() - 2]), last = tangent_of(survey.back());
  return 2.0 * std::atan2((last - before).norm(), (last + before).norm());
}

double last_length(const std::vector<SurveyStation>& survey)
{
  return survey.back().md - survey[survey.size() - 2].md;
}

// the direction of the last interval's arc, `length` beyond its end
Vector3d direction_beyond(const std::vector<SurveyStation>& survey, double length)
{
  const Vector3d before = tangent_of(survey[survey.size() - 2]);
  Vector3d last = tangent_of(survey.back());
  const double dogleg = last_dogleg(survey);
  if (dogleg < 1e-9) return last;
  const double turn = dogleg * length / last_length(survey);
  return std::cos(turn) * last + std::sin(turn) / std::sin(dogleg) * (std::cos(dogleg) * last - before);
}

std::string two_digits(double value)
{
  return plain(1e-2 * std::round(1e2 * value));
}

// a remark of the scene is shown in both systems of units, whatever --units says
std::string in_both(double length)
{
  return two_digits(length) + " m (" + two_digits(static_cast<double>(length / exact::foot)) + " ft)";
}
}  // namespace

std::string project_survey(WellSpec& well)
{
  std::vector<SurveyStation>& survey = well.survey;
  const double last = survey.back().md, length = well.hole_depth - last;
  if (well.project == Projection::none || !(length > 0.0) || length > longest_projection || survey.size() < 2) return "";
  std::string how = "in the last station's direction";
  SurveyStation bottom = survey.back();
  bottom.md = well.hole_depth;
  if (well.project == Projection::curvature)
  {
    how = "on the last interval's arc of " + two_digits(last_dogleg(survey) / last_length(survey) * 30.0 / degree) + " deg/30 m";
    const Vector3d direction = direction_beyond(survey, length);
    bottom.inclination = inclination_of(direction);
    bottom.azimuth = azimuth_of(direction);
  }
  if (length < least_station_spacing)
    survey.back() = bottom;
  else
    survey.push_back(bottom);
  return "the survey was projected " + in_both(length) + " from its last station, " + in_both(last) + ", to the bottom, " + how +
         ": " + two_digits(bottom.inclination / degree) + " deg inclination, " + two_digits(bottom.azimuth / degree) +
         " deg azimuth";
}

}  // namespace drill_rig_sim
