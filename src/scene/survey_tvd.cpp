#include "survey_tvd.h"

#include <cmath>
#include <cstdio>
#include <optional>

#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
constexpr double least = 1.0, share = 0.005;  // that other methods and rounding may leave [m], of the way along the hole

double drop_between(const SurveyStation& a, const SurveyStation& b)
{
  return -chord_of_arc(tangent_from(a.inclination, a.azimuth), tangent_from(b.inclination, b.azimuth), b.md - a.md).z();
}

// what the file says of a station [m]
std::optional<double> said_of(const SurveyRow& row, bool decimal_commas)
{
  double value = 0.0;
  if (!row.units[survey_tvd] || read_cell(row.cells[survey_tvd], decimal_commas, value) != CellKind::number) return std::nullopt;
  return value * row.units[survey_tvd]->factor();
}
}  // namespace

std::string differing_tvd(const SurveyRows& survey, const std::vector<SurveyStation>& stations, const std::vector<const SurveyRow*>& rows)
{
  std::optional<double> first;
  double depth = 0.0, from = 0.0, worst = 0.0;
  std::string text;
  for (std::size_t i = 0; i < stations.size(); ++i)
  {
    if (i > 0) depth += drop_between(stations[i - 1], stations[i]);
    const std::optional<double> said = said_of(*rows[i], survey.decimal_commas);
    if (!said) continue;
    if (!first) from = stations[i].md;
    if (!first) first = *said - depth;
    const double off = std::abs(*said - *first - depth);
    if (off <= worst || off <= least + share * (stations[i].md - from)) continue;
    worst = off;
    char line[200];
    std::snprintf(line, sizeof line, "its vertical depth at %.2f m is %.2f m, by minimum curvature %.2f m; is a unit or a column wrong?", stations[i].md, *said, *first + depth);
    text = line;
  }
  return text;
}

}  // namespace drill_rig_sim
