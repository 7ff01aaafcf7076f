// SPDX-License-Identifier: BSD-3-Clause
// Good scenes: every key lands in its field in SI units, keys left out take the defaults, the reference lists every key.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/survey_file.h"
#include "drill_rig_sim/sim/integrator_table.h"
#include "in_source.h"
#include "temporary_folder.h"

namespace drill_rig_sim::test_scene_read
{
namespace
{
constexpr const char* smallest = R"(
name: smallest
well:
  stations: [[0, 0, 0], [50, 0, 0]]
  sections: [{to: 50, diameter: 0.3, friction: 0.2}]
formation: [{to_tvd: 100, drillability: 1e-8}]
string:
  - {name: bit, type: bit, length: 0.3, mass: 50, diameter: 0.25}
  - {name: pipe, type: pipe, joints: fill, joint_length: 9.5, outer_diameter: 0.127, inner_diameter: 0.1086, linear_mass: 31.9}
start: {}
)";

TEST(SceneRead, BohaiHoldsWhatItsFileSays)
{
  const Scene scene = read_scene(in_source("config/scenes/bohai.yaml"));
  EXPECT_EQ(scene.name, "bohai_compound");
  EXPECT_DOUBLE_EQ(scene.well.hole_depth, 730.0);
  ASSERT_EQ(scene.well.sections.size(), 2u);
  EXPECT_DOUBLE_EQ(scene.well.sections[1].friction, 0.28);
  EXPECT_DOUBLE_EQ(scene.formation.at(0).drillability, 8.6e-9);

  ASSERT_EQ(scene.string.size(), 7u);
  const PartSpec& bit = scene.string[0];
  EXPECT_EQ(bit.type, PartType::bit);
  EXPECT_DOUBLE_EQ(bit.bit->torque.speed, 30.0 * rpm);
  EXPECT_DOUBLE_EQ(bit.bit->bottom.stiffness, 1e9);
  const PartSpec& motor = scene.string[1];
  EXPECT_DOUBLE_EQ(motor.motor->bend, 1.25 * degree);
  EXPECT_DOUBLE_EQ(motor.motor->bit_to_bend, 2.0);
  const PartSpec& hwdp = scene.string[5];
  EXPECT_EQ(hwdp.joints, 14);
  EXPECT_DOUBLE_EQ(hwdp.length, 14 * 9.3);
  EXPECT_EQ(scene.string[6].joints, 0) << "fill";

  EXPECT_DOUBLE_EQ(scene.rig.top_drive.max_speed, 220.0 * rpm);
  EXPECT_DOUBLE_EQ(scene.instruments.mwd.inclination_resolution, 0.1 * degree);
  EXPECT_EQ(scene.connections, Connections::off);
  ASSERT_EQ(scene.program.size(), 3u);
  EXPECT_DOUBLE_EQ(scene.program[0].top_drive_speed, 53.0 * rpm);
  EXPECT_TRUE(std::isnan(scene.program[0].block_velocity)) << "not set by this line";
  EXPECT_DOUBLE_EQ(scene.program[2].block_velocity, -0.00908);
}

TEST(SceneRead, BohaiSurveyBuildsThreeDegreesPerThirtyMetres)
{
  const auto survey = read_survey_file(in_source("config/surveys/bohai.csv")).stations;
  EXPECT_DOUBLE_EQ(survey.front().md, 0.0);
  EXPECT_DOUBLE_EQ(survey.back().md, 730.0);
  for (const SurveyStation& s : survey)
  {
    EXPECT_NEAR(s.inclination / degree, std::min(51.0, std::max(0.0, (s.md - 200.0) * 0.1)), 1e-12) << s.md;
    EXPECT_NEAR(s.azimuth, 297.0 * degree, 1e-12);
  }
}

TEST(SceneRead, ShippedAndTestScenesAreGood)
{
  for (const char* file : {"config/scenes/quick.yaml", "test/scenes/vertical_frictionless.yaml",
                           "test/scenes/inclined_straight_20deg.yaml", "test/scenes/curved_well.yaml"})
  {
    EXPECT_NO_THROW(read_scene(in_source(file))) << file;
  }
}

// 18 joints of slim pipe are too few for 190 m between the wide pipe and the deepest bit, 21 are enough.
TEST(SceneRead, PipeThatStaysAboveASlimHoleMayBeWider)
{
  std::ifstream file(in_source("test/bad_scenes/pipe_too_wide_for_the_liner.yaml"));
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_THROW(parse_scene(text, "wide.yaml"), SceneError);
  const std::string few = "joints: 18";
  text.replace(text.find(few), few.size(), "joints: 21");
  EXPECT_NO_THROW(parse_scene(text, "wide.yaml"));
}

TEST(SceneRead, KeysLeftOutTakeTheDefaults)
{
  const Scene scene = parse_scene(smallest, "smallest.yaml");
  EXPECT_DOUBLE_EQ(scene.well.hole_depth, 50.0) << "the last station";
  EXPECT_DOUBLE_EQ(scene.start.bit_depth, 50.0) << "the hole's depth";
  EXPECT_DOUBLE_EQ(scene.start.block_height, StartSpec{}.block_height);
  EXPECT_DOUBLE_EQ(scene.mud.density, 1150.0);
  EXPECT_DOUBLE_EQ(scene.contact.law.stiffness, 5e7);
  EXPECT_EQ(scene.numerics.level, Level::automatic);
  EXPECT_EQ(scene.trajectory.stage_two_steps, 0);
  EXPECT_FALSE(scene.string[1].contact.has_value());
  EXPECT_EQ(scene.string[0].joints, 1);
  EXPECT_DOUBLE_EQ(scene.string[0].joint_length, 0.3);
  EXPECT_TRUE(scene.program.empty());
}

TEST(SceneRead, APartMaySetItsOwnContactLaw)
{
  std::string text = smallest;
  text.replace(text.find("diameter: 0.25}"), 15, "diameter: 0.25, contact: {stiffness: 2e8}}");
  const Scene scene = parse_scene(text, "own_contact.yaml");
  ASSERT_TRUE(scene.string[0].contact.has_value());
  EXPECT_DOUBLE_EQ(scene.string[0].contact->stiffness, 2e8);
  EXPECT_DOUBLE_EQ(scene.string[0].contact->exponent, 1.5);
}

TEST(SceneRead, ABitCutsSidewaysByDefault)
{
  EXPECT_DOUBLE_EQ(parse_scene(smallest, "smallest.yaml").string[0].bit->side_cutting, 0.02);
}

TEST(SceneRead, DetournayTorqueTakesItsOwnKeys)
{
  std::string text = smallest;
  text.replace(text.find("drillability: 1e-8"), 18, "drillability: 1e-8, threshold: 1000");
  text.replace(text.find("diameter: 0.25}"), 15,
               "diameter: 0.25, torque: {model: detournay, cutting_energy: 2e8, wear_weight: 1000}}");
  const Scene scene = parse_scene(text, "detournay.yaml");
  EXPECT_EQ(scene.string[0].bit->torque.model, BitTorqueModel::detournay);
  EXPECT_DOUBLE_EQ(scene.string[0].bit->torque.cutting_energy, 2e8);
  EXPECT_DOUBLE_EQ(scene.string[0].bit->torque.wear_weight, 1000.0);
}

TEST(SceneRead, NumbersDoNotDependOnNotation)
{
  std::string text = smallest;
  text.replace(text.find("drillability: 1e-8"), 18, "drillability: 0.00000001");
  EXPECT_DOUBLE_EQ(parse_scene(text, "x").formation[0].drillability, 1e-8);
}

TEST(SceneRead, SettingsReplaceWhatTheFileSays)
{
  const Scene scene =
      parse_scene(smallest, "x", {"numerics.step=0.001", "well.sections[0].friction=0", "rig.top_drive.max_speed_rpm=100"});
  EXPECT_DOUBLE_EQ(scene.numerics.step, 0.001);
  EXPECT_DOUBLE_EQ(scene.well.sections[0].friction, 0.0);
  EXPECT_DOUBLE_EQ(scene.rig.top_drive.max_speed, 100.0 * rpm);
}

TEST(SceneRead, EveryIntegratorIsAWordOfTheSceneFile)
{
  EXPECT_EQ(parse_scene(smallest, "x", {"numerics.integrator=auto"}).numerics.integrator, IntegratorKind::automatic);
  for (const IntegratorEntry& entry : integrator_table())
    EXPECT_EQ(parse_scene(smallest, "x", {std::string("numerics.integrator=") + entry.name}).numerics.integrator, entry.kind)
        << entry.name;
  EXPECT_EQ(integrator_table().size(), static_cast<std::size_t>(IntegratorKind::ida)) << "all but automatic";
}

TEST(SceneRead, WrongSettingsAreRefusedByName)
{
  const auto message = [](const std::string& setting) -> std::string
  {
    try
    {
      parse_scene(smallest, "x", {setting});
    }
    catch (const SceneError& e)
    {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message("numerics.step=1").rfind("setting: numerics.step: 1 is out of range", 0), 0u) << message("numerics.step=1");
  EXPECT_EQ(message("numerics.stepp=1").rfind("setting: numerics.stepp: unknown key", 0), 0u) << message("numerics.stepp=1");
  EXPECT_EQ(message("well.sections[7].friction=0").rfind("setting: well.sections[7].friction: there is no such", 0), 0u);
  EXPECT_EQ(message("numerics.integrator=no_such")
                .rfind("setting: numerics.integrator: \"no_such\" is not known, allowed: auto, bdf2", 0),
            0u);
  EXPECT_EQ(message("numerics.kernel=scalar"), "accepted");
  const char* elsewhere = has_kernel(Kernel::neon) ? "sse4" : "neon";
  EXPECT_EQ(message((std::string("numerics.kernel=") + elsewhere).c_str()),
            std::string("setting: numerics.kernel: ") + elsewhere +
                " is not available on this machine or in this build, allowed: " + kernels_here());
  EXPECT_EQ(message("numerics.step").rfind("setting: numerics.step: has no value", 0), 0u);
  EXPECT_EQ(message("mud={densty: 1000}").rfind("setting: mud.densty: unknown key", 0), 0u) << message("mud={densty: 1000}");
  EXPECT_EQ(message("string=[{name: bit, type: bit, length: 0.3, mass: 40}]").rfind("setting: string[0].diameter: is missing", 0),
            0u);
  EXPECT_EQ(message("name.step=1").rfind("setting: name.step: goes through", 0), 0u);
  for (const char* nonsense : {"=", "..=1", "a[=1", "a[]=1", "well[0]=1", "name=[", "[0]=1", "string[0]..x=1"})
    EXPECT_NE(message(nonsense), "accepted") << nonsense;
}

// In range, and no rig has them: as of a number whose unit is missing.
TEST(SceneRead, UnlikelyValuesAreReported)
{
  const auto remarks = [](const std::string& setting) { return parse_scene(smallest, "x", {setting}).remarks; };
  EXPECT_TRUE(remarks("mud.density=1200").empty());
  EXPECT_TRUE(remarks("mud.density=0").empty()) << "a hole in a vacuum";
  ASSERT_EQ(1u, remarks("mud.density=9.5").size());
  EXPECT_EQ("x: mud.density: 1.2 kg/m3 is the density of a gas; is its unit missing? 1.2 g/cm3 is 1200 kg/m3",
            remarks("mud.density=1.2").front());
  EXPECT_EQ("x: mud.density: 9.5 kg/m3 is the density of a gas; is its unit missing? 9.5 ppg is 1138 kg/m3",
            remarks("mud.density=9.5").front());
  EXPECT_NE(std::string::npos, remarks("mud.density=75").at(0).find("75 kg/m3 is the density of foam"));
  const PartSpec part = parse_scene(smallest, "x").string.back();
  const double body =
      pi / 4.0 * (part.outer_diameter * part.outer_diameter - part.inner_diameter * part.inner_diameter) * part.density;
  const std::string key = "string[" + std::to_string(parse_scene(smallest, "x").string.size() - 1) + "].linear_mass";
  EXPECT_EQ(0u, remarks(key + "=" + std::to_string(2.1 * body)).at(0).rfind("x: " + key + ": ", 0));
  for (const double share : {1.0, 1.9}) EXPECT_TRUE(remarks(key + "=" + std::to_string(share * body)).empty()) << share;
  const std::string collar =
      "string=[{name: bit, type: bit, length: 0.3, mass: 50, diameter: 0.25}, {name: collar, type: collar, joints: 1, "
      "joint_length: 9.4, "
      "outer_diameter: 0.165, inner_diameter: 0.0714, linear_mass: 0.136}, {name: pipe, type: pipe, joints: fill, joint_length: "
      "9.5, "
      "outer_diameter: 0.127, inner_diameter: 0.1086, linear_mass: 31.9}]";
  ASSERT_EQ(1u, remarks(collar).size()) << "in tonnes a metre";
  EXPECT_EQ(0u, remarks(collar).front().rfind(
                    "x: string[1].linear_mass: 0.136 kg/m does not match its diameters and density (136 kg/m)", 0))
      << remarks(collar).front();
  ASSERT_EQ(1u, remarks("well.stations=[[0, 0, 0], [40, 0, 0], [50, 60, 0]]").size());
  EXPECT_NE(std::string::npos, remarks("well.stations=[[0, 0, 0], [40, 0, 0], [50, 60, 0]]")
                                   .front()
                                   .find("well.stations: from 40.00 to 50.00 m the hole turns by 180 deg/30 m"));
}

// What was read is shown of a key that a scene has.
TEST(SceneRead, AWrongWordIsShown)
{
  const auto message = [](const std::string& setting) -> std::string
  {
    try
    {
      parse_scene(smallest, "x", {setting});
    }
    catch (const SceneError& e)
    {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_EQ(
      "setting: string[0].type: \"tricone\" is not known, allowed: bit, mud_motor, collar, stabilizer, mwd, pipe or "
      "rotary_steerable",
      message("string[0].type=tricone"));
  EXPECT_EQ(
      "setting: string[0].type: a list is not known, allowed: bit, mud_motor, collar, stabilizer, mwd, pipe or rotary_steerable",
      message("string[0].type=[bit]"));
  EXPECT_EQ(0u, message("mud.density=1,2").rfind("setting: mud.density: \"1,2\" is not a number, allowed: 0 to 3000 kg/m3", 0))
      << message("mud.density=1,2");
  EXPECT_EQ(0u, message("mud.density='1200'").rfind("setting: mud.density: \"1200\" in quotes is not a number", 0))
      << message("mud.density='1200'");
  EXPECT_EQ("setting: string[1].joints: must be 1 to 10000, or fill (got \"two\")", message("string[1].joints=two"));
}

TEST(SurveyCsv, ColumnsMayStandInAnyOrderBesideOthers)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("order.csv");
  std::ofstream(file) << "# comment\r\nazimuth_deg,tvd_m,md_m,inclination_deg\r\n90,0,0,0\r\n\r\n91, 99 , 100 ,1\r\n";
  const auto survey = read_survey_file(file).stations;
  ASSERT_EQ(survey.size(), 2u);
  EXPECT_DOUBLE_EQ(survey[1].md, 100.0);
  EXPECT_DOUBLE_EQ(survey[1].azimuth, 91.0 * degree);
}

TEST(SurveyCsv, TheFirstStationsPlaceIsTheTieIn)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("tied.csv");
  std::ofstream(file) << "md_m,tvd_m,inclination_deg,azimuth_deg,east_m,north_m\n100,99,1,90,2,-3\n200,x,1,90,,\n";
  const SurveyTable table = read_survey_file(file);
  ASSERT_TRUE(table.tie_in.has_value());
  EXPECT_EQ(-3.0, table.tie_in->north);
  EXPECT_EQ(2.0, table.tie_in->east);
  EXPECT_EQ(99.0, table.tie_in->tvd);
  EXPECT_EQ(98.0, read_survey_file(file, TieIn{0.0, 0.0, 98.0}).tie_in->tvd) << "what is given goes before";
}

// Columns of places that are not needed may hold anything, as before there was a use for them.
TEST(SurveyCsv, ASurveyFromTheTableNeedsNoTieIn)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("from_0.csv");
  std::ofstream(file) << "md_m,inclination_deg,azimuth_deg,tvd_m,north_m,east_m\n0,0,0,n/a,,\n200,1,90,200,0,1\n";
  EXPECT_FALSE(read_survey_file(file).tie_in.has_value());
}

TEST(SceneRead, AWellIsTiedIn)
{
  const std::vector<SurveyStation> above =
      parse_scene(smallest, "x", {"well.stations=[[20, 0, 0], [50, 0, 0]]", "well.tie_in={tvd: 20}"}).well.survey;
  ASSERT_EQ(4u, above.size());
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(std::vector<double>({0.0, 10.0, 20.0, 50.0})[i], above[i].md, 1e-9);
    EXPECT_EQ(0.0, above[i].inclination);
  }
}

std::string refusal_of_file(const std::string& file)
{
  try
  {
    read_survey_file(file);
  }
  catch (const SceneError& error)
  {
    return std::string(error.what()).substr(file.size());
  }
  return "";
}

std::string survey_refusal(const std::string& text)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("wrong.csv");
  std::ofstream(file) << text;
  return refusal_of_file(file);
}

// 30,0,1,5,297,0 is 30.0, 1.5, 297.0 where the decimal mark is a comma: not 30, 0 and 1.
TEST(SurveyCsv, ARowLongerThanItsHeaderIsRefused)
{
  const std::string header = "md_m,inclination_deg,azimuth_deg\n";
  EXPECT_EQ(":3: has 6 cells, the header 3, allowed: the same number, with decimal points",
            survey_refusal(header + "0,0,0\n30,0,1,5,297,0\n"));
  EXPECT_NE("", survey_refusal(header + "0,0,0,0\n30,1,297,0\n")) << "a nought is a number, too";
  EXPECT_EQ("", survey_refusal(header + "0,0,0,,\n30,1,297,\n")) << "as spreadsheets fill up";
}

TEST(SurveyCsv, AColumnStandsOnce)
{
  EXPECT_EQ(":1: md_m: appears more than once in the header, allowed: once",
            survey_refusal("md_m,inclination_deg,azimuth_deg,md_m\n0,0,0,0\n30,1,297,31\n"));
}

TEST(SurveyCsv, MayBeginWithAByteOrderMark)
{
  EXPECT_EQ("", survey_refusal("\xef\xbb\xbfmd_m,inclination_deg,azimuth_deg\r\n0,0,0\r\n30,1,297\r\n"));
}

TEST(SurveyCsv, FilesThatHoldNothingOrNeverEnd)
{
  const std::string needed =
      "needed: a survey: a table with the columns md_m, inclination_deg, azimuth_deg, or a WITSML trajectory";
  for (const char* text : {"", "\n", "# md_m,inclination_deg,azimuth_deg\n"})
    EXPECT_EQ(": is empty, " + needed, survey_refusal(text));
  // a regular file without a size that goes on for 256 GB
  EXPECT_EQ(": is larger than 16 MiB, " + needed, refusal_of_file("/proc/self/pagemap"));
}

TEST(SurveyProblems, NameTheStation)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(survey_problems({{0, 0, 0}, {100, 0.1, 1}}).empty());
  EXPECT_EQ(survey_problems({{0, 0, 0}}).size(), 1u);
  EXPECT_EQ(survey_problems({{0, 0, 0}, {100, nan, 1}}).at(0).station, 1u);
  EXPECT_EQ(survey_problems({{0, 0, 0}, {100, 200 * degree, 1}}).at(0).station, 1u);
  EXPECT_EQ(survey_problems({{0, 0, 0}, {100, 0, 1}, {100, 0, 1}}).at(0).station, 2u);
  EXPECT_EQ(survey_problems({{5, 0, 0}, {100, 0, 1}}).at(0).station, 0u);
}

TEST(SceneReference, ListsKeysWithUnitsAndDefaults)
{
  const std::string reference = scene_reference();
  EXPECT_NE(reference.find("| `max_speed_rpm` | rpm | 220 | 1 to 1000 |"), std::string::npos) << reference;
  EXPECT_NE(reference.find("| `blade_diameter` | m | **required** |"), std::string::npos);
  EXPECT_NE(reference.find("| `level` |  | auto | rigid, axial_torsional, hybrid, beam3d or auto |"), std::string::npos);
}

// A foot of a survey's file and a foot of the scene are rounded in other places; a depth is one depth all the same.
TEST(ReadScene, aDepthInFeetIsTheSameDepthInSurveyAndScene)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("feet.csv");
  for (int depth = 3000; depth < 12000; depth += 373)
  {
    const std::string feet = std::to_string(depth);
    std::ofstream(file) << "MD (ft),Inc (deg),Azi (deg)\n0,0,0\n" << feet << ",2,30\n";
    const Scene scene =
        read_scene(in_source("config/scenes/quick.yaml"),
                   {"well={survey: {file: " + file + "}, sections: [{to: " + feet + " ft, diameter: 0.2159, friction: 0.3}]}",
                    "start.bit_depth=" + feet + " ft"});
    EXPECT_EQ(scene.well.survey.back().md, scene.well.hole_depth) << feet;
    EXPECT_EQ(scene.well.hole_depth, scene.well.sections.back().to) << feet;
    EXPECT_EQ(scene.well.hole_depth, scene.start.bit_depth) << feet;
  }
}

}  // namespace
}  // namespace drill_rig_sim::test_scene_read
