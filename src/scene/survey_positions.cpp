// SPDX-License-Identifier: BSD-3-Clause
#include "survey_positions.h"

#include <cmath>
#include <cstdio>
#include <optional>

#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
constexpr double least = 1.0, share = 0.005;  // that other methods and rounding may leave [m], of the way along the hole
constexpr double convergence = 0.05;  // between norths, that surveys leave unsaid: of the way from the first station [rad]

// east, north, up
Eigen::Vector3d way_between(const SurveyStation& a, const SurveyStation& b)
{
  return chord_of_arc(tangent_from(a.inclination, a.azimuth), tangent_from(b.inclination, b.azimuth), b.md - a.md);
}

// what the file says of a station [m]
std::optional<double> said_of(const SurveyRow& row, std::size_t quantity, bool decimal_commas)
{
  double value = 0.0;
  if (!row.units[quantity] || read_cell(row.cells[quantity], decimal_commas, value) != CellKind::number) return std::nullopt;
  return value * row.units[quantity]->factor();
}
}  // namespace

std::string differing_tvd(const SurveyRows& survey, const std::vector<SurveyStation>& stations,
                          const std::vector<const SurveyRow*>& rows)
{
  std::optional<double> first;
  double depth = 0.0, from = 0.0, worst = 0.0;
  std::string text;
  for (std::size_t i = 0; i < stations.size(); ++i)
  {
    if (i > 0) depth -= way_between(stations[i - 1], stations[i]).z();
    const std::optional<double> said = said_of(*rows[i], survey_tvd, survey.decimal_commas);
    if (!said) continue;
    if (!first) from = stations[i].md;
    if (!first) first = *said - depth;
    const double off = std::abs(*said - *first - depth);
    if (off <= worst || off <= least + share * (stations[i].md - from)) continue;
    worst = off;
    char line[200];
    std::snprintf(line, sizeof line,
                  "its vertical depth at %.2f m is %.2f m, by minimum curvature %.2f m; is a unit or a column wrong?",
                  stations[i].md, *said, *first + depth);
    text = line;
  }
  return text;
}

std::string differing_displacement(const SurveyRows& survey, const std::vector<SurveyStation>& stations,
                                   const std::vector<const SurveyRow*>& rows)
{
  std::optional<Eigen::Vector2d> first;  // less the way up to there
  Eigen::Vector2d way = Eigen::Vector2d::Zero(), begin = way;
  double from = 0.0, worst = 0.0;
  std::string text;
  for (std::size_t i = 0; i < stations.size(); ++i)
  {
    if (i > 0) way += way_between(stations[i - 1], stations[i]).head<2>();
    const std::optional<double> east = said_of(*rows[i], survey_east, survey.decimal_commas),
                                north = said_of(*rows[i], survey_north, survey.decimal_commas);
    if (!east || !north) continue;
    const Eigen::Vector2d said(*east, *north);
    if (!first) from = stations[i].md, begin = way;
    if (!first) first = said - way;
    const Eigen::Vector2d right = *first + way;
    const double off = (said - right).norm();
    if (off <= worst || off <= least + share * (stations[i].md - from) + convergence * (way - begin).norm()) continue;
    worst = off;
    char line[300];
    std::snprintf(line, sizeof line,
                  "its north and east at %.2f m are %.2f and %.2f m, by minimum curvature %.2f and %.2f m; is a column wrong, or "
                  "do azimuths refer to another north?",
                  stations[i].md, said.y(), said.x(), right.y(), right.x());
    text = line;
  }
  return text;
}

}  // namespace drill_rig_sim
