// SPDX-License-Identifier: BSD-3-Clause
// Steps between the depths of surveys: wrong digits at the ends, and lengths of pipe in feet.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "survey_reading.h"

namespace drill_rig_sim::test_scene_station_steps
{
using namespace survey_reading;

namespace
{
const std::string head = "MD (m),Inc (deg),Azi (deg)\n";

std::string station(double md, double inclination)
{
  return std::to_string(md) + "," + std::to_string(inclination) + ",40\n";
}

// Every 30 m from one depth to another, building 1 deg each.
std::string stations(double from, double to)
{
  std::string text;
  for (int i = 0; from + 30.0 * i <= to; ++i) text += station(from + 30.0 * i, 1.0 + 1.0 * i);
  return text;
}

std::string remarks_of(const std::string& text)
{
  std::string all;
  for (const std::string& remark : read(text).remarks) all += remark.substr(remark.find("survey.txt") + 12) + "\n";
  return all;
}
}  // namespace

TEST(StationSteps, AWrongDigitAtTheEndIsReported)
{
  const std::string above = head + "0,0,0\n" + stations(2400.0, 3150.0);
  EXPECT_EQ(
      "the last station, at 3810 m, stands 660 m from the next one, the others usually 30 m; is a digit of its depth wrong "
      "(3180 m)?\n",
      remarks_of(above + station(3810.0, 27.0)));
  EXPECT_TRUE(holds(remarks_of(above + station(3810.0, 26.0)), "(3180 m)")) << "in a straight hole";
  EXPECT_TRUE(holds(remarks_of(above + station(3480.0, 27.0)), "(3180 m)")) << "one digit";
  EXPECT_TRUE(holds(remarks_of(head + "0,0,0\n" + stations(300.0, 630.0) + station(6660.0, 13.0)), "(660 m)"))
      << "one digit more";
  EXPECT_TRUE(holds(remarks_of("MD (ft),Inc (deg),Azi (deg)\n0,0,0\n" + stations(4900.0, 5200.0) + station(52300.0, 12.0)),
                    "the last station, at 52300 ft, stands 47100 ft from the next one, the others usually 30 ft"));
}

TEST(StationSteps, ALastStationFarAwayIsReported)
{
  const std::string above = head + "0,0,0\n" + stations(2400.0, 3150.0);
  EXPECT_EQ("the last station, at 3790.5 m, stands 640.5 m from the next one, the others usually 30 m; is its depth right?\n",
            remarks_of(above + station(3790.5, 40.0)));
  EXPECT_EQ("", remarks_of(above + station(3700.5, 40.0))) << "20 steps";
}

TEST(StationSteps, AWrongDigitAtTheBeginIsReported)
{
  const std::string below = stations(2130.0, 2600.0);
  EXPECT_TRUE(
      holds(remarks_of(head + "0,0,0\n" + station(1200.0, 0.5) + below),
            "the first station, at 1200 m, stands 930 m from the next one, the others usually 30 m; is a digit of its depth "
            "wrong (2100 m)?"));
  EXPECT_TRUE(holds(remarks_of(head + "0,0,0\n" + station(210.0, 0.5) + below), "(2100 m)")) << "one digit less";
}

// From the table to the first station, from a gyro's to those of another tool, to a last one that was projected.
TEST(StationSteps, OrdinaryGapsAreNotReported)
{
  const std::string inside = stations(2400.0, 3150.0);
  EXPECT_EQ("", remarks_of(head + "0,0,0\n" + inside));
  EXPECT_EQ("", remarks_of(head + "0,0,0\n500,0.5,40\n" + inside));
  EXPECT_EQ("", remarks_of(head + "0,0,0\n" + inside + station(3167.5, 26.5)));
  EXPECT_EQ("", remarks_of(head + "0,0,0\n" + inside + station(3480.0, 26.0))) << "a hold section";
  EXPECT_EQ("", remarks_of(head + "0,0,0\n400,0,0\n900,30,40\n2100,30,40\n2500,50,80\n3900,50,80\n")) << "a plan by its corners";
}

TEST(StationSteps, AScenesStationsAreLookedAt)
{
  const TemporaryFolder folder;
  std::string text = "name: steps\nstart: {block_height: 20}\nwell: {stations: [[0, 0, 0]";
  for (int i = 0; i < 20; ++i) text += ", [" + std::to_string(30 * (i + 80)) + ", " + std::to_string(i) + ", 40]";
  const std::string file = folder.file("scene.yaml");
  std::ofstream(file)
      << text
      << ", [3900, 20, 40]], hole_depth: 2900, sections: [{to: 2900, diameter: 0.2159, friction: 0.25}]}\n"
         "formation: [{to_tvd: 10000, drillability: 1.0e-8}]\n"
         "string: [{name: bit, type: bit, length: 0.3, mass: 40, diameter: 0.2159}, {name: pipe, type: pipe, joints: "
         "fill, joint_length: 9.5, outer_diameter: 0.127, inner_diameter: 0.1086, linear_mass: 31.9}]\n";
  std::string remarks;
  for (const std::string& remark : read_scene(file).remarks) remarks += remark + "\n";
  EXPECT_TRUE(holds(remarks, "well.stations: the last station, at 3900 m")) << remarks;
}
}  // namespace drill_rig_sim::test_scene_station_steps
