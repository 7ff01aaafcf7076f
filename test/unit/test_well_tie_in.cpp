// SPDX-License-Identifier: BSD-3-Clause
// A survey that begins below the rotary table: the hole above its first station, and where the stations then lie.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/survey.h"
#include "drill_rig_sim/well/tie_in.h"
#include "drill_rig_sim/well/well_checks.h"
#include "in_source.h"

namespace drill_rig_sim::test_well_tie_in
{
namespace
{
using Eigen::Vector3d;

TieIn tie_in_at(const Vector3d& p)
{
  return {p.y(), p.x(), -p.z()};
}

std::string refusal(const TieIn& tie_in, const SurveyStation& first)
{
  const std::vector<SurveyStation> before = {first, {first.md + 100.0, first.inclination, first.azimuth}};
  std::vector<SurveyStation> survey = before;
  const std::string problem = tie_survey_in(tie_in, survey);
  EXPECT_EQ(problem.empty(), survey.size() > before.size()) << "a refused survey is left alone";
  return problem;
}

/// The survey with the hole above it; checks that this is sound, leaves the table vertically and turns no more than is allowed.
Survey tied_in(const TieIn& tie_in, std::vector<SurveyStation> survey)
{
  const double first = survey.front().md;
  EXPECT_EQ("", tie_survey_in(tie_in, survey)) << first;
  EXPECT_TRUE(survey_problems(survey).empty()) << first;
  const Survey whole(survey);
  EXPECT_EQ(0.0, whole.station(0).tangent.head<2>().norm());
  for (int i = 0; whole.station(i).md < first; ++i)
    EXPECT_LE(whole.dogleg_severity(i), sharpest_tie_in * degree * (1.0 + 1e-9)) << first;
  return whole;
}

TEST(TieIn, AVerticalHoleIsALine)
{
  const Survey survey = tied_in({0.0, 0.0, 100.0}, {{100.0, 0.0, 0.3}, {150.0, 0.0, 0.0}});
  for (const double md : {10.0, 49.0, 77.0, 100.0, 130.0})
    EXPECT_NEAR((survey.at(md).position - Vector3d(0.0, 0.0, -md)).norm(), 0.0, 1e-12);
}

// Two arcs of one curvature that meet half-way are one arc: R (1 - cos 30 deg) to the east, R sin 30 deg down.
TEST(TieIn, WhatLiesOnAnArcIsAnArc)
{
  const double radius = 600.0, angle = 30.0 * degree;
  const Vector3d end(radius * (1.0 - std::cos(angle)), 0.0, -radius * std::sin(angle));
  const Survey survey = tied_in(tie_in_at(end), {{radius * angle, angle, 90.0 * degree}, {400.0, angle, 90.0 * degree}});
  for (const double share : {0.2, 0.5, 0.8, 1.0})
  {
    const double a = share * angle;
    EXPECT_NEAR((survey.at(radius * a).position - Vector3d(radius * (1.0 - std::cos(a)), 0.0, -radius * std::sin(a))).norm(), 0.0,
                1e-9)
        << share;
  }
}

// Vertical to 500 m, 3 deg/30 m to 35 deg at 850 m, held to 2500 m: the hole that leads there is another, of the same length.
TEST(TieIn, AHoleThatIsNotTheSmoothestHasItsLength)
{
  const double azimuth = 40.0 * degree, held = 35.0 * degree;
  const Survey drilled(
      {{0.0, 0.0, 0.0}, {500.0, 0.0, azimuth}, {850.0, held, azimuth}, {2500.0, held, azimuth}, {2600.0, held, azimuth}});
  const Survey survey = tied_in(tie_in_at(drilled.station(3).position), {{2500.0, held, azimuth}, {2600.0, held, azimuth}});
  for (const double md : {2500.0, 2600.0}) EXPECT_NEAR((survey.at(md).position - drilled.at(md).position).norm(), 0.0, 1e-6);
  EXPECT_NEAR((survey.at(2500.0).tangent - drilled.at(2500.0).tangent).norm(), 0.0, 1e-12);
}

// 100 m of hole to 99.96 m of depth, straight: the hole is stretched by 0.4 permille; to 99.9 m no longer.
TEST(TieIn, MeasuredDepthsAreRounded)
{
  const Survey survey = tied_in({0.0, 0.0, 99.96}, {{100.0, 0.0, 0.0}, {150.0, 0.0, 0.0}});
  EXPECT_NEAR(survey.at(100.0).position.z(), -100.0, 1e-12);
  EXPECT_NE("", refusal({0.0, 0.0, 99.9}, {100.0, 0.0, 0.0}));
  EXPECT_EQ("", refusal({0.0, 0.0, 10.019}, {10.0, 0.0, 0.0})) << "2 cm";
}

TEST(TieIn, WhatCannotBeIsRefused)
{
  EXPECT_EQ("the first station is 101 m from the rotary table, allowed: up to its measured depth, 100 m",
            refusal({0.0, 0.0, 101.0}, {100.0, 0.0, 0.0}));
  EXPECT_EQ("the first station is 111.803 m from the rotary table, allowed: up to its measured depth, 100 m",
            refusal({50.0, 0.0, 100.0}, {100.0, 0.0, 0.0}));
  const std::string sharp =
      "no hole of 100 m connects the rotary table (vertical) with the first station at a dogleg severity of up to 15 deg/30 m";
  EXPECT_EQ(sharp, refusal({30.0, 0.0, 90.0}, {100.0, 0.0, 0.0})) << "27 deg away and back again in 100 m";
  EXPECT_EQ(sharp, refusal({0.0, 0.0, 100.0}, {100.0, 170.0 * degree, 0.0}));
  EXPECT_EQ(sharp, refusal({0.0, 0.0, 50.0}, {100.0, 0.0, 0.0})) << "50 m too long";
  EXPECT_EQ(sharp, refusal({50.0, 0.0, 86.602}, {100.0, 30.0 * degree, 0.0})) << "a slant hole from the surface begins at 0";
  EXPECT_EQ("tvd 0 m is not below the rotary table, allowed: above 0", refusal({0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}));
  EXPECT_EQ("the first md is 0.005 m, allowed: 0.01 m or more", refusal({0.0, 0.0, 0.005}, {0.005, 0.0, 0.0}));
  EXPECT_EQ("the first station is at 0, the rotary table; allowed: only with a first station below it",
            refusal({0.0, 0.0, 10.0}, {0.0, 0.0, 0.0}));
  const double nan = std::nan("");
  for (const TieIn& none : {TieIn{nan, 0.0, 100.0}, TieIn{0.0, nan, 100.0}, TieIn{0.0, 0.0, nan}})
    EXPECT_NE("", refusal(none, {100.0, 0.0, 0.0}));
}

struct ListedWell
{
  std::vector<SurveyStation> stations;
  std::vector<Vector3d> positions;
};

/// Wells of ../shared/data with their listed positions, the first station's offset taken off; none where that folder is absent.
std::map<std::string, ListedWell> listed_wells()
{
  std::map<std::string, ListedWell> wells;
  for (const std::string file : {"iscwsa/wells.csv", "ullrigg/u3.csv", "ullrigg/u4.csv", "ullrigg/u5.csv"})
  {
    std::ifstream in(in_source("../shared/data/" + file));
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line))
    {
      std::string name = file;
      std::istringstream row(line);
      if (file[0] == 'i') std::getline(row, name, ',');
      double v[6];
      char comma;
      for (double& x : v) row >> x >> comma;
      wells[name].stations.push_back({v[0], v[1] * degree, v[2] * degree});
      wells[name].positions.push_back({v[5], v[4], -v[3]});
    }
  }
  for (auto& well : wells)
    for (std::size_t i = well.second.positions.size(); i-- > 0;) well.second.positions[i] -= well.second.positions[0];
  return wells;
}

// Seven standard and three real wells, each cut off above each of its stations: the rest lies where it is listed (to the 5 cm of
// test/accuracy/cases/surveys.cpp), and there is always a hole that leads there.
TEST(TieIn, WellsCutOffAnywhere)
{
  const auto wells = listed_wells();
  if (wells.empty()) GTEST_SKIP() << "../shared/data is absent";
  EXPECT_EQ(10u, wells.size());
  for (const auto& [name, well] : wells)
  {
    for (std::size_t k = 1; k + 1 < well.stations.size(); ++k)
    {
      SCOPED_TRACE(name + " from station " + std::to_string(k));
      const std::vector<SurveyStation> rest(well.stations.begin() + static_cast<std::ptrdiff_t>(k), well.stations.end());
      const TieIn tie_in = tie_in_at(well.positions[k]);
      const Survey below(rest, tie_in), whole = tied_in(tie_in, rest);
      const double stretched = std::max(tie_in_share * rest.front().md, tie_in_rounding);
      double worst = 0.0, worst_whole = 0.0;
      for (std::size_t i = k; i < well.stations.size(); ++i)
      {
        worst = std::max(worst, (below.station(static_cast<int>(i - k)).position - well.positions[i]).norm());
        worst_whole = std::max(worst_whole, (whole.at(well.stations[i].md).position - well.positions[i]).norm());
      }
      EXPECT_LT(worst, 0.05);
      EXPECT_LT(worst_whole, stretched + 0.05);
    }
  }
}
}  // namespace

TEST(TieIn, ASurveyBelowTheTableWithoutItIsRefused)
{
  EXPECT_THROW(Survey({{10.0, 0.0, 0.0}, {20.0, 0.0, 0.0}}), std::invalid_argument);
  const Survey survey({{10.0, 0.0, 0.0}, {20.0, 0.0, 0.0}}, TieIn{3.0, 2.0, 9.0});
  EXPECT_EQ(Vector3d(2.0, 3.0, -9.0), survey.station(0).position);
  EXPECT_EQ(Vector3d(2.0, 3.0, -19.0), survey.station(1).position);
}
}  // namespace drill_rig_sim::test_well_tie_in
