// SPDX-License-Identifier: BSD-3-Clause
// Surveys as the trade writes them: names, units, delimiters and WITSML come out as the same stations; what may mean two things
// is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/survey_file.h"
#include "survey_reading.h"
#include "temporary_folder.h"

namespace drill_rig_sim::test_scene_survey
{
using namespace survey_reading;

namespace
{
constexpr double foot = 0.3048;

struct Spelled
{
  const char* header;
  double length;  // of its unit [m]
};

TEST(SceneSurvey, UsualNamesWithTheirUnits)
{
  for (const Spelled& s : {Spelled{"MD (ft),Inclination (deg),Azimuth (deg)", foot},
                           {"md_ft,inc_deg,azi_deg", foot},
                           {"Measured Depth [m],Incl. [deg],Azim. [deg]", 1.0},
                           {"MD (mRKB);Incl (\xc2\xb0);Az (\xc2\xb0)", 1.0},
                           {"MDepth m\tInclin deg\tAZM deg", 1.0},
                           {"M.D. (feet),INC (degrees),AZI (degrees)", foot},
                           {"Survey Depth (ftUS),Drift Angle (deg),Direction (deg)", 1200.0 / 3937.0},
                           {"MD(m) Inc(deg) Azi(deg)", 1.0},
                           {"\"MD, ft\",\"Inc, deg\",\"Azimuth True, deg\"", foot},
                           {"\"MD\" (m);Inc\xc2\xb0;Azi\xc2\xb0", 1.0},
                           {"MD RKB (m),Inc (deg),Azi (deg)", 1.0}})
  {
    SCOPED_TRACE(s.header);
    const std::string header = s.header;
    const char delimiter = holds(header, ";") ? ';' : holds(header, "\t") ? '\t' : holds(header, ",") ? ',' : ' ';
    std::string rows = "\n0,0,0\n100.5,2.5,300\n";
    for (char& c : rows) c = c == ',' ? delimiter : c;
    const SurveyTable table = read(header + rows);
    ASSERT_EQ(2u, table.stations.size());
    expect_station(table.stations[1], 100.5 * s.length, 2.5, 300.0);
    EXPECT_TRUE(table.remarks.empty());
  }
}

TEST(SceneSurvey, RadiansAndGons)
{
  const SurveyTable table = read("MD (m),Inc (rad),Azi (gon)\n0,0,0\n100,0.5,100\n");
  EXPECT_NEAR(0.5, table.stations[1].inclination, 1e-12);
  EXPECT_NEAR(0.5 * pi, table.stations[1].azimuth, 1e-12);
}

TEST(SceneSurvey, UnitsBelowTheHeaderAndLinesAboveIt)
{
  const SurveyTable table =
      read("Well: A-7\nRig: North Star\n\nMD,Inc,Azi,DLS\n(ft),(deg),(deg),(deg/100ft)\n0,0,0,0\n1000,3,40,0.3\n,,,\n");
  ASSERT_EQ(2u, table.stations.size());
  expect_station(table.stations[1], 1000.0 * foot, 3.0, 40.0);
  expect_station(read("Company: X\n\n   MD    Inc    Azi    TVD\n (usft)  (\xc2\xb0)    (\xc2\xb0)  (usft)\n  0.0   0.0   0.0   "
                      "0.0\n 3937.0  2.5  45.0  3936.5\n")
                     .stations[1],
                 1200.0, 2.5, 45.0);
}

TEST(SceneSurvey, DepthsWithoutAUnitAreRefused)
{
  const std::string euro = "MD;Inc;Azi\n0,0;0,0;0,0\n500,0;2,1;45,3\n";
  const std::string problem = refusal(euro);
  EXPECT_EQ(0u, problem.rfind(":1: MD: the header gives no unit", 0)) << problem;
  EXPECT_TRUE(holds(problem, "columns: {md: {unit: m}}") && holds(problem, "or --columns MAP.yaml")) << problem;
  SurveyFormat format;
  format.md.unit = "ft";
  const SurveyTable table = read(euro, format);
  expect_station(table.stations[1], 500.0 * foot, 2.1, 45.3);
  ASSERT_EQ(1u, table.remarks.size());
  EXPECT_TRUE(holds(table.remarks[0], "\"Inc\" and \"Azi\" have no unit and are read as degrees")) << table.remarks[0];
}

TEST(SceneSurvey, AnglesThatMayBeRadiansAreRefused)
{
  EXPECT_TRUE(holds(refusal("MD (m),Inc,Azi\n0,0,0\n100,0.02,1.5\n"), ":1: Inc: the header gives no unit"));
  EXPECT_EQ("accepted", refusal("MD (m),Inc,Azi\n0,0,0\n100,0,0\n")) << "no angle";
  EXPECT_EQ("accepted", refusal("MD (m),Inc (deg),Azi\n0,0,0\n100,0.02,1.5\n")) << "the other says it";
}

TEST(SceneSurvey, WhatMayBeTwoThingsIsRefused)
{
  EXPECT_TRUE(holds(refusal("MD (m),MD (ft),Inc (deg),Azi (deg)\n0,0,0,0\n"), "several columns fit: \"MD (m)\", \"MD (ft)\""));
  EXPECT_TRUE(holds(refusal("MD (m),Inc (deg),Azi True (deg),Azi Grid (deg)\n0,0,0,0\n"),
                    "several columns fit: \"Azi True (deg)\", \"Azi Grid (deg)\""));
  SurveyFormat format;
  format.md.unit = "m";
  EXPECT_TRUE(holds(refusal("MD (ft),Inc (deg),Azi (deg)\n0,0,0\n9,0,0\n", format),
                    "MD (ft): the unit is ft in the header and m in the map"));
  EXPECT_TRUE(holds(refusal("MD (m),Inc (grad),Azi (deg)\n0,0,0\n"),
                    ":1: Inc (grad): the unit in brackets is ambiguous, allowed: gon or deg"))
      << "degrees in German, gons in English";
  // thousands or decimals
  EXPECT_TRUE(holds(refusal("MD (ft);Inc (deg);Azi (deg)\n0;0;0\n1,000;2;40\n2,000;3;41\n"), ":3: MD (ft): the comma may be"));
  EXPECT_TRUE(holds(refusal("MD (m);Inc (deg);Azi (deg)\n0;0;0\n1.000;2,5;40\n"), "decimal commas and decimal points"));
  EXPECT_EQ("accepted", refusal("MD (m);Inc (deg);Azi (deg)\n0;0;0\n1,000;2,100;40,000\n")) << "no angle is two thousand";
  expect_station(read("MD (m),Inc (deg),Azi (deg)\n0,0,0\n\"1,000.50\",2,40\n").stations[1], 1000.5, 2.0, 40.0);
  for (const char* cell : {"1,00.5", "1,0000.5", ",000.5", "1,000.5,0"})
    EXPECT_TRUE(
        holds(refusal("MD (m),Inc (deg),Azi (deg)\n0,0,0\n\"" + std::string(cell) + "\",2,40\n"), "must be a finite number"))
        << cell;
  EXPECT_TRUE(holds(refusal("MD (ft),Inc (deg),Azi (deg)\n0,0,0\n\"1,000\",2,40\n"),
                    ":3: MD (ft): the comma may be a decimal comma or a thousands separator"));
}

TEST(SceneSurvey, AMapNamesColumns)
{
  SurveyFormat format;
  format.md = {"Tiefe", "m"};
  format.inclination.column = "neigung";
  format.azimuth = {"Azi Grid", ""};
  format.delimiter = ";";
  const SurveyTable table = read("Tiefe;Neigung;Azi Grid;Azi True\n0;0;0;0\n100;5,5;200,5;201\n", format);
  expect_station(table.stations[1], 100.0, 5.5, 200.5);
  ASSERT_EQ(2u, table.remarks.size()) << "the map says that Tiefe is measured depth";
  EXPECT_TRUE(holds(table.remarks[0], "refer to grid north"));
  format.md.column = "Depth";
  EXPECT_TRUE(holds(refusal("Tiefe;Neigung;Azi Grid\n0;0;0\n", format),
                    ":1: Depth: no such column in the header; it has Tiefe, Neigung, Azi Grid"));
}

TEST(SceneSurvey, AColumnOfAMapHasTheUnitOfItsBrackets)
{
  const std::string text = "Profondeur (ft);Inclinaison (rad);Azimut (deg)\n0;0;0\n1000;0,1;45\n";
  SurveyFormat format;
  format.md.column = "profondeur (ft)";
  format.inclination.column = "Inclinaison (rad)";
  expect_station(read(text, format).stations[1], 1000.0 * foot, 0.1 / degree, 45.0);
  format.md.column = "Profondeur";
  format.inclination.column = "inclinaison";
  expect_station(read(text, format).stations[1], 1000.0 * foot, 0.1 / degree, 45.0);
  format.md.unit = "m";
  EXPECT_TRUE(holds(refusal(text, format), "Profondeur (ft): the unit is ft in the header and m in the map"));
  format.md.column =
      "Profondeur mesur\xc3\xa9"
      "e";
  EXPECT_TRUE(holds(refusal(text, format),
                    ":1: Profondeur mesur\xc3\xa9"
                    "e: no such column"))
      << "letters are shown as they are";
  format.md.column = "Profondeur \xe0\x83\xa9";
  EXPECT_TRUE(holds(refusal(text, format), ":1: Profondeur ???: no such column")) << "an overlong form";
  format.md.column = "Profondeur \xc3\x28\x1b";
  EXPECT_TRUE(holds(refusal(text, format), ":1: Profondeur ?(?: no such column")) << "what is no letter is not";
}

TEST(SceneSurvey, DepthAloneIsMeasuredDepth)
{
  const SurveyTable table = read("Depth (m),Inc (deg),Azi (deg)\n0,0,0\n100,5,1\n");
  ASSERT_EQ(1u, table.remarks.size());
  EXPECT_TRUE(holds(table.remarks[0], "\"Depth (m)\" is read as measured depth"));
  EXPECT_NEAR(90.0, read("Depth (m),MD (m),Inc (deg),Azi (deg)\n0,0,0,0\n80,90,5,1\n").stations[1].md, 1e-9);
}

TEST(SceneSurvey, ALineAboveTheHeaderMayNameTheNorth)
{
  const char* rows = "MD (ft),Inc (deg),Azi (deg)\n0,0,0\n1000,2,30\n";
  for (const char* line : {"# North reference: Grid North", "North: Magnetic", "Survey Tool: MWD+IFR;Ref: Grid North;;;",
                           "Azimuths,North Reference,Grid"})
    EXPECT_TRUE(holds(read(std::string(line) + "\n" + rows).remarks.at(0), "north")) << line;
  for (const char* line : {"# North reference: True North", "Rig: North Star", "Grid convergence to North: 1.2",
                           "Location: MN, North Star", "Magnetic declination, North: 3"})
    EXPECT_TRUE(read(std::string(line) + "\n" + rows).remarks.empty()) << line;
  EXPECT_TRUE(holds(read("Meas. Depth;Drift Angle;Hole Direction\n[ft RKB];[deg];[deg grid]\n0;0;0\n1000;2;30\n").remarks.at(0),
                    "grid north"));
}

TEST(SceneSurvey, ALineOfUnitsMayHaveWordsBesideThem)
{
  EXPECT_NEAR(1000.0 * foot, read("Depth;Inc;Azi\nft RKB;decimal degrees;dec deg\n0;0;0\n1000;2;30\n").stations[1].md, 1e-9);
  EXPECT_TRUE(holds(refusal("Depth;Inc;Azi\nft;deg;sixtieths\n0;0;0\n1000;2;30\n"), ":2: Azi: unit \"sixtieths\" is not known"));
  EXPECT_TRUE(holds(refusal("Depth;Inc;Azi\nfathoms;deg;deg\n0;0;0\n1000;2;30\n"), ":2: Depth: unit \"fathoms\" is not known"));
}

TEST(SceneSurvey, TheTieInHasUnitsToo)
{
  const SurveyTable table = read("MD (ft),Inc (deg),Azi (deg),N/S (ft),+E/-W (ft),TVD (ft)\n100,1,90,-3,2,99\n200,1,90,,,\n");
  ASSERT_TRUE(table.tie_in.has_value());
  EXPECT_NEAR(-3.0 * foot, table.tie_in->north, 1e-12);
  EXPECT_NEAR(2.0 * foot, table.tie_in->east, 1e-12);
  EXPECT_NEAR(99.0 * foot, table.tie_in->tvd, 1e-12);
  EXPECT_TRUE(holds(refusal("MD (ft),Inc (deg),Azi (deg),N/S,E/W,TVD\n100,1,90,-3,2,99\n200,1,90,,,\n"),
                    ":2: N/S: the header gives no unit"));
}

TEST(SceneSurvey, TheFirstBadCellIsShown)
{
  const std::string problem = refusal("MD (m),Inc (deg),Azi (deg)\n0,0,0\n100,5..5,1\n200,x,1\n");
  EXPECT_EQ(0u, problem.rfind(":3: Inc (deg): must be a finite number (got \"5..5\"); the header was read as md \"MD (m)\" [m], "
                              "inclination \"Inc (deg)\" [deg]",
                              0))
      << problem;
  EXPECT_TRUE(holds(refusal("md_m,inclination_deg,azimuth_deg\n0,0,0\n9,nan,0\n"), "(got \"nan\")"));
  EXPECT_TRUE(holds(refusal("md_m,inclination_deg,azimuth_deg\n0,0,0\n9,0,inf\n"), "(got \"inf\")"));
  EXPECT_TRUE(holds(refusal("md_m,inclination_deg,azimuth_deg\n0,0,0\n9,secret,0\n"), "(got text)"));
  EXPECT_TRUE(holds(refusal("md_ft,inclination_deg,azimuth_deg\n0,0,0\n328,1,0\n300,1,0\n"),
                    "md 300 ft is not deeper than the station before it, 328 ft"))
      << "in the file's unit";
}

TEST(SceneSurvey, PassedOverOnRequestOnly)
{
  SurveyFormat format;
  format.pass_over = 1.0;
  const std::string header = "md_m,inclination_deg,azimuth_deg\n";
  const std::string twice = header + "0,0,0\n1000,10,40\n1000,10,40\n1030,11,41\n",
                    vertical = header + "0,0,\n100,0,\n200,1.5,40\n",
                    nulls = header + "0,0,0\n100,-999.25,-999.25\n200,1.5,40\n300,3,-999.25\n400,-9999,\n";
  for (const std::string& text : {twice, vertical, nulls}) EXPECT_TRUE(holds(refusal(text), "--pass-over")) << refusal(text);
  const SurveyTable once = read(twice, format), upright = read(vertical, format), whole = read(nulls, format);
  ASSERT_EQ(3u, once.stations.size());
  expect_station(once.stations[2], 1030.0, 11.0, 41.0);
  EXPECT_TRUE(holds(once.remarks.at(0), "equal to the one before were skipped: line 4"));
  ASSERT_EQ(3u, upright.stations.size());
  EXPECT_TRUE(holds(upright.remarks.at(0), "without an azimuth were given 0 deg: lines 2, 3"));
  ASSERT_EQ(2u, whole.stations.size());
  EXPECT_TRUE(holds(whole.remarks.at(0), "without a value were skipped: lines 3, 5, 6"));
  // what contradicts itself, or is no number, is refused all the same
  EXPECT_TRUE(holds(refusal(header + "0,0,0\n100,1,40\n100,2,40\n", format), "is not deeper than"));
  for (const char* word : {"nan", "inf", "-nan"})
    EXPECT_TRUE(holds(refusal(header + "0,0,0\n100," + word + ",40\n", format), "must be a finite number"));
}

std::string trajectory(const std::string& inside)
{
  return "<?xml version=\"1.0\"?>\n<trajectorys xmlns=\"http://www.witsml.org/schemas/1series\">\n<trajectory><name>T1</name>" +
         inside + "</trajectory>\n</trajectorys>\n";
}

std::string station(const std::string& md, const std::string& incl, const std::string& azi, const std::string& unit = "ft")
{
  return "<trajectoryStation><md uom=\"" + unit + "\">" + md + "</md><incl uom=\"dega\">" + incl + "</incl><azi uom=\"dega\">" +
         azi + "</azi></trajectoryStation>\n";
}

TEST(SceneSurvey, WitsmlInAnyOrder)
{
  const SurveyTable table =
      read(trajectory(station("1000", "3", "40") + station("0", "0", "0") + station("600", "4", "50", "m")));
  ASSERT_EQ(3u, table.stations.size());
  expect_station(table.stations[1], 1000.0 * foot, 3.0, 40.0);
  expect_station(table.stations[2], 600.0, 4.0, 50.0);
  ASSERT_EQ(1u, table.remarks.size());
  EXPECT_TRUE(holds(table.remarks[0], "were sorted by depth; the first one out of order: md 0"));
  EXPECT_TRUE(read(trajectory(station("2000", "4", "50") + station("1000", "3", "40") + station("0", "0", "0"))).remarks.empty())
      << "from the bottom up";
  const std::string grid = trajectory("<aziRef>grid north</aziRef>" + station("0", "0", "0") + station("1000", "3", "40"));
  EXPECT_TRUE(holds(read(grid).remarks.at(0), "refer to grid north"));
}

TEST(SceneSurvey, WitsmlWithAPrefixAndATieIn)
{
  const SurveyTable table = read(
      "<w:trajectory xmlns:w=\"x\"><w:trajectoryStation><w:md uom=\"m\">100</w:md><w:tvd uom=\"m\">99</w:tvd><w:incl "
      "uom=\"rad\">0.01</w:incl><w:azi uom=\"dega\">90"
      "</w:azi><w:dispNs uom=\"m\">1</w:dispNs><w:dispEw "
      "uom=\"ft\">-2</w:dispEw></w:trajectoryStation><w:trajectoryStation><w:md uom=\"m\">200</w:md>"
      "<w:incl uom=\"rad\">0.02</w:incl><w:azi uom=\"dega\">90</w:azi></w:trajectoryStation></w:trajectory>");
  ASSERT_TRUE(table.tie_in.has_value());
  EXPECT_NEAR(-2.0 * foot, table.tie_in->east, 1e-12);
  EXPECT_NEAR(0.02, table.stations[1].inclination, 1e-12);
}

TEST(SceneSurvey, WitsmlOfVersion2)
{
  const SurveyTable table = read(
      "<Trajectory xmlns=\"http://www.energistics.org/energyml/data/witsmlv2\" schemaVersion=\"2.0\"><MDMn uom=\"m\">0</MDMn>"
      "<TrajectoryStation><MD uom=\"ft[US]\">3937</MD><Incl uom=\"dega\">3</Incl><Azi uom=\"gon\">50</Azi></TrajectoryStation>"
      "<TrajectoryStation><MD uom=\"m\">0</MD><Incl uom=\"dega\">0</Incl><Azi "
      "uom=\"dega\">0</Azi></TrajectoryStation></Trajectory>");
  ASSERT_EQ(2u, table.stations.size());
  expect_station(table.stations[1], 1200.0, 3.0, 45.0);
}

TEST(SceneSurvey, NamesOverSeveralLines)
{
  for (const char* text :
       {"Measured,Incl.,Azim.\nDepth,,\n(m),(deg),(deg)\n0,0,0\n600,4,50\n",
        "Well A-1\n,Hole,Hole\nMD,Inclination,Azimuth\nm,deg,deg\n0,0,0\n600,4,50\n",
        "No.;Measured;Inclination;Azimuth;TVD\n;Depth;Angle;True;\n;m;deg;deg;m\n1;0;0,0;0,0;0\n2;600;4,0;50,0;599\n",
        "Measured\tHole\tHole\nDepth\tInclination\tAzimuth\n(ft)\t(deg)\t(deg)\n0\t0\t0\n1968.503937\t4\t50\n"})
  {
    const SurveyTable table = read(text);
    ASSERT_EQ(2u, table.stations.size()) << text;
    EXPECT_NEAR(600.0, table.stations[1].md, 1e-6) << text;
    EXPECT_NEAR(4.0 * degree, table.stations[1].inclination, 1e-12) << text;
    EXPECT_NEAR(50.0 * degree, table.stations[1].azimuth, 1e-12) << text;
  }
}

TEST(SceneSurvey, TheLineAboveSaysWhichDepthItIs)
{
  const std::string rows = "m,deg,deg\n0,0,0\n600,4,50\n";
  EXPECT_TRUE(read("Measured,,\nDepth,Inc,Azi\n" + rows).remarks.empty());
  EXPECT_TRUE(holds(read("Depth,Inc,Azi\n" + rows).remarks.at(0), "\"Depth\" is read as measured depth"));
  EXPECT_TRUE(holds(read("Rig 7,,\nDepth,Inc,Azi\n" + rows).remarks.at(0), "\"Depth\" is read as measured depth"));
  EXPECT_TRUE(holds(refusal("True Vertical,,\nDepth,Inc,Azi\n" + rows),
                    "md_m: no such column in the header; it has True Vertical Depth, Inc, Azi"));
}

TEST(SceneSurvey, WhatStandsInBracketsIsAUnit)
{
  EXPECT_TRUE(
      holds(refusal("MD (m) (ft),Inc (deg),Azi (deg)\n0,0,0\n9,0,0\n"), ":1: MD (m) (ft): the unit in brackets is not known"));
  EXPECT_TRUE(holds(refusal("MD (m),Inc (deg) (rad),Azi (deg)\n0,0,0\n9,0,0\n"),
                    ":1: Inc (deg) (rad): the unit in brackets is not known"));
  EXPECT_TRUE(holds(refusal("MD (m),Inc (%),Azi (deg)\n0,0,0\n9,0,0\n"), ":1: Inc (%): the unit in brackets is not known"));
  EXPECT_EQ("accepted", refusal("MD (m) (metres),Inc (deg),Azi (deg)\n0,0,0\n9,0,0\n"));
}

TEST(SceneSurvey, WitsmlThatIsRefused)
{
  const std::string two =
      "<trajectorys><trajectory><name>plan</name></trajectory>\n<trajectory><name>as drilled</name></trajectory></trajectorys>";
  EXPECT_TRUE(holds(refusal(two), "2 trajectories (plan, as drilled), allowed: one")) << refusal(two);
  EXPECT_TRUE(holds(refusal("<logs><log/></logs>"), "has no trajectory"));
  EXPECT_TRUE(holds(refusal("<trajectorys><trajectory>"), "is not an XML document"));
  EXPECT_TRUE(holds(refusal(trajectory("")), "has no stations"));
  EXPECT_TRUE(holds(refusal(trajectory(station("0", "0", "0", "fathom"))),
                    ":3: md: unit \"fathom\" is not known, allowed: m, mm, cm, km, ft, in, ftUS"));
  EXPECT_TRUE(holds(refusal(trajectory("<trajectoryStation><md>0</md></trajectoryStation>")), "md: has no unit"));
  EXPECT_TRUE(
      holds(refusal(trajectory(station("0", "0", "0") + station("9", "x", "0"))), "incl: must be a finite number (got text)"));
  EXPECT_TRUE(holds(refusal(trajectory("<!-- =" + std::string(2100000, '<') + " -->")), "more than 2000000 elements"));
  SurveyFormat format;
  format.md.unit = "m";
  EXPECT_TRUE(holds(refusal(trajectory(station("0", "0", "0")), format), "has no effect on a WITSML trajectory"));
}

// A document cannot define entities that grow.
TEST(SceneSurvey, WitsmlExpandsNoEntities)
{
  const std::string bomb = "<?xml version=\"1.0\"?><!DOCTYPE t [<!ENTITY a \"1000\"><!ENTITY b \"&a;&a;&a;\">]>";
  EXPECT_TRUE(holds(refusal(bomb + "<trajectory>" + station("0", "0", "0") + station("&b;", "0", "0") + "</trajectory>"),
                    "md: must be a finite number (got text)"));
}

TEST(SceneSurvey, RejectedStationsAreLeftOut)
{
  const std::string bad =
      "<trajectoryStation><md uom=\"ft\">500</md><incl uom=\"dega\">90</incl><azi "
      "uom=\"dega\">0</azi><statusTrajStation>rejected</statusTrajStation></trajectoryStation>";
  const SurveyTable table = read(trajectory(station("0", "0", "0") + bad + station("1000", "3", "40")));
  EXPECT_EQ(2u, table.stations.size());
  EXPECT_TRUE(holds(table.remarks.at(0), "`rejected` were left out: 1"));
}

TEST(SceneSurvey, AMapFile)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("map.yaml");
  std::ofstream(file) << "columns: {md: {column: MD, unit: ft}, inclination: {column: I}, azimuth: {unit: deg}, north: {column: "
                         "N}, east: {column: E}, tvd: {unit: m}}\ndelimiter: \"\\t\"\npass_over: true\n";
  const SurveyFormat format = read_survey_format(file);
  EXPECT_EQ("MD", format.md.column);
  EXPECT_EQ("ft", format.md.unit);
  EXPECT_EQ("I", format.inclination.column);
  EXPECT_EQ("deg", format.azimuth.unit);
  EXPECT_EQ("N", format.north.column);
  EXPECT_EQ("E", format.east.column);
  EXPECT_EQ("m", format.tvd.unit);
  EXPECT_EQ("tab", format.delimiter);
  EXPECT_EQ(1.0, format.pass_over);
  for (const auto& [text, problem] :
       {std::pair<const char*, const char*>{"file: x.csv", ":1: file: unknown key"},
        {"columns: {md: {unit: fathom}}", ":1: columns.md.unit: \"fathom\" is not known, allowed: m, mm, cm, km, ft, in, ftUS"},
        {"delimiter: \"!\"", "delimiter: \"!\" is not known, allowed: \",\", \";\", bar, tab or space"},
        {"columns: {inclination: {unit: ft}}", "allowed: rad, deg, rev, gon"}})
  {
    std::ofstream(file) << text;
    try
    {
      read_survey_format(file);
      ADD_FAILURE() << text;
    }
    catch (const SceneError& error)
    {
      EXPECT_TRUE(holds(error.what(), problem)) << error.what();
    }
  }
}
}  // namespace
}  // namespace drill_rig_sim::test_scene_survey
