// SPDX-License-Identifier: BSD-3-Clause
// The rules for a survey and for a hole's sections: what each says, and where its limit is.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/survey.h"
#include "drill_rig_sim/well/well_checks.h"
#include "well_fixtures.h"

namespace drill_rig_sim::test_well_checks
{
namespace
{
// "station: text" of each problem.
std::vector<std::string> said_of(const std::vector<SurveyStation>& stations)
{
  std::vector<std::string> all;
  for (const SurveyProblem& problem : survey_problems(stations))
    all.push_back(std::to_string(problem.station) + ": " + problem.text);
  return all;
}

// The first of a vertical survey's stations as it is, the second `s`.
std::vector<std::string> said_of_second(const SurveyStation& s)
{
  return said_of({{0.0, 0.0, 0.0}, s});
}

using Texts = std::vector<std::string>;

// A problem of many stations is one line with their count; others keep a line of their own.
TEST(SurveyChecks, ARepeatedProblemIsOneLine)
{
  EXPECT_EQ(Texts({"1: azimuth 361 deg is out of range, allowed: -360 to 360 deg (and 1 further station)",
                   "3: inclination 181 deg is out of range, allowed: 0 to 180 deg"}),
            said_of({{0.0, 0.0, 0.0}, {10.0, 0.0, 361.0 * degree}, {20.0, 0.0, 362.0 * degree}, {30.0, 181.0 * degree, 0.0}}));
}

TEST(SurveyChecks, EachRuleSaysWhereAndWhat)
{
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const Texts not_finite = {"1: a value is not a finite number"};
  EXPECT_EQ(Texts({"0: 1 station, needed: at least two"}), said_of({{0.0, 0.0, 0.0}}));
  EXPECT_EQ(Texts({"0: 0 station, needed: at least two"}), said_of({}));
  EXPECT_EQ(not_finite, said_of_second({nan, 0.0, 0.0}));
  EXPECT_EQ(not_finite, said_of_second({10.0, infinity, 0.0}));
  EXPECT_EQ(not_finite, said_of_second({10.0, 0.0, -infinity}));
  EXPECT_EQ(Texts({"1: md -1 m is out of range, allowed: 0 to 20000 m"}), said_of_second({-1.0, 0.0, 0.0}));
  EXPECT_EQ(Texts({"1: md 20001 m is out of range, allowed: 0 to 20000 m"}), said_of_second({20001.0, 0.0, 0.0}));
  EXPECT_EQ(Texts({"1: inclination -1 deg is out of range, allowed: 0 to 180 deg"}), said_of_second({10.0, -1.0 * degree, 0.0}));
  EXPECT_EQ(Texts({"1: inclination 181 deg is out of range, allowed: 0 to 180 deg"}),
            said_of_second({10.0, 181.0 * degree, 0.0}));
  EXPECT_EQ(Texts({"1: azimuth 361 deg is out of range, allowed: -360 to 360 deg"}), said_of_second({10.0, 0.0, 361.0 * degree}));
  EXPECT_EQ(Texts({"1: azimuth -361 deg is out of range, allowed: -360 to 360 deg"}),
            said_of_second({10.0, 0.0, -361.0 * degree}));
  EXPECT_EQ(Texts({"1: md 0 m is not deeper than the station before it, 0 m"}), said_of_second({0.0, 0.0, 0.0}));
  EXPECT_EQ(Texts({"1: md 0.005 m is too close to the station before it, 0 m, allowed: 0.01 m or more between stations"}),
            said_of_second({0.005, 0.0, 0.0}));
  EXPECT_EQ(Texts({"1: the direction is opposite to that of the station before it, allowed: a turn of up to 179.9 deg"}),
            said_of_second({10.0, 180.0 * degree, 0.0}));
  EXPECT_EQ(Texts({"0: the first md is 1 m, needed: 0 (the rotary table), or its position: tie_in, in a CSV file north_m, "
                   "east_m, tvd_m"}),
            said_of({{1.0, 0.0, 0.0}, {10.0, 0.0, 0.0}}));
}

// Built up past the horizontal until it comes out of the ground; at 90 deg from the table it only leaves it.
TEST(SurveyChecks, AHoleLiesBelowTheTable)
{
  const std::vector<SurveyStation> rising = {
      {0.0, 0.0, 0.0}, {1000.0, 95.0 * degree, 0.7}, {2000.0, 120.0 * degree, 0.7}, {3000.0, 175.0 * degree, 0.7}};
  const Texts said = said_of(rising);
  ASSERT_EQ(1u, said.size());
  const Survey to_the_top({rising.begin(), rising.begin() + 3});
  const double height = to_the_top.station(2).position.z() +
                        chord_of_arc(to_the_top.station(2).tangent, tangent_from(175.0 * degree, 0.7), 1000.0).z();
  EXPECT_EQ("3: lies " + metres(0.01 * std::round(100.0 * height)) +
                " above the rotary table, allowed: below it; is an inclination or a depth wrong?",
            said[0]);
  EXPECT_EQ(Texts(), said_of({rising.begin(), rising.begin() + 3}));
  EXPECT_EQ(Texts(), said_of({{0.0, 90.0 * degree, 0.0}, {10.0, 90.0 * degree, 0.0}}));
}

// At its limit each value is good; a file's degrees may have been rounded on the way.
TEST(SurveyChecks, LimitsAreAllowed)
{
  EXPECT_EQ(Texts(), said_of_second({20000.0, 179.8 * degree, 2.0 * pi}));
  EXPECT_EQ(Texts(), said_of_second({10.0, 0.0, -2.0 * pi}));
  EXPECT_EQ(Texts(), said_of_second({10.0, 0.0, 2.0 * pi + 5e-10}));
  EXPECT_EQ(Texts(), said_of_second({0.01 * (1.0 - 5e-7), 0.0, 0.0}));
  EXPECT_EQ(Texts(), said_of({{0.0, 0.0, 0.0}, {10.0, 90.0 * degree, 0.0}, {20.0, pi, 0.0}}));
  EXPECT_EQ(1u, said_of_second({10.0, 179.95 * degree, 0.0}).size());
}

// A station is compared with the one before it only if that is sound; each bad one is named.
TEST(SurveyChecks, EachBadStationIsNamedOnce)
{
  const Texts expected = {"1: a value is not a finite number", "3: md 4 m is not deeper than the station before it, 5 m"};
  EXPECT_EQ(expected, said_of({{0.0, 0.0, 0.0}, {std::nan(""), 0.0, 0.0}, {5.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {6.0, 0.0, 0.0}}));
}

// A survey that is too long is not looked through.
TEST(SurveyChecks, MoreStationsThanAllowedAreOneProblem)
{
  std::vector<SurveyStation> stations;
  for (std::size_t i = 0; i < most_stations; ++i) stations.push_back({0.01 * static_cast<double>(i), 0.0, 0.0});
  EXPECT_EQ(Texts(), said_of(stations));
  stations.push_back({1.0, 0.0, 0.0});
  EXPECT_EQ(Texts({"50000: more than 50000 stations, allowed: at most that many"}), said_of(stations));
}

TEST(SectionChecks, ASectionHasRoomForItsChangeOfDiameter)
{
  WellSpec well = straight_well(100.0);
  well.sections = {{50.0, 0.3, 0.0}, {50.005, 0.3, 0.2}, {100.0, 0.3, 0.2}};
  const ProblemList problems = well_problems(well);
  ASSERT_EQ(1u, problems.size());
  EXPECT_EQ("well.sections[1].to", problems[0].key);
  EXPECT_EQ("the section is 0.005 m long, allowed: 0.01 m or more", problems[0].text);
  well.sections[1].to = 50.0 + 0.01 * (1.0 - 5e-7);
  EXPECT_TRUE(well_problems(well).empty());
}

// The last section needs to reach the hole's end, not the survey's.
TEST(SectionChecks, SectionsMayEndWithTheHole)
{
  WellSpec well = straight_well(100.0);
  well.hole_depth = 60.0;
  well.sections = {{60.0, 0.3, 0.2}};
  EXPECT_TRUE(well_problems(well).empty());
  well.hole_depth = 100.0;
  well.sections = {{100.0, 0.3, 0.2}};
  EXPECT_TRUE(well_problems(well).empty());
}

TEST(TrajectoryChecks, EitherALengthOrANumberOfSteps)
{
  EXPECT_TRUE(trajectory_problems({1e-3, 0}).empty());
  EXPECT_TRUE(trajectory_problems({0.0, 1}).empty());
  for (const TrajectorySpec& bad : {TrajectorySpec{0.9e-3, 0}, TrajectorySpec{0.1, -1}, TrajectorySpec{std::nan(""), 0}})
  {
    const ProblemList problems = trajectory_problems(bad);
    ASSERT_EQ(1u, problems.size());
    EXPECT_EQ("trajectory", problems[0].key);
    EXPECT_EQ("stage_two_length must be 1 mm or more, or stage_two_steps positive", problems[0].text);
  }
}
}  // namespace
}  // namespace drill_rig_sim::test_well_checks
