// SPDX-License-Identifier: BSD-3-Clause
// Surveys whose names are in other languages or are not known, and what the lines beside their tables say.
#include <gtest/gtest.h>

#include <string>

#include "survey_reading.h"

namespace drill_rig_sim::test_scene_survey_names
{
using namespace survey_reading;

namespace
{
const std::string rows = "0;0;0\n500;5,5;120,25\n";

// with the one remark of a table, "" where it has none
std::string remark_of(const SurveyTable& table)
{
  EXPECT_GE(1u, table.remarks.size());
  return table.remarks.empty() ? "" : table.remarks[0].substr(table.remarks[0].find("survey.txt") + 12);
}
}  // namespace

TEST(SurveyNames, AreKnownInSeveralLanguages)
{
  for (const char* names :
       {"Messtiefe [m];Neigung [°];Azimut [°]", "Gemessene Teufe (m);Neigungswinkel (°);Azimutwinkel (°)",
        "Bohrteufe m;Inklination deg;Richtung deg", "Profondeur mesurée (m);Inclinaison (degrés);Azimut (degrés)",
        "PROFONDEUR MESURÉE (m);INCLINAISON (°);AZIMUT (°)", "Prof. MD (m);Incl. (°);Azim. (°)",
        "Profundidad medida (m);Inclinación (grados);Rumbo (grados)",
        "Profundidade medida (m);Inclinação (graus);Azimute (graus)", "Målt dybde (m);Inklinasjon (grader);Asimut (grader)",
        "Malt dybde (m);Helning (grader);Retning (grader)", "Profondità misurata (m);Inclinazione (°);Azimut (°)",
        "Głębokość mierzona (m);Kąt odchylenia (°);Azymut (°)", "Глубина по стволу, м;Зенитный угол, град;Азимут, град",
        "ГЛУБИНА ПО СТВОЛУ (м);ЗЕНИТНЫЙ УГОЛ (град.);АЗИМУТ (°)", "Glubina po stvolu (m);Zenitnyj ugol (deg);Azimut (deg)",
        "Измеренная глубина [м];Зенит [градусы];Азимут истинный [градусы]", "Gemeten diepte (m);Inclinatie (°);Azimut (°)",
        "井深(m);井斜角(°);方位角(°)", "Målt dyp (m);Helning (grader);Asimut (grader)"})
  {
    const SurveyTable table = read(names + ("\n" + rows));
    ASSERT_EQ(2u, table.stations.size()) << names;
    expect_station(table.stations[1], 500.0, 5.5, 120.25);
    EXPECT_TRUE(table.remarks.empty()) << names << table.remarks.front();
  }
  const SurveyTable feet = read("Prof. medida (pies);Inclinación (grados);Azimut (grados)\n" + rows);
  expect_station(feet.stations[1], 152.4, 5.5, 120.25);
  const SurveyTable units = read("Глубина по стволу;Зенитный угол;Азимут\nм;град;град\n" + rows);
  expect_station(units.stations[1], 500.0, 5.5, 120.25);
}

TEST(SurveyNames, OfOtherMakers)
{
  for (const char* names :
       {"TMD (m);Inc'n (deg);Az_T (deg)", "MDRT (m);HDEV (deg);HDIR (deg)", "MD (mAHBRT);Zenith angle (deg);AzimT (deg)",
        "MeasuredDepth (m);Inclination (deg);AzimuthTrueNorth (deg)", "Svy MD (m);Survey Inc (deg);Survey Azi (deg)",
        "Along Hole (m);Hole Dev (deg);Azimuth (°T)"})
  {
    const SurveyTable table = read(names + ("\n" + rows));
    ASSERT_EQ(2u, table.stations.size()) << names;
    expect_station(table.stations[1], 500.0, 5.5, 120.25);
    EXPECT_TRUE(table.remarks.empty()) << names << table.remarks.front();
  }
  expect_station(read("MD (m);Inc (deg);Azi (deg);Dir;Zenith\n0;0;0;1;1\n500;5.5;120.25;2;2\n").stations[1], 500.0, 5.5, 120.25);
  for (const char* name : {"AziGN (deg)", "AzimG (deg)", "AZI_G (deg)"})
    EXPECT_TRUE(holds(remark_of(read(std::string("MD (m);Inc (deg);") + name + "\n" + rows)), "refer to grid north")) << name;
  EXPECT_EQ("\"Driller's Depth (m)\" is read as measured depth",
            remark_of(read("Driller's Depth (m);Inc (deg);Azi (deg)\n" + rows)));
  expect_station(read("Drillers Depth (ft);MD (m);Inc (deg);Azi (deg)\n0;0;0;0\n1640;500;5.5;120.25\n").stations[1], 500.0, 5.5,
                 120.25);
}

TEST(SurveyNames, TheNorthAndAWeakDepthAreReported)
{
  EXPECT_EQ("\"Teufe (m)\" is read as measured depth", remark_of(read("Teufe (m);Neigung (°);Azimut (°)\n" + rows)));
  const std::string magnetic = "azimuths refer to magnetic north and are not converted: the well's north is magnetic north";
  EXPECT_EQ(magnetic, remark_of(read("Глубина по стволу (м);Зенитный угол (°);Азимут магнитный (°)\n" + rows)));
  EXPECT_EQ(magnetic, remark_of(read("Profondeur mesurée (m);Inclinaison (°);Azimut magnétique (°)\n" + rows)));
  const std::string table = "MD (m);Inc (deg);Azi (deg)\n" + rows;
  for (const char* title : {"Azimuths: magnetic", "North reference: magnetic", "Azimuth is Magnetic, uncorrected"})
    EXPECT_EQ(magnetic, remark_of(read(title + ("\n" + table)))) << title;
  EXPECT_TRUE(read("Azimuths: true, magnetic declination 3 deg\n" + table).remarks.empty());
  EXPECT_TRUE(read("Azimuth corrected for magnetic declination\n" + table).remarks.empty());
}

TEST(SurveyNames, AmbiguousUnitsAreRefusedWithTheirChoices)
{
  EXPECT_TRUE(holds(refusal("Messtiefe (m);Neigung [Grad];Azimut [Grad]\n" + rows),
                    ":1: Neigung [Grad]: the unit in brackets is ambiguous, allowed: gon or deg"));
  EXPECT_TRUE(holds(refusal("Messtiefe;Neigung;Azimut\nm;Grad;Grad\n" + rows),
                    ":2: Neigung: unit \"Grad\" is ambiguous, allowed: gon or deg"));
  SurveyFormat format;
  format.inclination = {"Neigung [Grad]", "deg"};
  format.azimuth = {"Azimut [Grad]", "deg"};
  expect_station(read("Messtiefe (m);Neigung [Grad];Azimut [Grad]\n" + rows, format).stations[1], 500.0, 5.5, 120.25);
}

// The names of a table that are not known are listed; a line of any other file is not.
TEST(SurveyNames, UnknownOnesAreListed)
{
  EXPECT_TRUE(holds(refusal("Lengte A;Hoek;Koers\n" + rows),
                    ":1: no line names measured depth, inclination and azimuth; "
                    "it has Lengte A, Hoek, Koers (delimiter ;)"));
  EXPECT_TRUE(holds(refusal("of well A-1\nA1 B2 C3\nm deg deg\n0 0 0\n500 5.5 120.25\n"), ":2: no line names measured depth"));
  const std::string other = refusal("root:x:0:0:secret:/root\nsecret,words,of another,kind\nmore,of,these,5\n");
  EXPECT_TRUE(holds(other, "no line names measured depth, inclination and azimuth; needed")) << other;
}

TEST(SurveyTitles, AUnitOfDepthAboveTheNamesIsTakenAndReported)
{
  const std::string table = "MD,INC,AZI\n0,0,0\n1000,5.5,120.25\n";
  for (const char* title : {"Well A-1, all depths in feet", "Depth Units: ft   Angle Units: deg", "Units: feet",
                            "# XYZ-UNITS: m, MD-UNITS: ft", "Measured depths are given in FEET"})
  {
    const SurveyTable found = read(title + ("\n" + table));
    expect_station(found.stations[1], 304.8, 5.5, 120.25);
    ASSERT_EQ(2u, found.remarks.size()) << title;
    EXPECT_TRUE(holds(found.remarks[0], "line 1 says that depths are in ft: they are read so")) << found.remarks[0];
  }
  EXPECT_TRUE(holds(refusal("Depths in fathoms\n" + table), "MD: the header gives no unit"));
  EXPECT_TRUE(holds(refusal("Changed in May\nRKB elevation: 54 ft\n" + table), "MD: the header gives no unit"));
}

TEST(SurveyTitles, AnotherUnitThanTheNamesHaveIsReported)
{
  const std::string table = "MD (m),INC (deg),AZI (deg)\n0,0,0\n1000,5.5,120.25\n";
  const SurveyTable found = read("All depths in feet\n" + table);
  expect_station(found.stations[1], 1000.0, 5.5, 120.25);
  EXPECT_EQ("line 1 says that depths are in ft, the names of the columns say m: they are read in m; is that right?",
            remark_of(found));
  EXPECT_TRUE(read("All depths in metres\nMD Reference: RKB @ 54.00usft\n" + table).remarks.empty());
  EXPECT_TRUE(read("Depth Units: usft\nMD (ft),INC (deg),AZI (deg)\n0,0,0\n1000,5.5,120.25\n").remarks.empty())
      << "2 in a million";
}

TEST(SurveyTitles, OneWellInAFile)
{
  const std::string head = "MD (m),Inc (deg),Azi (deg)\n", table = head + "0,0,0\n500,5.5,120.25\n";
  EXPECT_TRUE(holds(refusal("Well: A-1\n" + table + "Well: B-2\n" + head + "600,5,120\n700,5,120\n"),
                    ":5: is of B-2, the lines above of A-1, needed: one well in a file"));
  EXPECT_TRUE(holds(refusal("# WELL NAME: A-1\n" + table + "# WELL NAME: B-2\n600,5,120\n"), "is of B-2"));
  EXPECT_EQ("accepted", refusal("Well: A-1   Rig: 7\n" + table + "Well: a-1   Page 2\n" + head + "600,5,120\n"));
  EXPECT_TRUE(holds(refusal("Hole,MD (m),Inc (deg),Azi (deg)\nA,0,0,0\nA,500,5,120\nB,600,5,120\n"),
                    ":4: Hole: is B, in the rows above A"));
  EXPECT_EQ("accepted", refusal("Hole,MD (m),Inc (deg),Azi (deg)\n17.5,0,0,0\n12.25,500,5,120\n")) << "a diameter";
}

// Lines of signs between names, units and rows are no rows.
TEST(SurveyTitles, RulesArePassedOver)
{
  const SurveyTable found = read(
      "  MD      Incl     Azim\n (ft)    (deg)    (deg)\n-------------------------\n   0.00    0.00     0.00\n1000.00    5.50   "
      "120.25\n"
      "=========================\n2000.00    5.50   120.25\n");
  ASSERT_EQ(3u, found.stations.size());
  expect_station(found.stations[1], 304.8, 5.5, 120.25);
  EXPECT_TRUE(found.remarks.empty());
  EXPECT_TRUE(holds(refusal("MD (m),Inc (deg),Azi (deg)\n0,0,0\n-,-,-\n500,5,40\n"), ":3: MD (m): has no value"))
      << "cells without a value";
  EXPECT_TRUE(holds(refusal("MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,5,---\n"), ":3: Azi (deg): has no value"));
}

// The answer of a server to a request for a trajectory holds it as a text.
TEST(SurveyTitles, TheAnswerOfAServer)
{
  const std::string station =
      "&lt;trajectoryStation&gt;&lt;md uom=\"ft\"&gt;%&lt;/md&gt;&lt;incl uom=\"dega\"&gt;5.5&lt;/incl&gt;&lt;azi "
      "uom=\"dega\"&gt;40&lt;/azi&gt;"
      "&lt;/trajectoryStation&gt;";
  const auto at = [&](const char* md)
  { return station.substr(0, station.find('%')) + md + station.substr(station.find('%') + 1); };
  const SurveyTable found = read(
      "<?xml version=\"1.0\"?><s:Envelope "
      "xmlns:s=\"http://schemas.xmlsoap.org/soap/envelope/\"><s:Body><r><Result>1</Result><XMLout>"
      "&lt;trajectorys version=\"1.4.1.1\"&gt;&lt;trajectory&gt;" +
      at("0") + at("1000") + "&lt;/trajectory&gt;&lt;/trajectorys&gt;</XMLout></r></s:Body></s:Envelope>\n");
  ASSERT_EQ(2u, found.stations.size());
  expect_station(found.stations[1], 304.8, 5.5, 40.0);
}

TEST(SurveyTitles, AnotherHeaderBetweenTheRowsIsRefused)
{
  const std::string table = "MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,5.5,120.25\n";
  for (const char* head : {"MD (ft),Inc (deg),Azi (deg)\n", "MD (m),Azi (deg),Inc (deg)\n"})
    EXPECT_TRUE(
        holds(refusal(table + head + "2000,5,120\n"),
              ":4: names the columns anew with other names or units than line 1, needed: one header, or a file for each part"));
}

// A page's head that names the design again is no other path.
TEST(SurveyTitles, TheHeadOfAPageMayNameThePathAgain)
{
  const std::string head = "Wellbore: A-1\nDesign: Actual\nMD (m),Inc (deg),Azi (deg)\n";
  const SurveyTable pages = read(head + "0,0,0\n500,5.5,120.25\nPage 2\n" + head + "600,5,120\n");
  EXPECT_EQ(3u, pages.stations.size());
  EXPECT_TRUE(holds(refusal(head + "0,0,0\n500,5.5,120.25\nPlan\nMD (m),Inc (deg),Azi (deg)\n600,5,120\n"),
                    "\"Plan\" stands between stations"));
}

// Azimuths above 360 deg are one line with their count.
TEST(SurveyTitles, OneLineForTheSameProblem)
{
  EXPECT_TRUE(holds(refusal("MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,5,365\n600,5,370\n700,5,372\n"),
                    ":3: station 2: azimuth 365 deg is out of range, allowed: -360 to 360 deg (and 2 further stations)"));
}
}  // namespace drill_rig_sim::test_scene_survey_names
