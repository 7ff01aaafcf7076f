// SPDX-License-Identifier: BSD-3-Clause
// A station of a survey that does not fit those beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "survey_reading.h"

namespace drill_rig_sim::test_scene_lone_station
{
using namespace survey_reading;

namespace
{
// A hole that builds 2 deg and turns 1 deg a stand of 30 m, with the scatter of measured angles.
std::vector<SurveyStation> hole(std::size_t count)
{
  std::vector<SurveyStation> stations;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double k = static_cast<double>(i), scatter = i % 2 == 0 ? 0.2 : -0.2;
    stations.push_back({300.0 + 30.0 * k, (20.0 + 2.0 * k + scatter) * degree, (240.0 + k - scatter) * degree});
  }
  return stations;
}

// what the reader says of a file of these stations, with depths in this unit
std::string of(const std::vector<SurveyStation>& stations, const std::string& unit = "m")
{
  std::ostringstream text;
  text << "MD (" << unit << "),Inc (deg),Azi (deg)\n" << std::setprecision(10);
  for (const SurveyStation& station : stations)
    text << station.md << "," << station.inclination / degree << "," << station.azimuth / degree << "\n";
  const TemporaryFolder folder;
  const std::string file = folder.file("survey.txt");
  std::ofstream(file) << text.str();
  const auto tie_in = stations.front().md > 0.0 ? std::optional<TieIn>(TieIn{0.0, 0.0, 60.0}) : std::nullopt;
  std::string all;
  for (const std::string& remark : read_survey_file(file, tie_in).remarks) all += remark.substr(remark.find("survey.txt") + 12);
  return all;
}

std::vector<SurveyStation> with(std::vector<SurveyStation> stations, std::size_t i, double inclination, double azimuth)
{
  stations[i].inclination = inclination * degree;
  stations[i].azimuth = azimuth * degree;
  return stations;
}
}  // namespace

TEST(LoneStation, AnAngleThatWasNotMeasured)
{
  EXPECT_EQ("", of(hole(10)));
  EXPECT_EQ("at 390 m the azimuth is 0 deg, beside it 241.8 and 243.8 deg; was it measured?", of(with(hole(10), 3, 25.8, 0.0)));
  EXPECT_EQ("at 390 m the azimuth is -1 deg, beside it 241.8 and 243.8 deg; was it measured?", of(with(hole(10), 3, 25.8, -1.0)));
  EXPECT_EQ("at 390 m the inclination is 0 deg, beside it 24.2 and 28.2 deg; was it measured?",
            of(with(hole(10), 3, 0.0, 243.2)));
  EXPECT_EQ("", of(with(hole(10), 3, 25.8, 243.5)));
}

TEST(LoneStation, TheFirstAndTheLastStation)
{
  EXPECT_EQ("at 300 m the azimuth is 0 deg, beside it 241.2 deg; was it measured?", of(with(hole(10), 0, 20.2, 0.0)));
  EXPECT_EQ("at 570 m the azimuth is 0 deg, beside it 247.8 deg; was it measured?", of(with(hole(10), 9, 37.8, 0.0)));
  std::vector<SurveyStation> from_table = hole(10);
  from_table.insert(from_table.begin(), SurveyStation{0.0, 0.0, 0.0});
  EXPECT_EQ("", of(from_table)) << "a vertical beginning has no azimuth";
}

TEST(LoneStation, AWrongDigit)
{
  EXPECT_EQ(
      "the station at 420 m (inclination 28.2, azimuth 234.8 deg) lies 4.5 deg off those beside it (25.8, 243.2 and 29.8, 245.2 "
      "deg), which fit together; is one of its numbers wrong?",
      of(with(hole(10), 4, 28.2, 234.8)));
  EXPECT_TRUE(holds(of(with(hole(10), 4, 82.2, 243.8)), "inclination 82.2")) << "28.2 with exchanged digits";
  std::vector<SurveyStation> feet = with(hole(10), 4, 82.2, 243.8);
  EXPECT_TRUE(holds(of(feet, "ft"), "the station at 420 ft"));
}

// What drilled and planned holes have.
TEST(LoneStation, HolesThatAreRightAreNotReported)
{
  EXPECT_EQ("", of(with(hole(10), 4, 28.2 - 1.9, 243.8))) << "a soft layer";
  std::vector<SurveyStation> swings = hole(12);
  for (std::size_t i = 1; i < swings.size(); i += 2) swings[i].inclination += 3.0 * degree;
  EXPECT_EQ("", of(swings)) << "slid and rotated in turn";
  std::vector<SurveyStation> corners;
  for (const double k : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0})
    corners.push_back({300.0 * k, (k < 4.0 ? 0.0 : 30.0) * degree, 40.0 * degree});
  EXPECT_EQ("", of(corners)) << "a plan by its corners";
  std::vector<SurveyStation> north = hole(10);
  for (SurveyStation& station : north) station.azimuth = 0.0;
  EXPECT_EQ("", of(north));
  std::vector<SurveyStation> past_north = hole(10);
  for (std::size_t i = 0; i < past_north.size(); ++i)
    past_north[i].azimuth = std::fmod(355.0 + static_cast<double>(i), 360.0) * degree;
  EXPECT_EQ("", of(past_north));
  std::vector<SurveyStation> vertical;
  for (const double azimuth : {12.0, 230.0, 0.0, 340.0, 91.0, 182.0, 0.0, 77.0, 305.0})
    vertical.push_back({30.0 * static_cast<double>(vertical.size()), 0.4 * degree, azimuth * degree});
  EXPECT_EQ("", of(vertical)) << "azimuths of a vertical hole are anything";
}

TEST(LoneStation, FilesReportIt)
{
  const SurveyTable table = read("MD (ft),Inc (deg),Azi (deg)\n0,0,0\n1000,10,45\n1090,12,0\n1180,14,45\n");
  ASSERT_EQ(1u, table.remarks.size());
  EXPECT_TRUE(holds(table.remarks[0], "at 1090 ft the azimuth is 0 deg, beside it 45 and 45 deg; was it measured?"))
      << table.remarks[0];
}

}  // namespace drill_rig_sim::test_scene_lone_station
