// SPDX-License-Identifier: BSD-3-Clause
// From the last station to the bottom: the same direction, or the last interval's circle, against closed forms.
#include "drill_rig_sim/well/projection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/survey.h"
#include "drill_rig_sim/well/well_checks.h"

namespace drill_rig_sim::test_well_projection
{
namespace
{
WellSpec well_of(std::vector<SurveyStation> survey, double hole_depth, Projection project)
{
  WellSpec well;
  well.survey = std::move(survey);
  well.hole_depth = hole_depth;
  well.project = project;
  return well;
}

SurveyStation in_degrees(double md, double inclination, double azimuth)
{
  return {md, inclination * degree, azimuth * degree};
}

TEST(WellProjection, StraightGoesOnInTheLastDirection)
{
  WellSpec well = well_of({{0, 0, 0}, in_degrees(300, 30, 60)}, 320.0, Projection::straight);
  const std::string done = project_survey(well);
  EXPECT_NE(std::string::npos, done.find("projected 20 m (65.62 ft) from its last station, 300 m (984.25 ft)")) << done;
  ASSERT_EQ(3u, well.survey.size());
  const Survey survey(well.survey);
  const Eigen::Vector3d step = survey.station(2).position - survey.station(1).position;
  EXPECT_LT(
      (step - 20.0 * Eigen::Vector3d(0.5 * std::sin(60 * degree), 0.5 * std::cos(60 * degree), -std::cos(30 * degree))).norm(),
      1e-9);
}

TEST(WellProjection, CurvatureGoesOnWithBuildAndTurn)
{
  WellSpec build = well_of({{0, 0, 0}, in_degrees(300, 10, 60), in_degrees(330, 13, 60)}, 340.0, Projection::curvature);
  const std::string done = project_survey(build);
  EXPECT_NE(std::string::npos, done.find("arc of 3 deg/30 m: 14 deg inclination, 60 deg azimuth")) << done;
  EXPECT_NEAR(14.0 * degree, build.survey.back().inclination, 1e-9);
  EXPECT_NEAR(60.0 * degree, build.survey.back().azimuth, 1e-9);
  WellSpec turn = well_of({{0, 0, 0}, in_degrees(300, 90, 0), in_degrees(330, 90, 3)}, 350.0, Projection::curvature);
  project_survey(turn);
  EXPECT_NEAR(90.0 * degree, turn.survey.back().inclination, 1e-9);
  EXPECT_NEAR(5.0 * degree, turn.survey.back().azimuth, 1e-9);
}

// A hole that comes from the north passes the vertical and goes on to the south.
TEST(WellProjection, CurvaturePassesTheVertical)
{
  WellSpec well = well_of({{0, 0, 0}, in_degrees(300, 2, 0), in_degrees(330, 0, 123)}, 360.0, Projection::curvature);
  project_survey(well);
  EXPECT_NEAR(2.0 * degree, well.survey.back().inclination, 1e-9);
  EXPECT_NEAR(180.0 * degree, std::abs(well.survey.back().azimuth), 1e-9);
}

// Three stations of one circle, in any plane: the middle one's chords are those of R = L/b.
TEST(WellProjection, CurvatureStaysOnTheCircle)
{
  WellSpec well = well_of({{0, 0, 0}, in_degrees(300, 40, 60), in_degrees(325, 42, 70)}, 350.0, Projection::curvature);
  project_survey(well);
  const Survey survey(well.survey);
  const Eigen::Vector3d a = survey.station(1).position, b = survey.station(2).position, c = survey.station(3).position;
  const auto tangent = [&](std::size_t i) { return tangent_from(well.survey[i].inclination, well.survey[i].azimuth); };
  const double dogleg = std::acos(tangent(1).dot(tangent(2))), radius = 25.0 / dogleg;
  EXPECT_NEAR(2.0 * radius * std::sin(0.5 * dogleg), (c - b).norm(), 1e-9);
  EXPECT_NEAR(2.0 * radius * std::sin(dogleg), (c - a).norm(), 1e-9);
  EXPECT_NEAR(0.0, tangent(1).cross(tangent(2)).dot(tangent(3)), 1e-12) << "in one plane";
}

TEST(WellProjection, OnlyWhereItIsAskedForAndUpToAStand)
{
  const std::vector<SurveyStation> stations = {{0, 0, 0}, in_degrees(300, 10, 60)};
  for (const auto& [depth, project] : {std::pair<double, Projection>{310.0, Projection::none},
                                       {331.0, Projection::straight},
                                       {300.0, Projection::straight},
                                       {290.0, Projection::curvature}})
  {
    WellSpec well = well_of(stations, depth, project);
    EXPECT_EQ("", project_survey(well));
    EXPECT_EQ(2u, well.survey.size());
  }
  WellSpec none = well_of(stations, 310.0, Projection::none), far = well_of(stations, 331.0, Projection::straight);
  for (WellSpec* well : {&none, &far}) well->sections = {{400.0, 0.2159, 0.2}};
  EXPECT_NE(std::string::npos, well_problems(none).front().text.find("well.project: straight or curvature"));
  EXPECT_NE(std::string::npos, well_problems(far).front().text.find("with well.project 30.5 m further"));
}

// A millimetre beyond the last station needs no station of its own.
TEST(WellProjection, RoundingOfTheDepth)
{
  WellSpec well = well_of({{0, 0, 0}, in_degrees(300, 10, 60)}, 300.001, Projection::straight);
  EXPECT_NE("", project_survey(well));
  ASSERT_EQ(2u, well.survey.size());
  EXPECT_EQ(300.001, well.survey.back().md);
  EXPECT_TRUE(survey_problems(well.survey).empty());
}
}  // namespace
}  // namespace drill_rig_sim::test_well_projection
