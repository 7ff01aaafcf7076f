// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/well_checks.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/projection.h"

namespace drill_rig_sim
{
namespace
{
constexpr double sharpest_turn = 179.9 * degree;

double turn_between(const SurveyStation& a, const SurveyStation& b)
{
  return angle_between(tangent_from(a.inclination, a.azimuth), tangent_from(b.inclination, b.azimuth));
}

std::string length_in(const LengthUnit& unit, double value)
{
  return plain(value / unit.factor) + " " + unit.name;
}

// of a station alone; empty if it is sound
std::string problem_of(const SurveyStation& s, const LengthUnit& unit)
{
  if (!std::isfinite(s.md) || !std::isfinite(s.inclination) || !std::isfinite(s.azimuth)) return "a value is not a finite number";
  if (s.md < 0.0 || s.md > deepest_well)
    return "md " + length_in(unit, s.md) + " is out of range, allowed: 0 to " + length_in(unit, deepest_well);
  if (s.inclination < 0.0 || s.inclination > pi)
    return "inclination " + plain(s.inclination / degree) + " deg is out of range, allowed: 0 to 180 deg";
  if (std::abs(s.azimuth) > 2.0 * pi + 1e-9)
    return "azimuth " + plain(s.azimuth / degree) + " deg is out of range, allowed: -360 to 360 deg";
  return "";
}

/// Problems of stations, of which one that is repeated becomes one line with a count.
class StationProblems
{
public:
  // `kind`: what is wrong with the station alone, "" where it is between two
  void add(std::size_t station, const std::string& text, const std::string& kind)
  {
    const auto found = kind.empty() ? kinds_.end() : kinds_.find(kind);
    if (found == kinds_.end())
    {
      if (!kind.empty()) kinds_[kind] = {problems_.size(), 0};
      problems_.push_back({station, text});
    }
    else
      ++found->second.further;
  }

  std::vector<SurveyProblem> all() const
  {
    std::vector<SurveyProblem> all = problems_;
    for (const auto& [kind, one] : kinds_)
      if (one.further > 0)
        all[one.place].text +=
            " (and " + std::to_string(one.further) + (one.further == 1 ? " further station)" : " further stations)");
    return all;
  }

private:
  struct Kind
  {
    std::size_t place, further;
  };
  std::vector<SurveyProblem> problems_;
  std::map<std::string, Kind> kinds_;
};

// of a sound station after a sound one; empty if they go together
std::string problem_between(const SurveyStation& before, const SurveyStation& s, const LengthUnit& unit)
{
  if (s.md <= before.md)
    return "md " + length_in(unit, s.md) + " is not deeper than the station before it, " + length_in(unit, before.md);
  if (s.md - before.md < least_station_spacing * (1.0 - 1e-6))
    return "md " + length_in(unit, s.md) + " is too close to the station before it, " + length_in(unit, before.md) +
           ", allowed: " + length_in(unit, least_station_spacing) + " or more between stations";
  if (turn_between(before, s) > sharpest_turn)
    return "the direction is opposite to that of the station before it, allowed: a turn of up to 179.9 deg";
  return "";
}

// The first station above the rotary table, of sound ones; none if all are below it.
std::vector<SurveyProblem> above_the_table(const std::vector<SurveyStation>& stations, double height, const LengthUnit& unit)
{
  Eigen::Vector3d before;
  for (std::size_t i = 0; i < stations.size(); ++i)
  {
    const Eigen::Vector3d tangent = tangent_from(stations[i].inclination, stations[i].azimuth);
    if (i > 0) height += chord_of_arc(before, tangent, stations[i].md - stations[i - 1].md).z();
    if (height > tie_in_rounding)
      return {{i, "lies " + plain(1e-2 * std::round(1e2 * height / unit.factor)) + " " + unit.name +
                      " above the rotary table, allowed: below it; is an inclination or a depth wrong?"}};
    before = tangent;
  }
  return {};
}

// stations from the bottom up: all of them are wrong for one reason
bool stand_upside_down(const std::vector<SurveyStation>& stations)
{
  return stations.size() > 2 && stations.back().md >= 0.0 &&
         std::adjacent_find(stations.begin(), stations.end(),
                            [](const SurveyStation& a, const SurveyStation& b) { return !(a.md > b.md); }) == stations.end();
}

std::string deeper_than_survey(double hole_depth, double last, Projection project)
{
  const std::string by = metres(hole_depth) == metres(last) ? " (by " + metres(hole_depth - last) + ")" : "";
  const std::string text =
      metres(hole_depth) + " is deeper than the survey" + by + ", allowed: up to its last station, " + metres(last);
  if (hole_depth > last + longest_projection)
    return text + (project == Projection::none ? "" : ", and with well.project " + metres(longest_projection) + " further");
  return text + "; well.project: straight or curvature extends it by up to " + metres(longest_projection);
}
}  // namespace

std::vector<SurveyProblem> survey_problems(const std::vector<SurveyStation>& stations, const std::optional<TieIn>& tie_in,
                                           const LengthUnit& unit)
{
  StationProblems problems;
  if (stations.size() < 2) problems.add(0, plain(static_cast<double>(stations.size())) + " station, needed: at least two", "");
  if (stations.size() > most_stations)
    return {{most_stations, "more than " + std::to_string(most_stations) + " stations, allowed: at most that many"}};
  if (stand_upside_down(stations))
    return {{1, "md " + length_in(unit, stations[1].md) + " is not deeper than the station before it, " +
                    length_in(unit, stations[0].md) + ": the stations are listed from the bottom up, needed: from the top down"}};
  bool before_is_good = false;
  for (std::size_t i = 0; i < stations.size(); ++i)
  {
    const SurveyStation& s = stations[i];
    const std::string alone = problem_of(s, unit);
    std::string problem = alone;
    if (alone.empty() && i == 0 && s.md != 0.0 && !tie_in)
      problem = "the first md is " + length_in(unit, s.md) +
                ", needed: 0 (the rotary table), or its position: tie_in, in a CSV file north_m, east_m, tvd_m";
    if (alone.empty() && before_is_good) problem = problem_between(stations[i - 1], s, unit);
    if (!problem.empty()) problems.add(i, problem, alone.substr(0, alone.find(' ')));
    before_is_good = alone.empty();
  }
  const std::vector<SurveyProblem> all = problems.all();
  return all.empty() ? above_the_table(stations, tie_in ? -tie_in->tvd : 0.0, unit) : all;
}

ProblemList well_problems(const WellSpec& well)
{
  ProblemList problems;
  const double last = well.survey.empty() ? 0.0 : well.survey.back().md;
  if (!(well.hole_depth > 0.0)) problems.emplace_back("well.hole_depth", "must be above 0 (got " + metres(well.hole_depth) + ")");
  if (well.hole_depth > last) problems.emplace_back("well.hole_depth", deeper_than_survey(well.hole_depth, last, well.project));
  if (well.sections.empty()) problems.emplace_back("well.sections", "the list is empty, needed: at least one section");
  double above = 0.0;
  for (std::size_t i = 0; i < well.sections.size(); ++i)
  {
    const HoleSection& section = well.sections[i];
    if (!(section.diameter > 0.0))
      problems.emplace_back(item_key("well.sections", i, "diameter"), "must be above 0 (got " + metres(section.diameter) + ")");
    if (!(section.friction >= 0.0))
      problems.emplace_back(item_key("well.sections", i, "friction"), "must be 0 or more (got " + plain(section.friction) + ")");
    if (section.static_ratio < 1.0)
      problems.emplace_back(item_key("well.sections", i, "static_ratio"),
                            "must be 1 or more (got " + plain(section.static_ratio) + ")");
    if (section.stribeck_speed <= 0.0)
      problems.emplace_back(item_key("well.sections", i, "stribeck_speed"),
                            "must be above 0 (got " + plain(section.stribeck_speed) + " m/s)");
    if (!(section.to > above))
      problems.emplace_back(item_key("well.sections", i, "to"),
                            metres(section.to) + " is not below the begin of the section, " + metres(above));
    else if (section.to - above < least_section_length * (1.0 - 1e-6))
      problems.emplace_back(
          item_key("well.sections", i, "to"),
          "the section is " + metres(section.to - above) + " long, allowed: " + metres(least_section_length) + " or more");
    above = section.to;
  }
  if (!well.sections.empty() && well.sections.back().to < std::min(well.hole_depth, last))
    problems.emplace_back(item_key("well.sections", well.sections.size() - 1, "to"),
                          "the last section ends at " + metres(well.sections.back().to) + ", needed: down to hole_depth, " +
                              metres(well.hole_depth));
  if (well.pilot_depth > 0.0 && !(well.pilot_depth > well.hole_depth && well.pilot_depth <= last))
    problems.emplace_back("well.pilot_depth", "must be 0, or between hole_depth (" + metres(well.hole_depth) +
                                                  ") and the last station (" + metres(last) + "), got " +
                                                  metres(well.pilot_depth));
  if ((well.pilot_depth > 0.0) != (well.pilot_diameter > 0.0))
    problems.emplace_back(well.pilot_depth > 0.0 ? "well.pilot_depth" : "well.pilot_diameter",
                          "pilot_depth and pilot_diameter belong together, allowed: both or neither");
  return problems;
}

ProblemList trajectory_problems(const TrajectorySpec& trajectory)
{
  ProblemList problems;
  if (trajectory.stage_two_steps < 0 ||
      (trajectory.stage_two_steps == 0 && !(trajectory.stage_two_length >= least_stage_two_length)))
    problems.emplace_back("trajectory", "stage_two_length must be 1 mm or more, or stage_two_steps positive");
  return problems;
}

}  // namespace drill_rig_sim
