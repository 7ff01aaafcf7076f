// SPDX-License-Identifier: BSD-3-Clause
// Surveys' cells and delimiters: digits in groups, bars, numbered stations, a turn that no hole has.
#include "survey_reading.h"

namespace drill_rig_sim::test_scene_survey_cells
{
using namespace survey_reading;

TEST(SceneSurvey, BarsNumbersOfStationsAndDepthsBelowKb)
{
  expect_station(read("MD (m)|Inc (deg)|Azi (deg)\n0|0|0\n500,5|1,5|40,25\n").stations[1], 500.5, 1.5, 40.25);
  expect_station(read("#,MD (m),Inc (deg),Azi (deg)\n1,0,0,0\n2,500,1,40\n").stations[1], 500.0, 1.0, 40.0);
  expect_station(read("# by hand\nMD below KB (m),Inc (deg),Azi (deg)\n0,0,0\n500,1,40\n").stations[1], 500.0, 1.0, 40.0);
  EXPECT_TRUE(holds(refusal("~V\nVERS. 2.0:\n"), ":1: begins as a LAS file and has no curves (~C)"));
}

TEST(SceneSurvey, ATurnThatNoHoleHasIsReported)
{
  const std::string head = "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,1,40\n";
  const SurveyTable table = read(head + "510,80,40\n540,81,40\n");
  ASSERT_EQ(1u, table.remarks.size());
  EXPECT_TRUE(
      holds(table.remarks[0],
            "from 500.00 to 510.00 m the hole turns by 237 deg/30 m, more than drilled holes do; is one of the stations wrong?"))
      << table.remarks[0];
  EXPECT_TRUE(read(head + "530,30,40\n").remarks.empty()) << "29 deg/30 m: a short radius";
}

TEST(SceneSurvey, ItsOwnVerticalDepthsAreCompared)
{
  const auto remarks = [](const char* last)
  { return read("MD (m),Inc (deg),Azi (deg),TVD (ft)\n0,0,0,50\n500,0,0,\n1000,10,45," + std::string(last) + "\n").remarks; };
  // 500 m down, then an arc of 10 deg over 500 m: 500 sin(10 deg)/(10 deg in rad) = 497.466 m; the table lies 50 ft lower
  EXPECT_TRUE(remarks("3322.5").empty()) << "997.47 m and 50 ft";
  EXPECT_TRUE(remarks("3308").empty()) << "by another method";
  ASSERT_EQ(1u, remarks("997.5").size()) << "of metres";
  EXPECT_TRUE(holds(remarks("997.5")[0],
                    "its vertical depth at 1000.00 m is 304.04 m, by minimum curvature 1012.71 m; is a unit or a column wrong?"))
      << remarks("997.5")[0];
}

TEST(SceneSurvey, ItsOwnPlacesAreCompared)
{
  const auto table = [](double north, double east, const char* first = "0,0")
  {
    return read("MD (m),Inc (deg),Azi (deg),TVD (m),NS (m),EW (m)\n0,0,0,0," + std::string(first) +
                "\n500,0,0,500,,\n1000,10,45,997.47," + std::to_string(north) + "," + std::to_string(east) + "\n");
  };
  // 500 (1 - cos(10 deg))/(10 deg in rad) = 43.52 m to north-east
  EXPECT_TRUE(table(30.78, 30.78).remarks.empty());
  EXPECT_TRUE(table(31.5, 30.0).remarks.empty()) << "azimuths of a grid";
  ASSERT_EQ(1u, table(43.5, 0.0).remarks.size());
  EXPECT_TRUE(
      holds(table(43.5, 0.0).remarks[0], "its north and east at 1000.00 m are 43.50 and 0.00 m, by minimum curvature 30.7"));
  const SurveyTable map = table(6543240.78, 456819.78, "6543210,456789");
  ASSERT_EQ(1u, map.remarks.size()) << map.remarks.back();
  EXPECT_TRUE(
      holds(map.remarks[0],
            "north 6543210.00 m and east 456789.00 m look like map coordinates: positions are relative to the first station"));
  EXPECT_EQ(0.0, map.tie_in->north);
}

TEST(SceneSurvey, AFirstStationOutOfReach)
{
  const auto table = [](const std::string& north, const std::string& tvd)
  { return "MD (m),Inc (deg),Azi (deg),TVD (m),NS (m),EW (m)\n500,10,45," + tvd + "," + north + ",20\n600,12,45,,,\n"; };
  EXPECT_EQ(20.0, read(table("20", "499")).tie_in->north);
  EXPECT_TRUE(
      holds(refusal(table("6543210", "499")),
            ":2: station 1: lies 6543210.02 m from the rotary table (north 6543210.00, east 20.00, tvd 499.00 m), allowed: "
            "up to its measured depth, 500.00 m"));
  EXPECT_TRUE(holds(refusal(table("20", "1637")), "lies 1637.24 m from the rotary table")) << "feet below metres";
}

TEST(SceneSurvey, MinutesInAColumnOfTheirOwn)
{
  for (const char* names :
       {"MD (m),Inc deg,Inc min,Azi (deg)", "MD (m),Inc (deg),Inc (min),Azi (deg)", "MD (m),Inc,Min,Azi (deg)"})
    EXPECT_TRUE(holds(refusal(std::string(names) + "\n0,0,0,0\n500,10,30,45\n"), " holds minutes of \"Inc")) << names;
  EXPECT_TRUE(
      holds(refusal("MD (m),Inc (deg),Azi Deg,Azi Min\n0,0,0,0\n500,10,45,30\n"), ":1: Azi Min: holds minutes of \"Azi Deg\""));
  const std::string time = "MD (m),Inc (deg),Time (min),Azi (deg),Inc Min (deg)\n0,0,0,0,0\n500,10,30,45,9\n";
  expect_station(read(time).stations.at(1), 500.0, 10.0, 45.0);
}

TEST(SceneSurvey, DigitsInGroups)
{
  const std::string head = "MD (m);Inc (deg);Azi (deg)\n", above = "0;0;0\n500;1;40\n";
  for (const auto& [row, remark] :
       {std::pair<const char*, const char*>{"1,234.50;2.5;40.25",
                                            "its numbers have commas between groups of digits (first: line 4: 1,234.50)"},
        {"1,234;2.5;40.25", "its numbers have commas between groups of digits (first: line 4: 1,234)"},
        {"1.234,50;2,5;40,25", "its numbers have points between groups of digits (first: line 4: 1.234,50)"},
        {"1.234;2,5;40,25", "its numbers have points between groups of digits (first: line 4: 1.234)"},
        {"1 234,50;2,5;40,25", ""},
        {"1\xe2\x80\xaf"
         "234.5;2.5;40.25",
         ""},
        {"1\xc2\xa0"
         "234,5;2,5;40,25",
         ""},
        {"1'234.5;2.5;40.25", ""},
        {"1\xe2\x80\x99"
         "234.5;2.5;40.25",
         ""}})
  {
    const SurveyTable table = read(head + above + row + "\n");
    expect_station(table.stations[2], std::string(row).substr(5, 1) == ";" ? 1234.0 : 1234.5, 2.5, 40.25);
    EXPECT_EQ(*remark ? 1u : 0u, table.remarks.size()) << row;
    for (const std::string& one : table.remarks) EXPECT_TRUE(holds(one, remark)) << one;
  }
  const SurveyTable mixed = read("MD (m)\tInc (deg)\tAzi (deg)\n0\t0\t0\n1,000\t2\t40\n1,234.5\t2.5\t40\n");
  EXPECT_DOUBLE_EQ(1000.0, mixed.stations[1].md) << "a whole number beside one with both signs";
  EXPECT_DOUBLE_EQ(1000.0, read("MD (m),Inc (deg),Azi (deg)\n0,0,0\n\"1,000\",2.5,40\n").stations[1].md);
  EXPECT_TRUE(holds(refusal(head + above + "1,234.5;2;40\n1.334,5;2;40\n"),
                    ":5: 1.334,5 has another decimal sign than 1,234.5 (line 4), needed: one decimal sign in all numbers"));
  EXPECT_TRUE(holds(refusal(head + above + "1,234.5;2,5;40\n"), ":4: Inc (deg): must be a finite number (got \"2,5\")"));
  EXPECT_TRUE(holds(refusal(head + above + "1.234,5;2.5;40\n"), "the file mixes decimal commas and decimal points"));
  EXPECT_TRUE(holds(refusal(head + above + "1 23,5;2,5;40\n"), ":4: MD (m): must be a finite number (got \"1 23,5\")"));
}

// As typesetters write them: a minus sign and dashes.
TEST(SceneSurvey, TypesetSigns)
{
  const std::string minus = "\xe2\x88\x92", dash = "\xe2\x80\x93", long_dash = "\xe2\x80\x94";
  const SurveyTable table = read("MD (m);Inc (deg);Azi (deg);North (m);East (m);TVD (m)\n0;0;" + minus + "5;" + minus + "1.5;" +
                                 dash + "2;0\n500;10;45;;;\n");
  expect_station(table.stations[0], 0.0, 0.0, -5.0);
  ASSERT_TRUE(table.tie_in);
  EXPECT_DOUBLE_EQ(-1.5, table.tie_in->north);
  EXPECT_DOUBLE_EQ(-2.0, table.tie_in->east);
  EXPECT_TRUE(holds(refusal("MD (m);Inc (deg);Azi (deg)\n0;0;0\n500;" + long_dash + ";45\n"), ":3: Inc (deg): has no value"));
}

// A table copied from a report: the mark is the problem, not the decimal sign.
TEST(SceneSurvey, MarksOfFootnotes)
{
  const std::string head = "MD (ft);Inc (deg);Azi (deg)\n0,0;0,0;0,0\n1.500,0;1,5;40,0\n";
  for (const char* cell :
       {"2.000,01)", "2.000,0*", "2.000,0 **", "2.000,0\xc2\xb9", "2.000,0 (1)", "2.000,0 a)", "2.000,0 m", "2.000,0 [2]"})
    EXPECT_TRUE(holds(refusal(head + cell + ";2,5;40,0\n"),
                      ":4: MD (ft): must be a number without a mark or a unit behind it (got \"" + std::string(cell) + "\")"))
        << refusal(head + cell + ";2,5;40,0\n");
  EXPECT_TRUE(holds(refusal(head + "2.000,0;2,5 1);40,0\n"), ":4: Inc (deg): must be a number without a mark"));
  // signs of two and three bytes are shown as they are
  for (const char* mark : {"\xc2\xb9", "\xe2\x80\xa0", "\xe2\x80\xa1"})
    EXPECT_TRUE(
        holds(refusal(head + "2.000,0" + mark + ";2,5;40,0\n"),
              ":4: MD (ft): must be a number without a mark or a unit behind it (got \"2.000,0" + std::string(mark) + "\")"));
  EXPECT_TRUE(holds(refusal(head + "2000 secret;2,5;40,0\n"), ":4: MD (ft): must be a finite number (got text)"));
}

// What a spreadsheet or a program writes for no number is shown, another text is not.
TEST(SceneSurvey, WordsForNoNumber)
{
  for (const char* cell : {"#N/A", "#VALUE!", "#REF!", "#DIV/0!", "NaN", "-nan(ind)", "1.#INF", "-1.#IND"})
    EXPECT_TRUE(holds(refusal("MD (m),Inc (deg),Azi (deg)\n0,0,0\n100," + std::string(cell) + ",0\n"),
                      ":3: Inc (deg): must be a finite number (got \"" + std::string(cell) + "\")"))
        << cell;
}
}  // namespace drill_rig_sim::test_scene_survey_cells
