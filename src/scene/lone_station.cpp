// SPDX-License-Identifier: BSD-3-Clause
#include "lone_station.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
constexpr double least_off = 2.0 * degree;         // of a station that is wrong; wells swing by 2.6 deg from stand to stand
constexpr double least_unmeasured = 1.0 * degree;  // the same where an angle is 0 or -1
constexpr double off_others = 3.0;                 // times what any other station is off
constexpr std::size_t fewest_stations = 8;         // that tell how far stations of a well are off
constexpr double longest_step = 61.0;  // [m]; farther apart, as in plans by their corners, a hole may turn there and back

/// How a station lies beside its two neighbours.
struct Offset
{
  double off = 0.0;         // from the direction between theirs [rad]
  double neighbours = 0.0;  // from one of them to the other [rad]
};

Eigen::Vector3d direction_of(const SurveyStation& station)
{
  return tangent_from(station.inclination, station.azimuth);
}

Offset offset_of(const SurveyStation& above, const SurveyStation& station, const SurveyStation& below)
{
  const double share = (station.md - above.md) / (below.md - above.md);
  const Eigen::Vector3d a = direction_of(above), b = direction_of(below);
  const Eigen::Vector3d between = ((1.0 - share) * a + share * b).normalized();
  return {angle_between(between, direction_of(station)), angle_between(a, b)};
}

bool stands_for_none(double angle)
{
  const double number = angle / degree;
  return std::abs(number) < 1e-9 || std::abs(number + 1.0) < 1e-9;
}

// an angle that stands for none here and not beside
bool is_unmeasured(const SurveyStation& station, const std::vector<SurveyStation>& beside, double SurveyStation::*angle)
{
  return stands_for_none(station.*angle) &&
         std::none_of(beside.begin(), beside.end(),
                      [angle](const SurveyStation& other) { return stands_for_none(other.*angle); });
}

std::string unmeasured_line(const SurveyStation& station, const std::vector<SurveyStation>& beside, const UnitName& unit)
{
  const bool azimuth = is_unmeasured(station, beside, &SurveyStation::azimuth);
  const auto angle = azimuth ? &SurveyStation::azimuth : &SurveyStation::inclination;
  std::string others;
  char text[120];
  for (const SurveyStation& other : beside)
  {
    std::snprintf(text, sizeof text, "%s%.4g", others.empty() ? "" : " and ", other.*angle / degree);
    others += text;
  }
  std::snprintf(text, sizeof text, "at %.10g %s the %s is %.4g deg, beside it ", station.md / unit.factor(), unit.name,
                azimuth ? "azimuth" : "inclination", station.*angle / degree);
  return text + others + " deg; was it measured?";
}

std::string lone_line(const SurveyStation& station, const SurveyStation& above, const SurveyStation& below, double off,
                      const UnitName& unit)
{
  char text[300];
  std::snprintf(text, sizeof text,
                "the station at %.10g %s (inclination %.4g, azimuth %.4g deg) lies %.2g deg off those beside it (%.4g, %.4g and "
                "%.4g, %.4g deg), which fit together; is one of its numbers wrong?",
                station.md / unit.factor(), unit.name, station.inclination / degree, station.azimuth / degree, off / degree,
                above.inclination / degree, above.azimuth / degree, below.inclination / degree, below.azimuth / degree);
  return text;
}

// the largest number of a list but for those within one place of i
double largest_besides(const std::vector<double>& numbers, std::size_t i)
{
  double largest = 0.0;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (k + 1 < i || k > i + 1) largest = std::fmax(largest, numbers[k]);
  return largest;
}

std::string inner_station(const std::vector<SurveyStation>& survey, const UnitName& unit)
{
  std::vector<double> off(survey.size()), neighbours(survey.size());
  for (std::size_t i = 1; i + 1 < survey.size(); ++i)
  {
    const Offset offset = offset_of(survey[i - 1], survey[i], survey[i + 1]);
    off[i] = offset.off;
    neighbours[i] = offset.neighbours;
  }
  const auto i = static_cast<std::size_t>(std::max_element(off.begin(), off.end()) - off.begin());
  if (off[i] < least_unmeasured || neighbours[i] > off[i]) return "";
  const SurveyStation &above = survey[i - 1], &station = survey[i], &below = survey[i + 1];
  const std::vector<SurveyStation> beside{above, below};
  if (is_unmeasured(station, beside, &SurveyStation::inclination) || is_unmeasured(station, beside, &SurveyStation::azimuth))
    return unmeasured_line(station, beside, unit);
  const bool lone = off[i] >= least_off && off[i] >= off_others * largest_besides(off, i) && survey.size() >= fewest_stations &&
                    below.md - above.md <= 2.0 * longest_step;
  return lone ? lone_line(station, above, below, off[i], unit) : "";
}

// where the hole turns more to the first or last station than anywhere else
std::string end_station(const std::vector<SurveyStation>& survey, const UnitName& unit)
{
  std::vector<double> turns;
  for (std::size_t i = 1; i < survey.size(); ++i)
    turns.push_back(angle_between(direction_of(survey[i - 1]), direction_of(survey[i])));
  const auto unmeasured = [&](std::size_t end, std::size_t next, std::size_t turn)
  {
    const bool apart = turns[turn] >= least_off && turns[turn] >= off_others * largest_besides(turns, turn);
    return apart && is_unmeasured(survey[end], {survey[next]}, &SurveyStation::azimuth) &&
           std::abs(survey[end].md - survey[next].md) <= longest_step;
  };
  const std::size_t last = survey.size() - 1;
  if (unmeasured(0, 1, 0)) return unmeasured_line(survey[0], {survey[1]}, unit);
  return unmeasured(last, last - 1, last - 1) ? unmeasured_line(survey[last], {survey[last - 1]}, unit) : "";
}
}  // namespace

std::string lone_station(const std::vector<SurveyStation>& survey, const UnitName& unit)
{
  if (survey.size() < 3) return "";
  const std::string inner = inner_station(survey, unit);
  return inner.empty() ? end_station(survey, unit) : inner;
}

}  // namespace drill_rig_sim
