// SPDX-License-Identifier: BSD-3-Clause
// Surveys whose tables mark stations as bad, or hold a plan beside the drilled well; numbers like those of another unit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "survey_reading.h"

namespace drill_rig_sim::test_scene_survey_marks
{
using namespace survey_reading;

namespace
{
const std::string head = "MD (m),Inc (deg),Azi (deg)";

std::string all_remarks(const SurveyTable& table)
{
  std::string text;
  for (const std::string& remark : table.remarks) text += remark + "\n";
  return text;
}

SurveyFormat of_plan()
{
  SurveyFormat format;
  format.plan = true;
  return format;
}

// Three stations, of which the second one is marked.
std::string marked(const std::string& name, const std::string& good, const std::string& bad)
{
  return head + "," + name + "\n0,0,0," + good + "\n500,80,45," + bad + "\n1000,10,45," + good + "\n";
}
}  // namespace

TEST(SurveyMarks, BadStationsAreLeftOut)
{
  for (const std::string& text :
       {marked("Status", "Definitive", "BAD"), marked("Status", "", "REJECTED"), marked("QC", "Pass", "Fail"),
        marked("QC", "P", "F"), marked("Survey Status", "ok", "Suspect"), marked("Data Quality", "good", "questionable"),
        marked("QC", "1", "999"), marked("Accepted", "Y", "N"), marked("Acc", "A", "R"), marked("Status", "Good", "Bad Mag"),
        marked("Survey Type", "Definitive", "Rejected"), marked("Valid", "1", "0"), marked("Rejected", "false", "true"),
        marked("Inc QC", "good", "bad"), marked("Comments", "MWD", "BAD SURVEY"), marked("Comment", "", "do not use"),
        marked("OPC Quality", "192", "0")})
  {
    const SurveyTable table = read(text);
    ASSERT_EQ(2u, table.stations.size()) << text;
    expect_station(table.stations[1], 1000.0, 10.0, 45.0);
    ASSERT_EQ(1u, table.remarks.size()) << all_remarks(table);
    EXPECT_TRUE(holds(table.remarks[0], "1 station marked \"")) << table.remarks[0];
    EXPECT_TRUE(holds(table.remarks[0], " was left out (line 3)")) << table.remarks[0];
  }
}

TEST(SurveyMarks, OthersAreUsed)
{
  for (const std::string& text :
       {marked("Status", "Definitive", "Interpolated"), marked("Status", "Definitive", "Projected"),
        marked("Comment", "Tie-in", "KOP"), marked("Tool", "MWD", "bad"), marked("QC", "ok", "ok"), marked("Type", "MWD", "Gyro"),
        marked("QC Date", "1", "0"), marked("Signal Quality", "91", "87")})
  {
    const SurveyTable table = read(text);
    EXPECT_EQ(3u, table.stations.size()) << text;
  }
  EXPECT_TRUE(holds(read(marked("QC", "ok", "B-7")).remarks.at(0), "1 station marked \"B-7\" by \"QC\" is used (line 3)"));
}

TEST(SurveyMarks, UnclearOnes)
{
  EXPECT_TRUE(
      holds(refusal(marked("QC", "0", "1")), ":2: QC: holds \"0\" and \"1\": which of them mark bad stations is not known"));
  EXPECT_TRUE(holds(refusal(marked("Quality", "A", "B")), "Quality: holds \"A\" and \"B\""));
  EXPECT_TRUE(holds(read(marked("Status", "0", "1")).remarks.at(0), "\"Status\" holds \"0\" and \"1\""));
  EXPECT_TRUE(holds(refusal(marked("QC", "bad", "BAD")), "QC: marks all stations as bad"));
  SurveyFormat format;
  format.quality = {"QC", "0 2"};
  EXPECT_EQ(2u, read(marked("QC", "0", "1"), format).stations.size());
  EXPECT_EQ(3u, read(marked("QC", "0", "2"), format).stations.size());
}

TEST(SurveyMarks, PlanBesideActual)
{
  const std::string columns =
      "Plan MD (m),Plan Inc (deg),Plan Azi (deg),Actual MD (m),Actual Inc (deg),Actual Azi "
      "(deg)\n0,0,0,0,0,0\n500,10,45,510,11,46\n";
  const std::string groups =
      "Planned,,,Actual,,\nMD (m),Inc (deg),Azi (deg),MD (m),Inc (deg),Azi (deg)\n0,0,0,0,0,0\n"
      "500,10,45,510,11,46\n";
  const std::string brackets =
      "MD (plan) (m),Inc (plan) (deg),Azi (plan) (deg),MD (actual) (m),Inc (actual) (deg),"
      "Azi (actual) (deg)\n0,0,0,0,0,0\n500,10,45,510,11,46\n";
  const std::string design =
      "MD (m),Inc (deg),Azi (deg),Design MD (m),Target Inc (deg),Prognosed Azi (deg)\n0,0,0,0,0,0\n510,11,46,"
      "500,10,45\n";
  for (const std::string& text : {columns, groups, brackets, design})
  {
    expect_station(read(text).stations.at(1), 510.0, 11.0, 46.0);
    expect_station(read(text, of_plan()).stations.at(1), 500.0, 10.0, 45.0);
  }
  const std::string one_depth = "MD (m),Planned Inc (deg),Planned Azi (deg),Inc (deg),Azi (deg)\n0,0,0,0,0\n500,10,45,11,46\n";
  expect_station(read(one_depth).stations.at(1), 500.0, 11.0, 46.0);
  expect_station(read(one_depth, of_plan()).stations.at(1), 500.0, 10.0, 45.0);
}

TEST(SurveyMarks, OtherWordsForTheDrilledWell)
{
  const auto table = [](const std::string& word)
  {
    return "Planned MD (m),Planned Inc (deg),Planned Azi (deg)," + word + " MD (m)," + word + " Inc (deg)," + word +
           " Azi (deg)\n0,0,0,0,0,0\n500,10,45,510,11,46\n";
  };
  for (const char* word : {"Surveyed", "Definitive", "As-drilled"})
  {
    expect_station(read(table(word)).stations.at(1), 510.0, 11.0, 46.0);
    EXPECT_EQ("", all_remarks(read(table(word)))) << word;
  }
  for (const char* word : {"Observed", "Real", "MWD", "Ist"})
  {
    EXPECT_TRUE(holds(refusal(table(word)), std::string(word) + " Inc (deg): may be of the survey, beside \"Planned Inc (deg)\""))
        << word;
    expect_station(read(table(word), of_plan()).stations.at(1), 500.0, 10.0, 45.0);
  }
  const std::string tolerance = "Plan MD (m),Plan Inc (deg),Plan Azi (deg),Inc Tolerance\n0,0,0,1\n500,10,45,1\n";
  expect_station(read(tolerance).stations.at(1), 500.0, 10.0, 45.0);
}

TEST(SurveyMarks, AGroupWithoutAKnownName)
{
  const std::string text =
      "Planned,,,Final,,\nMD (m),Inc (deg),Azi (deg),MD (m),Inc (deg),Azi (deg)\n0,0,0,0,0,0\n500,10,45,510,11,46\n";
  expect_station(read(text).stations.at(1), 510.0, 11.0, 46.0);
  EXPECT_EQ("", all_remarks(read(text))) << "the plan is the other group";
}

TEST(SurveyMarks, PartsOfAPlan)
{
  EXPECT_TRUE(holds(refusal("Plan MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,10,45\n"),
                    "Plan MD (m): is not of the same path as \"Inc (deg)\""));
  EXPECT_TRUE(holds(refusal("MD (m),Inc (deg),Azi (deg),Plan Inc (deg)\n0,0,0,0\n500,10,45,9\n", of_plan()),
                    "Azi (deg): is not of the same path as \"Plan Inc (deg)\""));
  const std::string plan = "Plan MD (m),Plan Inc (deg),Plan Azi (deg)\n0,0,0\n500,10,45\n";
  EXPECT_TRUE(holds(read(plan).remarks.at(0), "its columns are planned ones: they are read as the survey"));
  EXPECT_TRUE(read(plan, of_plan()).remarks.empty());
}

TEST(SurveyMarks, TitlesOfAPlan)
{
  const std::string rows = head + "\n0,0,0\n500,10,45\n";
  for (const char* title : {"Data Type: Plan", "Type,Plan", "Planned trajectory", "# Wellplan A-1 rev 3"})
  {
    const std::string text = "Well: A-1\n" + std::string(title) + "\n" + rows;
    EXPECT_TRUE(holds(all_remarks(read(text)), "a line above its names calls it planned: it is read as the survey")) << title;
    EXPECT_EQ("", all_remarks(read(text, of_plan()))) << title;
  }
  EXPECT_TRUE(holds(all_remarks(read("Definitive survey\n" + rows, of_plan())), "calls it actual: it is read as the plan"));
  const char* const others[] = {"Survey program", "Deviation from plan", "Actual against plan",
                                "Design: A-1",    "Definitive survey",   "# A plan for two scenes: vertical, then a build"};
  for (const char* title : others) EXPECT_EQ("", all_remarks(read(std::string(title) + "\n" + rows))) << title;
}

TEST(SurveyMarks, RowsOfAPlan)
{
  const std::string text = head + ",Type\n0,0,0,Actual\n500,10,45,Actual\n600,12,45,Plan\n700,14,45,Plan\n";
  const SurveyTable survey = read(text);
  EXPECT_EQ(2u, survey.stations.size());
  EXPECT_TRUE(holds(survey.remarks.at(0),
                    "2 stations marked \"Plan\" by \"Type\" were left out: it is read as a survey of the drilled well"));
  EXPECT_EQ(4u, read(head + ",Type\n0,0,0,Plan\n500,10,45,Plan\n600,12,45,Plan\n700,14,45,Plan\n").stations.size());
}

TEST(SurveyMarks, RowsWithoutAMark)
{
  const std::string rows[] = {"0,0,0,", "500,10,45,", "600,12,45,", "700,14,45,"};
  const auto marked = [&](const std::string& name, std::initializer_list<const char*> marks)
  {
    std::string text = head + "," + name + "\n";
    std::size_t k = 0;
    for (const char* mark : marks) text += rows[k++] + mark + "\n";
    return text;
  };
  // below a mark of the plan: joined cells, or the drilled well
  const std::string unknown = "it is not known which of both the station is, needed: a mark in every row";
  EXPECT_TRUE(holds(refusal(marked("Type", {"Plan", "", "", "Actual"})), ":3: Type: has no mark")) << "of a survey";
  EXPECT_TRUE(holds(refusal(marked("Type", {"Plan", "", "", ""})), unknown));
  EXPECT_TRUE(holds(refusal(marked("Type", {"Plan", "Plan", "", ""}), of_plan()), unknown));
  EXPECT_TRUE(holds(refusal(marked("Type", {"Actual", "Actual", "", ""}), of_plan()), unknown)) << "perhaps of the plan";
  // above all marks of the plan, or below those of the drilled well
  const SurveyTable ahead = read(marked("Type", {"", "", "Plan", "Plan"}));
  EXPECT_EQ(2u, ahead.stations.size());
  EXPECT_TRUE(holds(all_remarks(ahead), "2 stations marked nothing by \"Type\" are used as of the drilled well (lines 2, 3)"));
  EXPECT_TRUE(holds(all_remarks(ahead), "2 stations marked \"Plan\" by \"Type\" were left out"));
  const SurveyTable drilled = read(marked("Type", {"Actual", "", "Actual", "Plan"}));
  EXPECT_EQ(3u, drilled.stations.size());
  const SurveyTable plan = read(marked("Type", {"Plan", "Plan", "Actual", ""}), of_plan());
  EXPECT_EQ(2u, plan.stations.size());
  EXPECT_TRUE(holds(all_remarks(plan), "2 stations marked \"Actual\", nothing by \"Type\" were left out"));
  EXPECT_TRUE(holds(all_remarks(read(marked("Type", {"Plan", "Plan", "Plan", "Plan"}))),
                    "all stations are marked \"Plan\" by \"Type\": they are read as the survey"));
  // a comment is no mark of a path
  EXPECT_EQ(4u, read(marked("Comment", {"", "KOP", "Target", ""})).stations.size());
}

// A title below stations begins another table; one above them and one below all are none.
TEST(SurveyMarks, ATitleBetweenStations)
{
  const std::string first = head + "\n0,0,0\n500,10,45\n", second = head + "\n600,12,45\n700,14,45\n";
  EXPECT_TRUE(holds(refusal("Plan\n" + first + "Actual\n" + second), ":5: \"Actual\" stands between stations"));
  EXPECT_EQ(4u, read("Plan\n" + first + "Page 2\n" + second).stations.size());
  EXPECT_EQ(2u, read(first + "Plan\n").stations.size());
}

TEST(SurveyMarks, TheStateOfATrajectory)
{
  const std::string stations =
      "<trajectoryStation><md uom=\"m\">0</md><incl uom=\"deg\">0</incl><azi uom=\"deg\">0</azi></trajectoryStation>"
      "<trajectoryStation><md uom=\"m\">900</md><incl uom=\"deg\">3</incl><azi uom=\"deg\">40</azi></trajectoryStation>";
  const auto remarks = [&](const std::string& state, bool plan)
  {
    SurveyFormat format;
    format.plan = plan;
    return read("<trajectory>" + state + stations + "</trajectory>", format).remarks;
  };
  const std::string plan = "<commonData><itemState>plan</itemState></commonData>",
                    actual = "<commonData><itemState>actual</itemState></commonData>";
  ASSERT_EQ(1u, remarks(plan, false).size());
  EXPECT_TRUE(holds(remarks(plan, false)[0], "the state of the trajectory is `plan`: it is read as the survey"));
  EXPECT_TRUE(holds(remarks("<ExistenceKind>simulated</ExistenceKind>", false).at(0), "`simulated`: it is read as the survey"));
  EXPECT_TRUE(holds(remarks(actual, true).at(0), "`actual`: it is read as the plan"));
  EXPECT_TRUE(remarks(actual, false).empty());
  EXPECT_TRUE(remarks(plan, true).empty());
  EXPECT_TRUE(remarks("", false).empty());
}

// Stations at each stand, in feet under a heading of metres; at even depths, and stands in metres, are none.
TEST(SurveyMarks, FeetUnderMetres)
{
  const auto survey = [](double step, double tape, const char* unit)
  {
    std::string text = "MD (" + std::string(unit) + "),Inc (deg),Azi (deg)\n";
    for (int i = 0; i < 20; ++i)
    {
      char row[80];
      std::snprintf(row, sizeof row, "%.2f,%.2f,%.1f\n", step * i + tape * (i % 3), 0.8 * i, 37.3);
      text += row;
    }
    return all_remarks(read(text));
  };
  EXPECT_TRUE(holds(survey(94.1, 0.4, "m"), "its stations are usually 94.5 m apart, as stands are in feet"))
      << survey(94.1, 0.4, "m");
  EXPECT_TRUE(holds(survey(62.3, 0.3, "m"), "as stands are in feet"));
  for (const double step : {28.68, 9.5, 30.0, 90.0, 91.44, 60.96, 57.3, 30.2}) EXPECT_EQ("", survey(step, 0.0, "m")) << step;
  EXPECT_EQ("", survey(94.1, 0.4, "ft"));
}

// A build of 3 deg/30 m to 87 deg in azimuths around 217 deg, its angles in radians under a heading of degrees.
TEST(SurveyMarks, RadiansUnderDegrees)
{
  const auto survey = [](double unit, double inclination, double turn)
  {
    std::string text = head + "\n";
    for (int i = 0; i < 30; ++i)
    {
      char row[80];
      std::snprintf(row, sizeof row, "%d,%.4f,%.4f\n", 30 * i, inclination * i * unit, std::fmod(217.3 + turn * i, 360.0) * unit);
      text += row;
    }
    return text;
  };
  EXPECT_TRUE(holds(all_remarks(read(survey(degree, 3.0, 0.37))), "look like radians; is the unit right?"));
  EXPECT_TRUE(read(survey(1.0, 3.0, 0.37)).remarks.empty());
  EXPECT_TRUE(read(survey(1.0, 0.05, 47.3)).remarks.empty()) << "vertical, azimuths all the way round";
  std::string vertical = head + "\n", north = vertical;
  for (int i = 0; i < 30; ++i)
  {
    vertical += std::to_string(30 * i) + ",0,0\n";
    north += std::to_string(30 * i) + "," + std::to_string(0.04 * i) + ",0\n";
  }
  EXPECT_TRUE(read(vertical).remarks.empty());
  EXPECT_TRUE(read(north).remarks.empty());
}

// Which of "Inc" and "Inc Corrected" is meant, the file does not say.
TEST(SurveyMarks, RawAndCorrectedAnglesAreRefused)
{
  EXPECT_TRUE(holds(refusal("MD (m),Inc (deg),Inc Corrected (deg),Azi (deg)\n0,0,0,0\n"),
                    "several columns fit: \"Inc (deg)\", \"Inc Corrected (deg)\""));
  EXPECT_TRUE(holds(refusal("MD (m),Inc (deg),Azi True (deg),Azi True Corr. (deg)\n0,0,0,0\n"),
                    "several columns fit: \"Azi True (deg)\", \"Azi True Corr. (deg)\""));
  EXPECT_EQ("accepted", refusal("MD (m),Inc Corrected (deg),Azi (sag, deg)\n0,0,0\n9,0,0\n"));
}
}  // namespace drill_rig_sim::test_scene_survey_marks
