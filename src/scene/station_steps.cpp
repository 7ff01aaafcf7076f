// SPDX-License-Identifier: BSD-3-Clause
#include "station_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t fewest_of_survey = 5;       // steps
constexpr double alike = 0.06, most_alike = 0.7;  // share by which steps differ from the usual one, share of the steps that do
constexpr double far = 3.0, farthest = 100.0;     // from which on a step is unusual: of the usual one, [m]
constexpr double too_far = 20.0;                  // of the usual one, of a last station whose direction was measured
constexpr double least_step = 0.3, most_step = 1.3, near = 0.1;  // of the usual step, that a depth with another digit may have
constexpr double same_direction = 1e-6;                          // [rad]

std::vector<double> steps_between(const std::vector<double>& depths)
{
  std::vector<double> steps;
  for (std::size_t i = 1; i < depths.size(); ++i) steps.push_back(depths[i] - depths[i - 1]);
  return steps;
}

// the middle one, where most are like it
std::optional<double> usual_step(std::vector<double> steps, std::size_t fewest)
{
  if (steps.size() < fewest) return std::nullopt;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double usual = *middle;
  const auto like_it =
      std::count_if(steps.begin(), steps.end(), [&](double step) { return std::abs(step - usual) <= alike * usual; });
  return static_cast<double>(like_it) < most_alike * static_cast<double>(steps.size()) ? std::nullopt
                                                                                       : std::optional<double>(usual);
}

std::vector<double> depths_of(const std::vector<SurveyStation>& survey)
{
  std::vector<double> depths;
  depths.reserve(survey.size());
  for (const SurveyStation& station : survey) depths.push_back(station.md);
  return depths;
}

// numbers whose whole digits are those of a number but for two neighbours that are exchanged
std::set<double> with_exchanged_digits(const std::string& digits, double fraction)
{
  std::set<double> found;
  for (std::size_t i = 0; i + 1 < digits.size(); ++i)
  {
    std::string other = digits;
    std::swap(other[i], other[i + 1]);
    found.insert(std::stod(other) + fraction);
  }
  return found;
}

// the same but for one that is another, one less or one more
std::set<double> with_another_digit(const std::string& digits, double fraction)
{
  std::set<double> found;
  for (std::size_t i = 0; i <= digits.size(); ++i)
  {
    for (const char digit : std::string("0123456789"))
    {
      if (i < digits.size()) found.insert(std::stod(digits.substr(0, i) + digit + digits.substr(i + 1)) + fraction);
      found.insert(std::stod(digits.substr(0, i) + digit + digits.substr(i)) + fraction);
    }
    if (i < digits.size() && digits.size() > 1) found.insert(std::stod(digits.substr(0, i) + digits.substr(i + 1)) + fraction);
  }
  return found;
}

/// A station at an end, which is far from its neighbour.
struct FarEnd
{
  double depth, neighbour, usual;  // in the unit of the file
  bool turns;                      // the hole has another direction there

  // the depth by another digit, which would stand as far from the neighbour as others do
  std::optional<double> instead() const
  {
    const double whole = std::floor(depth);
    const std::string digits = std::to_string(static_cast<long>(whole));
    const double side = depth > neighbour ? 1.0 : -1.0;
    for (const double other : with_exchanged_digits(digits, depth - whole))
      if (side * (other - neighbour) >= least_step * usual && side * (other - neighbour) <= most_step * usual) return other;
    if (!turns) return std::nullopt;  // hold sections and projections go on for any length
    for (const double other : with_another_digit(digits, depth - whole))
      if (std::abs(side * (other - neighbour) - usual) <= near * usual) return other;
    return std::nullopt;
  }
};

std::optional<FarEnd> far_end(const SurveyStation& end, const SurveyStation& neighbour, double usual, const UnitName& unit)
{
  const double step = std::abs(end.md - neighbour.md);
  if (step < far * usual || step < farthest) return std::nullopt;
  const double turn =
      (tangent_from(end.inclination, end.azimuth) - tangent_from(neighbour.inclination, neighbour.azimuth)).norm();
  return FarEnd{end.md / unit.factor(), neighbour.md / unit.factor(), usual / unit.factor(), turn > same_direction};
}

std::string line_of(const FarEnd& end, const char* which, const UnitName& unit)
{
  const std::optional<double> other = end.instead();
  const double step = std::abs(end.depth - end.neighbour);
  if (!other && !(end.turns && end.depth > end.neighbour && step > too_far * end.usual)) return "";
  char text[300], question[60] = "is its depth right?";
  if (other) std::snprintf(question, sizeof question, "is a digit of its depth wrong (%.10g %s)?", *other, unit.name);
  std::snprintf(text, sizeof text,
                "the %s station, at %.10g %s, stands %.6g %s from the next one, the others usually %.4g %s; %s", which, end.depth,
                unit.name, step, unit.name, end.usual, unit.name, question);
  return text;
}
}  // namespace

std::optional<double> step_in_feet(std::vector<double> depths, std::size_t fewest, bool joints)
{
  depths.erase(std::remove_if(depths.begin(), depths.end(), [](double depth) { return !std::isfinite(depth); }), depths.end());
  std::sort(depths.begin(), depths.end());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  const std::optional<double> usual = usual_step(steps_between(depths), fewest);
  if (!usual) return std::nullopt;
  const auto is_between = [&](double low, double high) { return *usual > low && *usual < high; };
  const bool of_pipe = is_between(60.2, 64.0) || is_between(89.5, 97.0) || (joints && is_between(30.1, 33.0));
  const std::array<double, 3> grids = {10.0, 25.0, 15.24};
  const bool of_list =
      std::any_of(grids.begin(), grids.end(), [&](double grid) { return std::abs(std::remainder(*usual, grid)) < 0.01; });
  return of_pipe && !of_list ? usual : std::nullopt;
}

std::string like_feet(const std::vector<SurveyStation>& survey)
{
  const std::optional<double> step = step_in_feet(depths_of(survey), fewest_of_survey, false);
  if (!step) return "";
  char text[200];
  std::snprintf(text, sizeof text,
                "its stations are usually %.4g m apart, as stands are in feet (62 or 93); is the unit of depth right?", *step);
  return text;
}

std::string wrong_digit(const std::vector<SurveyStation>& survey, const UnitName& unit)
{
  const std::optional<double> usual = usual_step(steps_between(depths_of(survey)), fewest_of_survey);
  if (!usual) return "";
  const std::size_t last = survey.size() - 1,
                    first = survey.front().md == 0.0 ? 1 : 0;  // a station at the table is no measured one
  std::string text;
  if (const auto end = far_end(survey[last], survey[last - 1], *usual, unit)) text = line_of(*end, "last", unit);
  if (const auto end = far_end(survey[first], survey[first + 1], *usual, unit); end && text.empty())
    text = line_of(*end, "first", unit);
  return text;
}

}  // namespace drill_rig_sim
