// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "drill_rig_sim/well/hole_nodes.h"
#include "drill_rig_sim/well/survey.h"
#include "drill_rig_sim/well/well_checks.h"
#include "well_fixtures.h"

namespace drill_rig_sim::test_well_survey
{
namespace
{
using Eigen::Vector3d;

TEST(Directions, TangentAndBack)
{
  EXPECT_NEAR((tangent_from(0.0, 2.0) - Vector3d(0, 0, -1)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((tangent_from(90 * degree, 90 * degree) - Vector3d(1, 0, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((tangent_from(90 * degree, 0.0) - Vector3d(0, 1, 0)).norm(), 0.0, 1e-15);
  for (double inclination : {1e-6, 0.3, 1.5, 3.1})
    for (double azimuth : {0.0, 1.0, 3.0, 5.18, 6.28})
    {
      const Vector3d t = tangent_from(inclination, azimuth);
      EXPECT_NEAR(inclination_of(t), inclination, 1e-14);
      EXPECT_NEAR(azimuth_of(t), azimuth, 1e-9);
    }
  EXPECT_EQ(azimuth_of(-Vector3d::UnitZ()), 0.0);
  EXPECT_EQ(azimuth_of(tangent_from(0.0, 4.0)), 0.0);
  EXPECT_EQ(azimuth_of(Vector3d(-1e-300, 1.0, 0.0)), 0.0) << "below round-off of 2 pi";
}

TEST(Directions, AVerticalHoleHasNoAzimuthToRoundOff)
{
  EXPECT_EQ(0.0, azimuth_of({1e-14, -1e-14, -1.0}));
  EXPECT_EQ(0.0, azimuth_of({-1e-14, 1e-15, 1.0})) << "upwards";
  EXPECT_NEAR(0.5 * pi, azimuth_of({1e-6, 0.0, -1.0}), 1e-12);
  EXPECT_NEAR(pi, azimuth_of({0.0, -1e-6, -1.0}), 1e-12);
}

// An azimuth is that of a direction, whatever the vector's length: also of a position.
TEST(Directions, AzimuthNeedsNoUnitVector)
{
  EXPECT_NEAR(0.5 * pi, azimuth_of({1.0, 0.0, 0.0}), 1e-15) << "level: nothing along z";
  EXPECT_NEAR(0.5 * pi, azimuth_of({1e-15, 0.0, -1e-15}), 1e-15);
  EXPECT_NEAR(1.5 * pi, azimuth_of({-1e4, 0.0, -1e4}), 1e-15);
  EXPECT_EQ(0.0, azimuth_of({1e-10, 1e-10, -1e4})) << "vertical to round-off";
}

// Along the vertical the high side is north, along north the north side is up; a hair beside them they are what they are
// elsewhere.
TEST(Directions, EachSideHasAnOtherWhereItWouldPointAlongTheHole)
{
  EXPECT_EQ(Vector3d::UnitY(), high_side(-Vector3d::UnitZ()));
  EXPECT_EQ(Vector3d::UnitY(), high_side(Vector3d::UnitZ()));
  EXPECT_EQ(Vector3d::UnitZ(), north_side(Vector3d::UnitY()));
  EXPECT_LT((high_side(tangent_from(60 * degree, 0.0)) - Vector3d(0, 0.5, std::sqrt(0.75))).norm(), 1e-15);
  EXPECT_LT((north_side(tangent_from(60 * degree, 90 * degree)) - Vector3d::UnitY()).norm(), 1e-15);
  for (double lean : {1e-3, 1e-7, 1e-10})  // to the east: up is east of up
    EXPECT_LT((high_side(tangent_from(lean, 90 * degree)) - Vector3d(std::cos(lean), 0.0, std::sin(lean))).norm(), 1e-15 / lean)
        << lean;
  const Vector3d nearly_down(0.0, 1e-13, -1.0);
  EXPECT_NEAR(high_side(nearly_down).dot(nearly_down), 0.0, 1e-16) << "square to the hole to round-off";
}

// A hole inclined to the east: up is towards the east and up, right of it looking downhole (east) is south.
TEST(Directions, HighSideAndRightSide)
{
  const Vector3d t = tangent_from(60 * degree, 90 * degree);
  const Vector3d high = high_side(t);
  EXPECT_NEAR((high - Vector3d(std::cos(60 * degree), 0, std::sin(60 * degree))).norm(), 0.0, 1e-15);
  EXPECT_NEAR(angle_about(t, high, high), 0.0, 1e-15);
  EXPECT_NEAR(angle_about(t, high, -Vector3d::UnitY()), 90 * degree, 1e-15);
  EXPECT_NEAR(angle_about(t, high, Vector3d::UnitY()), -90 * degree, 1e-15);
  EXPECT_EQ(angle_about(t, high, Vector3d::Zero()), 0.0);
  EXPECT_NEAR(std::abs(angle_about(-Vector3d::UnitZ(), Vector3d::UnitY(), -Vector3d::UnitY())), pi, 1e-15);
  // a vector of nought has no angle, though minus nought times something would make one of 180 deg
  EXPECT_EQ(angle_about(Vector3d(1, -1, 0).normalized(), -Vector3d(1, 1, 1).normalized(), Vector3d::Zero()), 0.0);
}

// Looking straight down with north ahead, east is to the right: clockwise.
TEST(Directions, BelowFiveDegreesNorthIsTheReference)
{
  const Vector3d down = tangent_from(0.0, 1.0);
  const ToolfaceReference reference = toolface_reference(down);
  EXPECT_TRUE(reference.magnetic);
  EXPECT_NEAR((reference.direction - Vector3d::UnitY()).norm(), 0.0, 1e-15);
  EXPECT_NEAR(angle_about(down, reference.direction, Vector3d::UnitX()), 90 * degree, 1e-15);
  const Vector3d inclined = tangent_from(60 * degree, 90 * degree);
  EXPECT_EQ(toolface_reference(inclined).direction, high_side(inclined));
  EXPECT_EQ(toolface_reference(inclined, true).direction, high_side(inclined));
  EXPECT_TRUE(toolface_reference(tangent_from(4.9 * degree, 1.0)).magnetic);
  EXPECT_FALSE(toolface_reference(tangent_from(5.1 * degree, 1.0)).magnetic);
  EXPECT_TRUE(toolface_reference(tangent_from(5.9 * degree, 1.0), true).magnetic);
  EXPECT_FALSE(toolface_reference(tangent_from(6.1 * degree, 1.0), true).magnetic);
  EXPECT_FALSE(toolface_reference(tangent_from(4.1 * degree, 1.0), false).magnetic);
  EXPECT_TRUE(toolface_reference(tangent_from(3.9 * degree, 1.0), false).magnetic);
}

// From vertical to I in a vertical plane: radius D/I, north = R (1 - cos I), depth = R sin I.
TEST(Survey, BuildSectionIsACircularArc)
{
  for (double inclination : {1e-9, 1e-5, 1e-3, 0.1, 1.0, 2.0, 3.0, 3.139})
  {
    const Survey survey({{0.0, 0.0, 2.0}, {300.0, inclination, 0.0}});
    const double radius = 300.0 / inclination;
    for (double u : {0.1, 0.5, 0.77, 1.0})
    {
      const PathPoint p = survey.at(300.0 * u);
      const double angle = u * inclination;
      const double north = 2.0 * radius * std::pow(std::sin(0.5 * angle), 2);
      EXPECT_NEAR((p.position - Vector3d(0, north, -radius * std::sin(angle))).norm(), 0.0, 1e-10) << inclination << " " << u;
      EXPECT_NEAR((p.tangent - tangent_from(angle, 0.0)).norm(), 0.0, 1e-12) << inclination << " " << u;
    }
    EXPECT_NEAR(survey.dogleg(0), inclination, 1e-12);
    EXPECT_NEAR(survey.dogleg_severity(0), 0.1 * inclination, 1e-12);
  }
}

// In a horizontal plane, 90 deg to the right: by hand (R, R) with R = 2 D/pi.
TEST(Survey, HorizontalTurn)
{
  const Survey survey({{0.0, 90 * degree, 0.0}, {100.0, 90 * degree, 90 * degree}});
  const double radius = 200.0 / pi;
  EXPECT_NEAR((survey.station(1).position - Vector3d(radius, radius, 0)).norm(), 0.0, 1e-12);
}

// By hand, ratio factor: stations (0, 15 deg, N20E) and (100 ft ...) of the classic form r = D/2 (t1 + t2) 2/a tan(a/2).
TEST(Survey, AgreesWithTheRatioFactorForm)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 1000; ++i)
  {
    const SurveyStation a{0.0, 2.0 * uniform(random), 6.28 * uniform(random)};
    const SurveyStation b{30.0, 2.0 * uniform(random), 6.28 * uniform(random)};
    const Vector3d t1 = tangent_from(a.inclination, a.azimuth), t2 = tangent_from(b.inclination, b.azimuth);
    const double dogleg = std::acos(std::cos(b.inclination - a.inclination) -
                                    std::sin(a.inclination) * std::sin(b.inclination) * (1.0 - std::cos(b.azimuth - a.azimuth)));
    if (dogleg < 0.01 || dogleg > 3.0) continue;
    const Vector3d expected = 15.0 * 2.0 / dogleg * std::tan(0.5 * dogleg) * (t1 + t2);
    const Survey survey({a, b}, TieIn{0.0, 0.0, 100.0});  // some go up
    EXPECT_NEAR(survey.dogleg(0), dogleg, 1e-10);
    EXPECT_LT((survey.station(1).position - survey.station(0).position - expected).norm(), 1e-9);
  }
}

TEST(Survey, StraightHoleAndMeaninglessAzimuth)
{
  const Survey slant({{0.0, 0.5, 1.0}, {100.0, 0.5, 1.0}, {1000.0, 0.5, 1.0}});
  EXPECT_LT((slant.at(777.0).position - 777.0 * tangent_from(0.5, 1.0)).norm(), 1e-11);
  EXPECT_EQ(slant.dogleg_severity(1), 0.0);
  const Survey vertical({{0.0, 0.0, 0.0}, {50.0, 0.0, 4.0}, {100.0, 0.0, 2.0}, {130.0, 3 * degree, 5.0}});
  EXPECT_NEAR((vertical.station(2).position - Vector3d(0, 0, -100)).norm(), 0.0, 1e-13);
  EXPECT_NEAR(vertical.dogleg_severity(2), 3 * degree, 1e-14);
  EXPECT_NEAR(azimuth_of(vertical.station(3).position), 5.0, 1e-12);
}

// Position and tangent are continuous at the stations, the tangent is the position's derivative, |t| = 1.
TEST(Survey, InterpolationIsConsistent)
{
  const Survey survey(crooked_well().survey);
  for (const double md : depths(0.5, survey.last_md(), 3.7))
  {
    constexpr double h = 1e-3;
    const Vector3d slope = (survey.at(md + h).position - survey.at(md - h).position) / (2.0 * h);
    EXPECT_LT((slope - survey.at(md).tangent).norm(), 1e-5) << md;  // a curvature step of 0.02/m within h
    EXPECT_NEAR(survey.at(md).tangent.norm(), 1.0, 1e-14);
  }
  for (int i = 0; i < survey.size(); ++i)
    EXPECT_LT((survey.at(survey.station(i).md - 1e-9).position - survey.station(i).position).norm(), 2e-9);
}

// Above the first station and below the last the hole goes on straight.
TEST(Survey, GoesOnStraightBeyondItsEnds)
{
  const Survey survey({{0.0, 30 * degree, 0.0}, {100.0, 60 * degree, 0.0}, {130.0, 90 * degree, 0.0}});
  EXPECT_LT((survey.at(142.0).position - survey.station(2).position - Vector3d(0, 12, 0)).norm(), 1e-12);
  EXPECT_LT((survey.at(142.0).tangent - Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LT((survey.at(-10.0).position - Vector3d(0, -5, 10.0 * std::sqrt(0.75))).norm(), 1e-13);
  EXPECT_EQ(survey.at(142.0).md, 142.0);
}

// The arc that begins at a station is the station's; there is none after the last station's.
TEST(Survey, AnArcGoesFromItsStationToTheNext)
{
  const Survey survey({{0.0, 0.0, 0.0}, {100.0, 0.1, 0.0}, {130.0, 0.2, 0.0}, {150.0, 0.3, 0.0}});
  const std::vector<double> mds = {-5.0, 0.0, 99.9, 100.0, 129.9, 130.0, 150.0, 160.0};
  const std::vector<int> arcs = {0, 0, 0, 1, 1, 2, 2, 2};
  for (std::size_t i = 0; i < mds.size(); ++i) EXPECT_EQ(survey.arc_at(mds[i]), arcs[i]) << mds[i];
}

// 20 km on an arc just short enough for the series of sin(x)/x: without its terms it is off by 0.1 nm and more.
TEST(Survey, TheSeriesForWeakArcsIsExactToRoundOff)
{
  const double inclination = 0.0198, radius = 20e3 / inclination;
  const Survey survey({{0.0, 0.0, 0.0}, {20e3, inclination, 0.0}});
  EXPECT_NEAR(survey.station(1).position.z(), -radius * std::sin(inclination), 3e-11);
}

TEST(Survey, RefusesWhatIsNoSurvey)
{
  const double nan = std::nan("");
  EXPECT_THROW(Survey({{0.0, 0.0, 0.0}}), std::invalid_argument);
  EXPECT_THROW(Survey({{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}), std::invalid_argument);
  EXPECT_THROW(Survey({{0.0, 0.0, 0.0}, {10.0, nan, 0.0}}), std::invalid_argument);
  EXPECT_THROW(Survey({{0.0, 0.0, 0.0}, {10.0, 200 * degree, 0.0}}), std::invalid_argument);
  EXPECT_THROW(Survey({{0.0, 90 * degree, 0.0}, {10.0, 90 * degree, 180 * degree}}), std::invalid_argument);
  try
  {
    const Survey backwards({{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {5.0, 0.0, 0.0}});
    FAIL();
  }
  catch (const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find("station 3"), std::string::npos) << e.what();
  }
}

// The nodes' Hermite against the arcs themselves, every 0.37 m.
TEST(HoleNodes, HermiteFollowsTheArcWithinATenthOfAMillimetre)
{
  for (const WellSpec& spec : {bohai_well(), crooked_well()})
  {
    const Survey survey(spec.survey);
    const Wellbore hole(spec, {}, 0.1556);
    double worst = 0.0;
    for (const double md : depths(0.0, spec.hole_depth, 0.37))
      worst = std::max(worst, (hole.at(md).position - survey.at(md).position).norm());
    std::printf("Hermite against arc: %.4f mm with %d nodes\n", 1e3 * worst, hole.node_count());
    EXPECT_LT(worst, 1e-4);
  }
  WellSpec sharp;  // 170 deg in 40 m
  sharp.survey = {{0.0, 0.0, 0.0}, {40.0, 170 * degree, 1.0}};
  sharp.hole_depth = 40.0;
  sharp.sections = {{40.0, 0.2, 0.2}};
  const Survey survey(sharp.survey);
  const Wellbore hole(sharp, {}, 0.1);
  for (const double md : depths(0.0, 40.0, 0.013)) ASSERT_LT((hole.at(md).position - survey.at(md).position).norm(), 1e-4);
}

TEST(HoleNodes, SectionsChangeWithinAMillimetreAndTheHoleEndsAtItsDepth)
{
  WellSpec spec = bohai_well();
  spec.hole_depth = 729.25;
  const Wellbore hole(spec, {}, 0.1);
  EXPECT_EQ(hole.hole_depth(), 729.25);
  EXPECT_NEAR(hole.at(199.9999).radius, 0.1602, 1e-12);
  EXPECT_NEAR(hole.at(200.0).friction, 0.20, 1e-12);
  EXPECT_NEAR(hole.at(200.0005).radius, 0.5 * (0.1602 + 0.1556), 1e-9);
  EXPECT_NEAR(hole.at(200.0010001).radius, 0.1556, 1e-12);
  EXPECT_NEAR(hole.at(200.0010001).friction, 0.28, 1e-12);
  EXPECT_EQ(hole.at(199.9999).section, 0.0);
  EXPECT_NEAR(hole.at(200.00025).section, 0.25, 1e-9);
  EXPECT_NEAR(hole.at(200.0010001).section, 1.0, 1e-12);
  EXPECT_NEAR(hole.at(729.248).radius, 0.1556, 1e-12);  // the bit's radius differs: the hole's end is the bit's
  EXPECT_NEAR(hole.at(729.25).radius, 0.1, 1e-12);
  EXPECT_EQ(hole.bottom_radius(), 0.1);
  EXPECT_NEAR((hole.at(-12.0).position - Vector3d(0, 0, 12)).norm(), 0.0, 1e-15);
  EXPECT_EQ(hole.at(-12.0).radius, 0.1602);
}

TEST(HoleNodes, EachRuleForAHoleSaysWhereAndWhat)
{
  const auto problem_with = [](void (*change)(WellSpec&))
  {
    WellSpec spec = bohai_well();  // 730 m, sections to 200 and 730 m
    change(spec);
    const ProblemList problems = well_problems(spec);
    return problems.size() == 1 ? problems[0].key + ": " + problems[0].text : std::to_string(problems.size()) + " problems";
  };
  EXPECT_EQ("0 problems", problem_with([](WellSpec&) {}));
  EXPECT_EQ(
      "well.hole_depth: 731 m is deeper than the survey, allowed: up to its last station, 730 m; well.project: straight or "
      "curvature extends it by up to 30.5 m",
      problem_with([](WellSpec& w) { w.hole_depth = 731.0; }));
  EXPECT_EQ(
      "well.hole_depth: 730 m is deeper than the survey (by 0.0002 m), allowed: up to its last station, 730 m; well.project: "
      "straight or curvature extends it by up to 30.5 m",
      problem_with([](WellSpec& w) { w.hole_depth = 730.0002; }));
  EXPECT_EQ("well.hole_depth: must be above 0 (got 0 m)", problem_with([](WellSpec& w) { w.hole_depth = 0.0; }));
  EXPECT_EQ("well.sections: the list is empty, needed: at least one section",
            problem_with([](WellSpec& w) { w.sections.clear(); }));
  EXPECT_EQ("well.sections[1].diameter: must be above 0 (got 0 m)",
            problem_with([](WellSpec& w) { w.sections[1].diameter = 0.0; }));
  EXPECT_EQ("well.sections[0].friction: must be 0 or more (got -0.1)",
            problem_with([](WellSpec& w) { w.sections[0].friction = -0.1; }));
  EXPECT_EQ("well.sections[0].static_ratio: must be 1 or more (got 0.9)",
            problem_with([](WellSpec& w) { w.sections[0].static_ratio = 0.9; }));
  EXPECT_EQ("well.sections[1].stribeck_speed: must be above 0 (got 0 m/s)",
            problem_with([](WellSpec& w) { w.sections[1].stribeck_speed = 0.0; }));
  EXPECT_EQ("well.sections[1].to: the last section ends at 700 m, needed: down to hole_depth, 730 m",
            problem_with([](WellSpec& w) { w.sections[1].to = 700.0; }));
  EXPECT_EQ("well.sections[0].to: 0 m is not below the begin of the section, 0 m",
            problem_with([](WellSpec& w) { w.sections[0].to = 0.0; }));
}

TEST(HoleNodes, RefusesSectionsThatDoNotFit)
{
  const auto refused = [](const WellSpec& spec) { EXPECT_THROW(Wellbore(spec, {}, 0.15), std::invalid_argument); };
  WellSpec spec = bohai_well();
  spec.hole_depth = 731.0;
  refused(spec);
  spec = bohai_well();
  spec.sections = {};
  refused(spec);
  spec = bohai_well();
  spec.sections[1].to = 700.0;
  refused(spec);
  spec = bohai_well();
  spec.sections[1].to = 100.0;
  refused(spec);
  spec = bohai_well();
  spec.survey[0].md = 1.0;
  refused(spec);
  EXPECT_THROW(Wellbore(bohai_well(), {}, 0.0), std::invalid_argument);
  EXPECT_THROW(Wellbore(bohai_well(), {0.0, 0}, 0.15), std::invalid_argument);
}
}  // namespace
}  // namespace drill_rig_sim::test_well_survey
