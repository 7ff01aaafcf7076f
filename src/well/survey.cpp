// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/survey.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "drill_rig_sim/well/well_checks.h"

namespace drill_rig_sim
{
namespace
{
void check(const std::vector<SurveyStation>& stations, const std::optional<TieIn>& tie_in)
{
  const std::vector<SurveyProblem> problems = survey_problems(stations, tie_in);
  if (!problems.empty())
    throw std::invalid_argument("survey station " + std::to_string(problems.front().station + 1) + ": " + problems.front().text);
}
}  // namespace

Survey::Survey(const std::vector<SurveyStation>& stations, const std::optional<TieIn>& tie_in)
{
  check(stations, tie_in);
  points_.push_back({stations[0].md, tie_in ? tie_in->position() : Eigen::Vector3d::Zero(),
                     tangent_from(stations[0].inclination, stations[0].azimuth)});
  for (std::size_t i = 1; i < stations.size(); ++i)
  {
    const PathPoint from = points_.back();
    const Eigen::Vector3d tangent = tangent_from(stations[i].inclination, stations[i].azimuth);
    Arc arc;
    arc.length = stations[i].md - from.md;
    arc.turn = tangent - from.tangent;
    arc.bisector = tangent + from.tangent;
    arc.dogleg = 2.0 * std::atan2(arc.turn.norm(), arc.bisector.norm());
    arc.bisector.normalize();
    arc.inverse_sinc = 1.0 / sinc(0.5 * arc.dogleg);
    points_.push_back({stations[i].md, from.position + chord_of_arc(from.tangent, tangent, arc.length), tangent});
    arcs_.push_back(arc);
  }
}

double Survey::curvature(int i) const noexcept
{
  const Arc& arc = arcs_[static_cast<std::size_t>(i)];
  return arc.dogleg / arc.length;
}

double Survey::dogleg_severity(int i) const noexcept
{
  return 30.0 * curvature(i);
}

int Survey::arc_at(double md) const noexcept
{
  const auto above = std::upper_bound(points_.begin(), points_.end(), md, [](double m, const PathPoint& p) { return m < p.md; });
  const int i = static_cast<int>(above - points_.begin()) - 1;
  return std::clamp(i, 0, size() - 2);
}

PathPoint Survey::at(double md) const noexcept
{
  if (md <= first_md())
    return {md, points_.front().position + (md - first_md()) * points_.front().tangent, points_.front().tangent};
  if (md >= last_md()) return {md, points_.back().position + (md - last_md()) * points_.back().tangent, points_.back().tangent};
  const int i = arc_at(md);
  const PathPoint& from = station(i);
  const Arc& arc = arcs_[static_cast<std::size_t>(i)];
  const double u = (md - from.md) / arc.length;
  const double half = 0.5 * arc.dogleg;
  const double s1 = sinc(u * half);
  const double s2 = sinc((1.0 - u) * half);
  PathPoint p;
  p.md = md;
  p.position = from.position + arc.length * (u * s1 * std::cos((1.0 - u) * half) * arc.bisector -
                                             0.5 * u * (1.0 - u) * s1 * s2 * arc.inverse_sinc * arc.turn);
  const double phi = (u - 0.5) * arc.dogleg;
  p.tangent = std::cos(phi) * arc.bisector + (u - 0.5) * sinc(phi) * arc.inverse_sinc * arc.turn;
  return p;
}

}  // namespace drill_rig_sim
