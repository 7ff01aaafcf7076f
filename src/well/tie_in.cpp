// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/tie_in.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/problem.h"
#include "drill_rig_sim/well/tie_in_reach.h"
#include "drill_rig_sim/well/well_checks.h"

namespace drill_rig_sim
{
namespace
{
using Eigen::Vector3d;

// the header's polygon with rounded corners
struct Hole
{
  double straight;               // x
  double middle;                 // l
  double rounding;               // p
  Vector3d between;              // direction of the middle side
  double first_arc, second_arc;  // lengths, p f(a) and p f(b)
  double turn;                   // the sharper one [1/m]

  double length() const { return 2.0 * straight + middle - 4.0 * rounding + first_arc + second_arc; }
};

double arc_length(double angle, double rounding)
{
  return angle < 1e-9 ? 2.0 * rounding : rounding * angle / std::tan(0.5 * angle);
}

Hole hole_of(const Vector3d& end, const Vector3d& direction, double x)
{
  const Vector3d down = -Vector3d::UnitZ();
  const Vector3d side = end - x * direction - x * down;
  Hole hole;
  hole.straight = x;
  hole.middle = side.norm();
  hole.rounding = std::min(x, 0.5 * hole.middle);
  hole.between = side.normalized();
  const double first = angle_between(down, hole.between), second = angle_between(hole.between, direction);
  hole.first_arc = arc_length(first, hole.rounding);
  hole.second_arc = arc_length(second, hole.rounding);
  hole.turn = std::tan(0.5 * std::max(first, second)) / hole.rounding;
  return hole;
}

// the straight ends at which `is_short` turns from true to false, between nothing and half of `length`
template <class IsShort>
double bisect(double length, const IsShort& is_short)
{
  double low = 0.0, high = 0.5 * length;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (is_short(middle) ? low : high) = middle;
  }
  return high;
}

bool is_smooth(const Hole& hole)
{
  return hole.turn <= sharpest_tie_in * degree / 30.0;
}

// the hole of about `length`; one that is not smooth if there is none
Hole find_hole(const Vector3d& end, const Vector3d& direction, double length)
{
  const double tolerance = tie_in_tolerance(length);
  Hole arcs = hole_of(end, direction, bisect(length, [&](double x) { return 2.0 * x < hole_of(end, direction, x).middle; }));
  if (is_smooth(arcs) && std::abs(arcs.length() - length) <= tolerance) return arcs;
  return hole_of(end, direction, bisect(length, [&](double x) { return hole_of(end, direction, x).length() < length; }));
}

// stations where arcs begin and end, stretched to `length`; none so near to another that it would be refused
std::vector<SurveyStation> stations_of(const Hole& hole, const Vector3d& direction, double length)
{
  const Vector3d down = -Vector3d::UnitZ();
  const double stretch = length / hole.length();
  std::vector<SurveyStation> stations = {{0.0, 0.0, 0.0}};
  double md = 0.0;
  const auto add = [&](double piece, const Vector3d& tangent)
  {
    md += stretch * piece;
    if (md - stations.back().md < least_station_spacing || length - md < least_station_spacing) return;
    stations.push_back({md, inclination_of(tangent), azimuth_of(tangent)});
  };
  add(hole.straight - hole.rounding, down);
  add(hole.first_arc, hole.between);
  add(hole.middle - 2.0 * hole.rounding, hole.between);
  add(hole.second_arc, direction);
  return stations;
}
}  // namespace

std::string tie_survey_in(const TieIn& tie_in, std::vector<SurveyStation>& survey)
{
  const SurveyStation& first = survey.front();
  if (first.md == 0.0) return "the first station is at 0, the rotary table; allowed: only with a first station below it";
  if (first.md < least_station_spacing)
    return "the first md is " + metres(first.md) + ", allowed: " + metres(least_station_spacing) + " or more";
  if (!(tie_in.tvd > 0.0)) return "tvd " + metres(tie_in.tvd) + " is not below the rotary table, allowed: above 0";
  const Vector3d end = tie_in.position();
  if (!is_within_reach(tie_in, first.md))
    return "the first station is " + metres(end.norm()) + " from the rotary table, allowed: up to its measured depth, " +
           metres(first.md);
  const Vector3d direction = tangent_from(first.inclination, first.azimuth);
  const Hole hole = find_hole(end, direction, first.md);
  if (!is_smooth(hole) || std::abs(hole.length() - first.md) > tie_in_tolerance(first.md))
    return "no hole of " + metres(first.md) +
           " connects the rotary table (vertical) with the first station at a dogleg severity of up to " +
           plain(sharpest_tie_in) + " deg/30 m";
  const std::vector<SurveyStation> above = stations_of(hole, direction, first.md);
  survey.insert(survey.begin(), above.begin(), above.end());
  return "";
}

}  // namespace drill_rig_sim
