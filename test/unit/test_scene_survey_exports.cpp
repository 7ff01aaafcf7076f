// SPDX-License-Identifier: BSD-3-Clause
// Exports of surveys as programs of the trade write them, and what is refused in them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "survey_reading.h"

namespace drill_rig_sim::test_scene_survey_exports
{
using namespace survey_reading;

namespace
{
struct Export
{
  const char* what;
  const char* text;
  int stations;
  double md, inclination, azimuth;  // of the last station [m, deg, deg]
};

struct RefusedExport
{
  const char* what;
  const char* text;
  const char* said;
};
}  // namespace

TEST(SceneSurvey, ExportsOfTheTrade)
{
  const std::vector<Export> exports = {
      {"Compass",
       "Company:,ACME\nNorth Reference:,Grid\n\nMD,Inc,Azi "
       "(azimuth),TVD,+N/-S,+E/-W,DLS\n(ft),(\xc2\xb0),(\xc2\xb0),(ft),(ft),(ft),(\xc2\xb0/"
       "100ft)\n0.00,0.00,0.00,0.00,0.00,0.00,0.00\n"
       "1000.00,10.00,45.00,994.93,61.55,61.55,1.00\n",
       2, 304.8, 10.0, 45.0},
      {"Excel, decimal commas",
       "sep=;\r\n\"MD [m]\";\"Incl [\xc2\xb0]\";\"Azi "
       "[\xc2\xb0]\"\r\n\"0,0\";\"0,0\";\"0,0\"\r\n\"1500,25\";\"10,5\";\"45,25\"\r\n;;\r\n",
       2, 1500.25, 10.5, 45.25},
      {"decimal commas in quotes between commas", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n\"1500,25\",\"10,5\",45\n", 2, 1500.25,
       10.5, 45.0},
      {"one well", "Well Name,MD (m),Inc (deg),Azi (deg)\nA-1,0,0,0\na-1,500,10,45\n", 2, 500.0, 10.0, 45.0},
      {"tabs, empty columns at the end", "MD (m)\tInc (deg)\tAzi (deg)\t\t\n0\t0\t0\t\t\n500\t10\t45\t\t\n", 2, 500.0, 10.0,
       45.0},
      {"names of well logs", "DEPT (M),DEVI (DEG),HAZI (DEG)\n0,0,0\n500,10,45\n", 2, 500.0, 10.0, 45.0},
      {"comments", "# a\nMD (m),Inc (deg),Azi (deg)\n0,0,0\n! b\n// c\n500,10,45\n% d\n", 2, 500.0, 10.0, 45.0},
      {"corrected azimuth", "MD (m),Inc (deg),Corrected Azimuth (deg)\n0,0,0\n500,10,45\n", 2, 500.0, 10.0, 45.0},
      {"drift", "Survey Depth (ft),Drift Angle (deg),Drift Azimuth (deg)\n0,0,0\n1000,10,45\n", 2, 304.8, 10.0, 45.0},
      {"degrees, minutes, seconds",
       "MD (m),Azi (deg),Inc (deg)\n0,0,0\n500,45\xc2\xb0"
       "30'18\",10\xc2\xb0"
       "15'\n",
       2, 500.0, 10.25, 45.505},
      {"the same in quotes",
       "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,10,\"45\xc2\xb0"
       "30'18\"\"\"\n",
       2, 500.0, 10.0, 45.505},
      {"bearings", "MD (m),Inc (deg),Azi (deg)\n0,0,N0E\n400,9,S45.5W\n500,10,N 10\xc2\xb0 30' W\n", 3, 500.0, 10.0, 349.5},
      {"a bearing to the south-east", "MD (m);Inc (deg);Azi (deg)\n0;0;0\n500;10;S45,5E\n", 2, 500.0, 10.0, 134.5},
      {"360 and negative", "MD (m),Inc (deg),Azi (deg)\n0,0,360\n500,10,-10\n", 2, 500.0, 10.0, -10.0},
      {"rising", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,0,0\n1000,90,45\n1500,100,45\n", 4, 1500.0, 100.0, 45.0},
      {"names in two lines, in quotes",
       "\"Comments\",\"MD\n(ft)\",\"Incl\n(\xc2\xb0)\",\"Azim Grid\n(\xc2\xb0)\"\nTie-In,0,0,0\n,1000,10,45\n", 2, 304.8, 10.0,
       45.0},
      {"a comment in two lines", "MD (m),Inc (deg),Azi (deg),Comment\n0,0,0,\"tie-in\nby gyro\"\n500,10,45,8.5\" hole\n", 2,
       500.0, 10.0, 45.0},
      {"the tie-in line", "MD (m),Inc (deg),Azi (deg),Comment\n0,0,0,Tie-in\n500,10,45,MWD\n", 2, 500.0, 10.0, 45.0},
  };
  for (const Export& e : exports)
  {
    SCOPED_TRACE(e.what);
    const SurveyTable table = read(e.text);
    ASSERT_EQ(e.stations, static_cast<int>(table.stations.size()));
    expect_station(table.stations.back(), e.md, e.inclination, e.azimuth);
  }
}

// Lines are those of the file, also behind a cell in quotes that goes on in the next line.
TEST(SceneSurvey, CellsOverLines)
{
  const std::string names = "MD (m),Inc (deg),Azi (deg),Comment\n";
  EXPECT_TRUE(holds(refusal(names + "0,0,0,\"tie-in\nby gyro\"\n500,10,x\n"), ":4: Azi (deg): must be a finite number"));
  EXPECT_TRUE(holds(refusal(names + "0,0,0,\"tie-in\n500,10,x,\n"), ":3: Azi (deg): must be a finite number"))
      << "a quote that does not end";
}

// Depths below zero are not stations from the bottom up.
TEST(SceneSurvey, NegativeDepths)
{
  EXPECT_TRUE(
      holds(refusal("MD (m),Inc (deg),Azi (deg)\n0,0,0\n-500,10,45\n-1000,12,45\n"), ":3: station 2: md -500 m is out of range"));
}

// Reports of planning programs: blanks align the columns, and their names go over lines.
TEST(SceneSurvey, NamesAboveAlignedColumns)
{
  const SurveyTable report = read(
      "Well: A-1   Rig 7\n\n"
      "Measured                       Vertical\n"
      " Depth   Inclination  Azimuth   Depth     +N/-S     +E/-W\n"
      "  (ft)       (\xc2\xb0)        (\xc2\xb0)      (ft)      (ft)      (ft)\n\n"
      "    0.00       0.00      0.00      0.00      0.00      0.00\n"
      " 1968.50       4.00     50.00   1966.90     44.14     52.60\n");
  ASSERT_EQ(2u, report.stations.size());
  EXPECT_NEAR(1968.5 * 0.3048, report.stations[1].md, 1e-9);
  EXPECT_NEAR(4.0 * degree, report.stations[1].inclination, 1e-12);
  EXPECT_NEAR(50.0 * degree, report.stations[1].azimuth, 1e-12);
  const SurveyTable three = read(
      "  Meas.     Incl.     Azim.\n  Depth     Angle    (true)\n    (m)     (deg)     (deg)\n"
      "    0.0       0.0       0.0\n  600.0       4.0      50.0\n");
  ASSERT_EQ(2u, three.stations.size());
  EXPECT_NEAR(600.0, three.stations[1].md, 1e-9);

  // one blank parts the long names, and the angles are called so
  for (const char* names : {"Measured  Inclination Azimuth\nDepth     Angle       Angle\n(feet)    (deg)       (deg)\n",
                            "  MEASURED    INCL      AZIM\n   DEPTH      ANGLE     ANGLE\n   (feet)     (deg)     (deg)\n",
                            "Measured   Inclination Azimuth\nDepth (ft) Angle(deg)  Angle(deg)\n"})
  {
    const SurveyTable longer = read(names + std::string("0.0       0.00      118.59\n1000.0    4.00      50.00\n"));
    ASSERT_EQ(2u, longer.stations.size()) << names;
    EXPECT_NEAR(304.8, longer.stations[1].md, 1e-9);
    EXPECT_NEAR(4.0 * degree, longer.stations[1].inclination, 1e-12);
    EXPECT_NEAR(50.0 * degree, longer.stations[1].azimuth, 1e-12);
  }

  const std::string rows = "  Depth     Inc     Azi\n    (m)   (deg)   (deg)\n      0       0       0\n    600       4      50\n";
  EXPECT_TRUE(holds(read(rows).remarks.at(0), "\"Depth\" is read as measured depth"));
  EXPECT_TRUE(read("Measured\n" + rows).remarks.empty());
  EXPECT_TRUE(holds(refusal("Vertical\n" + rows), "md_m: no such column in the header; it has Vertical Depth, Inc, Azi"));
}

// The foot of a page, the head of the next one and a text at the end are skipped and reported, once.
TEST(SceneSurvey, PagesAndFooters)
{
  const SurveyTable pages = read(
      "Well A-1\nMD,Inc,Azi\n(m),(deg),(deg)\n0,0,0\n300,5,45\n\nPage 1 of 2\n\f\nWell A-1\nMD,Inc,Azi\n(m),(deg),(deg)\n"
      "500,10,45\nMD,Inc,Azi\n600,10,45\n\nEnd of survey\nPrinted 2024-05-21 10:00\n");
  ASSERT_EQ(4u, pages.stations.size());
  expect_station(pages.stations[1], 300.0, 5.0, 45.0);
  expect_station(pages.stations.back(), 600.0, 10.0, 45.0);
  ASSERT_EQ(1u, pages.remarks.size());
  EXPECT_TRUE(
      holds(pages.remarks[0], "7 lines without a station, text or the header again, skipped (first: line 7: Page 1 of 2)"));
  const SurveyTable report = read(
      " Measured\n  Depth      Inclination  Azimuth\n   (ft)         (deg)      (deg)\n      0.0        0.0      0.0\n"
      "   1000.0       10.0     45.0\n\n28/05/2024 10:12:33   Page 1   Build 74\n\f Measured\n  Depth      Inclination  Azimuth\n"
      "   (ft)         (deg)      (deg)\n   2000.0       20.0     45.0\n\nDesign Annotations\n");
  ASSERT_EQ(3u, report.stations.size());
  EXPECT_NEAR(609.6, report.stations.back().md, 1e-9);
  ASSERT_EQ(1u, report.remarks.size()) << report.remarks.front();
}

namespace
{
std::string las(const std::string& version, const std::string& wrap, const std::string& curves, const std::string& rows)
{
  return "# made for a test\n~Version\nVERS. " + version + " : LAS\nWRAP. " + wrap +
         " : one line a depth\n~Well\nSTRT.FT 0 :\nNULL. -1 :\n" + "~Curve\n" + curves + "~Parameter\n~A\n" + rows;
}
}  // namespace

TEST(SceneSurvey, LasOfASurvey)
{
  const std::string curves = "DEPT.FT : measured depth\nGR  .GAPI : gamma\nDEVI.DEG 01 : deviation\nHAZI.DEG : azimuth\n";
  const SurveyTable table = read(las("2.0", "NO", curves, "0 -1 0 0\n\n# a\n1000.0 30 10.0 45.0\n"));
  ASSERT_EQ(2u, table.stations.size());
  expect_station(table.stations[1], 304.8, 10.0, 45.0);
  EXPECT_TRUE(holds(table.remarks.at(0), "\"DEPT (FT)\" is read as measured depth"));
  EXPECT_TRUE(holds(refusal(las("2.0", "NO", curves, "0 0 0 0\n1000.0 30 -1.00 45.0\n")), ":16: DEVI (DEG): has no value"));
  const SurveyTable wrapped = read(las("2.0", "YES", curves, "0\n-1 0 0\n1000.0\n30 10.0\n45.0\n"));
  ASSERT_EQ(2u, wrapped.stations.size());
  expect_station(wrapped.stations[1], 304.8, 10.0, 45.0);
  EXPECT_TRUE(holds(refusal(las("2.0", "YES", curves, "0\n-1 0 0\n1000.0\n30 10.0\n")), ":18: HAZI (DEG): has no value"));
  EXPECT_TRUE(holds(refusal(las("4.0", "NO", curves, "0 0 0 0\n")), "is LAS 4.0, allowed: 1.2, 2.0 and 3.0"));
  EXPECT_EQ(2u, read(las("3.0", "NO", curves, "0 -1 0 0\n1000.0 30 10.0 45.0\n")).stations.size());
  EXPECT_TRUE(holds(refusal(las("2.0", "NO", "", "0 0 0 0\n")), "has no curves (~C)"));
  EXPECT_TRUE(
      holds(refusal(las("2.0", "NO", "DEPT.FT : d\nGR.GAPI : g\n", "0 0\n")), "inclination_deg, azimuth_deg: no such column"));
}

// The survey of a LAS 3.0 file beside its log.
TEST(SceneSurvey, Inclinometry)
{
  const auto file = [](const std::string& delimiter, const std::string& rows, const std::string& more = "")
  {
    return "~Version\nVERS. 3.0 : LAS\nWRAP. NO : one line a depth\nDLM . " + delimiter +
           " : delimiter\n~Well\nSTRT.M 0 :\nNULL. -999.25 :\n~Curve\nDEPT.M : depth {F}\nDEVI.DEG : of the log {F}\nHAZI.DEG : "
           "of the log {F}\n~ASCII | Curve\n0 1 1\n900 2 2\n~Inclinometry_Parameter\nAZREF. GRID : North reference {S}\n"
           "~Inclinometry_Definition\nMD.FT : Measured depth {F}\nTVD.FT : True vertical depth {F}\nAZIM.DEG : Borehole azimuth "
           "{F}\nDEVI.DEG : Borehole deviation {F}\n~Inclinometry_Data | Inclinometry_Definition\n" +
           rows + more;
  };
  for (const std::string& text : {file("SPACE", "0 0 0 0\n1000 995 45 10\n"), file("COMMA", "0,0,0,0\n1000,995,45,10\n"),
                                  file("TAB", "0\t0\t0\t0\n1000\t995\t45\t10\n")})
  {
    const SurveyTable table = read(text);
    ASSERT_EQ(2u, table.stations.size());
    expect_station(table.stations[1], 304.8, 10.0, 45.0);
    ASSERT_EQ(1u, table.remarks.size()) << table.remarks.front();
    EXPECT_TRUE(holds(table.remarks[0], "azimuths refer to grid north"));
  }
  EXPECT_TRUE(holds(refusal(file("SPACE", "0 0 0 0\n1000 995 -999.25 10\n")), "AZIM (DEG): has no value"));
  EXPECT_TRUE(
      holds(refusal(file("SPACE", "0 0 0 0\n1000 995 45 10\n", "~Inclinometry_Data[2] | Inclinometry_Definition\n0 0 0 0\n")),
            "holds 2 surveys (~Inclinometry_Data), needed: one"));
}

TEST(SceneSurvey, ADatumThatIsNotTheRotaryTable)
{
  const std::string rows = "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,10,45\n";
  for (const char* line : {"Depth Reference: MSL", "# MD reference: Mean Sea Level", "Depth datum,Sea Level"})
    EXPECT_TRUE(holds(read(std::string(line) + "\n" + rows).remarks.at(0), "depths count from mean sea level, as the file says"))
        << line;
  EXPECT_TRUE(holds(read("Depth Reference: Ground Level\n" + rows).remarks.at(0), "from ground level"));
  for (const char* line :
       {"TVD Reference: Mean Sea Level", "MD Reference: RKB @ 35.2 m above MSL", "Permanent datum: MSL", "Water depth to MSL"})
    EXPECT_TRUE(read(std::string(line) + "\n" + rows).remarks.empty()) << line;
  EXPECT_TRUE(holds(refusal("MD,Inc,Azi\nft MSL,deg,deg\n0,0,0\n500,10,45\n"), "unit \"ft MSL\" is not known"));
}

TEST(SceneSurvey, InclinationsFromTheHorizontal)
{
  EXPECT_TRUE(holds(read("MD (m),Inc (deg),Azi (deg)\n0,90,0\n500,85,45\n").remarks.at(0), "begins with 90 deg of inclination"));
  EXPECT_TRUE(read("MD (m),Inc (deg),Azi (deg)\n0,45,0\n500,50,0\n").remarks.empty());
}

// A delimiter or a remark at the end of rows does no harm.
TEST(SceneSurvey, CellsAtTheEndOfRows)
{
  EXPECT_EQ(2u, read("MD (m),Inc (deg),Azi (deg)\n0,0,0,\n500,10,45,\n").stations.size());
  EXPECT_EQ(2u, read("MD (m),Inc (deg),Azi (deg),\n0,0,0,tie-in\n500,10,45,\n").stations.size());
  EXPECT_EQ(2u, read("MD (m),Inc (deg),Azi (deg)\n0.0,0,0,,\n500.5,10,45,,\n").stations.size());
}

// Where columns are not aligned, a row may stand anywhere.
TEST(SceneSurvey, RowsOfAnyWidth)
{
  const SurveyTable table =
      read("MD(m)   INC(deg)   AZI(deg)   TVD(m)\n0   0   0   0\n100   0   0   100\n1000   1.25   0   999.9\n");
  ASSERT_EQ(3u, table.stations.size());
  expect_station(table.stations.back(), 1000.0, 1.25, 0.0);
}

TEST(SceneSurvey, ExportsThatAreRefused)
{
  const std::vector<RefusedExport> exports = {
      {"bearing of no quadrant", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,10,N95E\n", ":3: Azi (deg): must be a finite number"},
      {"half a bearing", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,10,N45\n", ":3: Azi (deg): must be a finite number"},
      {"bearing for inclination", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,N10E,45\n", ":3: Inc (deg): must be a finite number"},
      {"bearing in radians", "MD (m),Inc (rad),Azi (rad)\n0,0,0\n500,0.1,N45E\n", ":3: Azi (rad): must be a finite number"},
      {"decimal commas below empty names", "MD (m),Inc (deg),Azi (deg),,,\n100,0,2,3,45,1\n200,0,3,3,45,2\n",
       ":2: has 6 cells, the header 3, allowed: the same number, with decimal points"},
      {"decimal commas below names with commas", "MD, m,Inc, deg,Azi, deg\n100,0,2,3,45,1\n",
       ":1: MD, m: a name contains the delimiter, a comma before the unit"},
      {"decimal commas before empty cells", "MD (m),Inc (deg),Azi (deg),TVD,VS,DLS\n100,0,2,3,45,1,,,\n200,0,3,3,45,2,,,\n",
       ":2: has 9 cells, the header 6, allowed: the same number, with decimal points"},
      {"61 minutes",
       "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,10,45\xc2\xb0"
       "61'\n",
       ":3: Azi (deg): must be a finite number"},
      {"degrees by blanks", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,10,45 30 00\n", ":3: Azi (deg): must be a finite number"},
      {"another unit", "MD (fathom),Inc (deg),Azi (deg)\n0,0,0\n0.5,10,45\n",
       ":1: MD (fathom): the unit in brackets is not known, allowed: m, mm, cm, km, ft, in, ftUS, or a map"},
      {"names in two lines", "Measured Vertical\nDepth Inc Azi Depth\n(ft) (deg) (deg) (ft)\n0 0 0 0\n",
       ":2: measured depth: appears more than once in the header"},
      {"from the bottom up", "MD (m),Inc (deg),Azi (deg)\n600,12,45\n500,10,45\n0,0,0\n",
       ":3: station 2: md 500 m is not deeper than the station before it, 600 m: the stations are listed from the bottom up"},
      {"out of order", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,10,45\n400,8,45\n600,12,45\n",
       ":4: station 3: md 400 m is not deeper than the station before it, 500 m"},
      {"twice, and different", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,10,45\n500,10.2,45\n",
       ":4: station 3: md 500 m is not deeper than"},
      {"above the table", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n100,0,0\n400,90,45\n1500,170,45\n", "above the rotary table"},
      {"a text between stations", "MD (m),Inc (deg),Azi (deg)\n0,0,0\nCasing,,\n500,10,45\n",
       ":3: MD (m): must be a finite number (got text)"},
      {"a letter in the last depth", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n5OO,10,45\n",
       ":3: MD (m): must be a finite number (got text)"},
      {"no number in the last depth", "MD (m),Inc (deg),Azi (deg)\n0,0,0\nnan,10,45\n",
       ":3: MD (m): must be a finite number (got \"nan\")"},
      {"another table below", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,10,45\n\nTarget,MD (m),Inc (deg)\nT1,400,3\n",
       ":5: MD (m): must be a finite number (got text)"},
      {"the header in another unit", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,10,45\nMD (ft),Inc (deg),Azi (deg)\n2000,10,45\n",
       ":4: names the columns anew with other names or units than line 1"},
      {"the units again, others", "MD,Inc,Azi\nm,deg,deg\n0,0,0\n500,10,45\nMD,Inc,Azi\nft,deg,deg\n2000,10,45\n",
       ":6: MD: must be a finite number (got text)"},
      {"two wells", "Well,MD (m),Inc (deg),Azi (deg)\nA,0,0,0\na,500,10,45\n,550,10,45\nB,600,10,45\n",
       ":5: Well: is B, in the rows above A, needed: one well in a file"},
      {"two wells by their numbers", "UWI;MD (m);Inc (deg);Azi (deg)\n100/1;0;0;0\n100/2;500;10;45\n", ":3: UWI: is 100/2"},
      {"an empty cell of aligned columns",
       "  MD(m)   INC(deg)  AZI(deg)  TVD(m)  REMARK\n"
       "    0.0        0.0       5.0     0.0  Tie\n"
       "   30.0        1.0              30.0  MWD ok\n",
       ":3: its cells are not aligned with those of line 2 from AZI(deg) on: a cell is empty in one of these lines"},
      {"the same in the line before",
       "MD(m)  INC(deg)  AZI(deg)  TVD(m)  REMARK\n"
       "0.0    0.0                 0.0     Tie in\n"
       "30.0   1.0       10.0      30.0    MWD\n",
       ":3: its cells are not aligned with those of line 2 from AZI(deg) on"},
      {"thousands or decimal commas in quotes", "MD (m),Inc (deg),Azi (deg)\n0,0,0\n\"1,500\",10,45\n",
       ":3: MD (m): the comma may be a decimal comma or a thousands separator"},
  };
  for (const RefusedExport& e : exports) EXPECT_TRUE(holds(refusal(e.text), e.said)) << e.what << ": " << refusal(e.text);
}
}  // namespace drill_rig_sim::test_scene_survey_exports
