// SPDX-License-Identifier: BSD-3-Clause
// What the node makes of a request for another well, of a scene's name and of a rate: each rule at its bounds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/ros/parameters.h"
#include "drill_rig_sim/ros/survey_request.h"
#include "drill_rig_sim/sim/requests.h"
#include "in_source.h"
#include "test_scenes.h"

namespace drill_rig_sim::test_ros_requests
{
namespace
{
/// 100 m of vertical hole, the bit 0.5 m off bottom.
Scene present()
{
  return vertical_scene(100.0, 99.5);
}

LoadSurvey::Request stations(const std::vector<SurveyStation>& list)
{
  LoadSurvey::Request request;
  for (const SurveyStation& s : list)
  {
    request.md.push_back(s.md);
    request.inclination.push_back(s.inclination);
    request.azimuth.push_back(s.azimuth);
  }
  return request;
}

const std::vector<SurveyStation> to_200 = {{0.0, 0.0, 0.0}, {80.0, 0.05, 1.0}, {200.0, 0.2, 1.5}};

std::string refusal(const std::function<void()>& action)
{
  try
  {
    action();
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

std::string refusal_of(const LoadSurvey::Request& request)
{
  return refusal([&] { with_well(present(), 0.5, to_new_well(request)); });
}
}  // namespace

TEST(WithSurvey, stationsMakeTheWellAndTheBitStaysAsFarOffBottom)
{
  const Scene next = with_well(present(), 0.5, to_new_well(stations(to_200)));
  ASSERT_EQ(3u, next.well.survey.size());
  EXPECT_EQ(80.0, next.well.survey[1].md);
  EXPECT_EQ(0.05, next.well.survey[1].inclination);
  EXPECT_EQ(1.5, next.well.survey[2].azimuth);
  EXPECT_EQ(200.0, next.well.hole_depth);
  EXPECT_EQ(199.5, next.start.bit_depth);
  EXPECT_EQ(20.0, next.start.block_height) << "the rest stays";
  EXPECT_EQ(197.0, with_well(present(), 3.0, to_new_well(stations(to_200))).start.bit_depth)
      << "the bit may stand elsewhere just now";
}

TEST(WithSurvey, depthsMayBeGiven)
{
  LoadSurvey::Request request = stations(to_200);
  request.hole_depth = 150.0;
  EXPECT_EQ(150.0, with_well(present(), 0.5, to_new_well(request)).well.hole_depth);
  EXPECT_EQ(149.5, with_well(present(), 0.5, to_new_well(request)).start.bit_depth);
  request.bit_depth = 120.0;
  EXPECT_EQ(120.0, with_well(present(), 0.5, to_new_well(request)).start.bit_depth);
  request.bit_depth = 150.0;
  EXPECT_EQ(150.0, with_well(present(), 0.5, to_new_well(request)).start.bit_depth) << "on bottom";
  request.hole_depth = 200.0;
  EXPECT_EQ(200.0, with_well(present(), 0.5, to_new_well(request)).well.hole_depth);
}

TEST(WithSurvey, depthsOutsideAreRefused)
{
  LoadSurvey::Request request = stations(to_200);
  request.hole_depth = 200.5;
  EXPECT_EQ("hole_depth is 200.5; allowed is 0 (the last station) to 200 m", refusal_of(request));
  request.hole_depth = -1.0;
  EXPECT_EQ("hole_depth is -1; allowed is 0 (the last station) to 200 m", refusal_of(request));
  request.hole_depth = 150.0;
  request.bit_depth = 150.5;
  EXPECT_EQ("bit_depth is 150.5; allowed is 0 (0.5 m off bottom) to 150 m", refusal_of(request));
  request.bit_depth = std::nan("");
  EXPECT_NE("", refusal_of(request));
}

TEST(WithSurvey, sectionsReachTheNewBottom)
{
  Scene scene = present();
  scene.well.sections = {{40.0, 0.3, 0.1}, {70.0, 0.25, 0.2}, {100.0, 0.2159, 0.3}};
  const std::vector<HoleSection> longer = with_well(scene, 0.5, to_new_well(stations(to_200))).well.sections;
  ASSERT_EQ(3u, longer.size());
  EXPECT_EQ(200.0, longer[2].to) << "the last one reaches it";
  EXPECT_EQ(70.0, longer[1].to);
  LoadSurvey::Request request = stations(to_200);
  request.hole_depth = 70.0;
  const std::vector<HoleSection> shorter = with_well(scene, 0.5, to_new_well(request)).well.sections;
  ASSERT_EQ(2u, shorter.size()) << "what begins at the bottom or below goes";
  EXPECT_EQ(70.0, shorter[1].to);
  EXPECT_EQ(0.25, shorter[1].diameter);
  request.hole_depth = 60.0;
  EXPECT_EQ(70.0, with_well(scene, 0.5, to_new_well(request)).well.sections.back().to) << "as deep as it was";
  request.hole_depth = 20.0;
  EXPECT_EQ(1u, with_well(scene, 0.5, to_new_well(request)).well.sections.size());
}

TEST(WithSurvey, eitherAFileOrStations)
{
  EXPECT_EQ("needed: either file, or md, inclination and azimuth", refusal_of({}));
  LoadSurvey::Request both = stations(to_200);
  both.file = in_source("config/surveys/bohai.csv");
  EXPECT_EQ("needed: either file, or md, inclination and azimuth", refusal_of(both));
  LoadSurvey::Request file;
  file.file = both.file;
  const Scene next = with_well(present(), 0.5, to_new_well(file));
  EXPECT_EQ(730.0, next.well.hole_depth);
  EXPECT_EQ(729.5, next.start.bit_depth);
  file.file = "/no/such.csv";
  EXPECT_NE(std::string::npos, refusal_of(file).find("/no/such.csv"));
}

TEST(WithSurvey, aFirstStationBelowTheTableIsTiedIn)
{
  LoadSurvey::Request request = stations({{80.0, 0.0, 0.0}, {200.0, 0.0, 0.0}});
  EXPECT_EQ(
      "station 0: the first md is 80 m, needed: 0 (the rotary table), or its position: tie_in, in a CSV file north_m, east_m, "
      "tvd_m",
      refusal_of(request));
  request.tie_in_tvd = 80.0;
  const Scene next = with_well(present(), 0.5, to_new_well(request));
  EXPECT_EQ(0.0, next.well.survey.front().md);
  EXPECT_EQ(80.0, next.well.survey[next.well.survey.size() - 2].md);
  EXPECT_EQ(200.0, next.well.hole_depth);
  request.tie_in_north = 30.0;
  EXPECT_EQ("tie_in: the first station is 85.44 m from the rotary table, allowed: up to its measured depth, 80 m",
            refusal_of(request));
  request = stations(to_200);
  request.tie_in_tvd = 1.0;
  EXPECT_EQ("tie_in: the first station is at 0, the rotary table; allowed: only with a first station below it",
            refusal_of(request));
}

TEST(WithSurvey, aFileMayHoldItsTieIn)
{
  LoadSurvey::Request request;
  request.file = in_source("test/bad_scenes/surveys/tie_in_far.csv");
  EXPECT_NE(std::string::npos, refusal_of(request).find("tie_in_far.csv:2: station 1: lies 64727"));
  request.tie_in_tvd = 10.0;
  EXPECT_EQ(200.0, with_well(present(), 0.5, to_new_well(request)).well.hole_depth) << "what is asked goes before";
  request.file = in_source("test/bad_scenes/surveys/deep.csv");
  EXPECT_EQ(200.0, with_well(present(), 0.5, to_new_well(request)).well.hole_depth);
}

TEST(WithSurvey, listsHaveOneLength)
{
  LoadSurvey::Request request = stations(to_200);
  request.inclination.pop_back();
  EXPECT_EQ("md, inclination and azimuth have 3, 2 and 3 entries; needed: the same number of each", refusal_of(request));
  request = stations(to_200);
  request.azimuth.push_back(0.0);
  EXPECT_EQ("md, inclination and azimuth have 3, 3 and 4 entries; needed: the same number of each", refusal_of(request));
}

TEST(WithSurvey, theFirstBadStationIsNamed)
{
  EXPECT_EQ(0u, refusal_of(stations({{0.0, 0.0, 0.0}, {80.0, 4.0, 0.0}, {200.0, 5.0, 0.0}})).find("station 1: "));
  EXPECT_EQ(0u, refusal_of(stations({{0.0, 0.0, 0.0}, {80.0, 0.0, 0.0}, {79.0, 0.0, 0.0}})).find("station 2: "));
}

TEST(WithSurvey, whatDoesNotGoTogetherIsRefusedWithItsKey)
{
  Scene scene = present();
  scene.string.back().joints = 3;  // 28.8 m: too short for the new well
  EXPECT_EQ(0u, refusal([&] { with_well(scene, 0.5, to_new_well(stations(to_200))); }).find("string"));
}

TEST(CheckRate, aFrameIsAWholeNumberOfSteps)
{
  Scene scene = present();
  scene.numerics.step = 0.005;
  for (const double rate : {200.0, 100.0, 66.0 + 2.0 / 3.0, 50.0, 0.1}) EXPECT_NO_THROW(check_rate(rate, scene)) << rate;
  for (const double rate : {130.0, 199.0, 201.0, 400.0, 1000.0})
    EXPECT_THROW(check_rate(rate, scene), std::runtime_error) << rate;
  EXPECT_EQ("rate is 400; allowed is a rate whose frames hold a whole number of the scene's steps of 0.005 s",
            refusal([&] { check_rate(400.0, scene); }));
}

TEST(FindScene, anAbsoluteNameIsTheFile)
{
  EXPECT_EQ(in_source("config/scenes/quick.yaml"), find_scene(in_source("config/scenes/quick.yaml")));
  for (const std::string& none : {std::string("/no/such.yaml"), in_source(), std::string("/dev/zero")})
    EXPECT_EQ(0u, refusal([&] { find_scene(none); }).find("scene is " + none + "; allowed is a regular file")) << none;
  EXPECT_NE("", refusal([] { find_scene(""); }));
  EXPECT_NE("", refusal([] { find_scene("package://no_such_package/a.yaml"); }));
  EXPECT_NE("", refusal([] { find_scene("package://drill_rig_sim"); }));
  EXPECT_EQ(
      0u,
      refusal([] { find_file("file", "no_such.csv", "config/surveys"); }).find("file is no_such.csv; allowed is a regular file"));
}

TEST(Parameters, whoseTimeItIs)
{
  Parameters p;
  EXPECT_EQ(TimeSource::own, p.time_source());
  p.use_sim_time = true;
  EXPECT_EQ(TimeSource::own, p.time_source());
  p.publish_clock = false;
  EXPECT_EQ(TimeSource::other_rig, p.time_source());
  p.use_sim_time = false;
  EXPECT_EQ(TimeSource::wall, p.time_source());
}

TEST(Parameters, aFramesPeriodIsTheRates)
{
  Parameters p;
  EXPECT_EQ(10'000'000, p.frame_period());
  p.rate = 30.0;
  EXPECT_EQ(33'333'333, p.frame_period());
  p.rate = 0.1;
  EXPECT_EQ(10'000'000'000, p.frame_period());
}

}  // namespace drill_rig_sim::test_ros_requests
