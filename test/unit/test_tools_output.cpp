// SPDX-License-Identifier: BSD-3-Clause
// The runner's tables: each column holds the field that its head names.
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "drill_ahead.h"
#include "drill_command.h"
#include "drill_output.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/wellbore.h"
#include "numbered_frame.h"
#include "test_scenes.h"

namespace drill_rig_sim::test_tools_output
{
namespace
{
using Row = std::map<std::string, double>;

std::vector<std::string> cells_of(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

std::string text_of(std::FILE* file)
{
  std::string text;
  std::rewind(file);
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  return text;
}

/// What was written, by the head's names.
std::vector<Row> rows_of(std::FILE* file)
{
  std::istringstream lines(text_of(file));
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> head = cells_of(line);
  std::vector<Row> rows;
  while (std::getline(lines, line))
  {
    const std::vector<std::string> cells = cells_of(line);
    EXPECT_EQ(head.size(), cells.size());
    rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) rows.back()[head[i]] = std::stod(cells[i]);
  }
  return rows;
}

void expect_row(const Row& expected, const Row& row)
{
  ASSERT_EQ(expected.size(), row.size());
  for (const auto& [name, value] : expected) EXPECT_NEAR(value, row.at(name), 1e-8 * std::abs(value)) << name;
}

/// Bends from vertical at 100 m to 60 deg at 300 m, towards the north-west.
Scene curved_scene()
{
  Scene scene = vertical_scene(300.0, 250.0);
  scene.well.survey = {{0.0, 0.0, 5.5}, {100.0, 0.0, 5.5}, {300.0, 60.0 * degree, 5.5}};
  return scene;
}

Truth numbered_truth()
{
  Truth m;
  number_signals(m, 100.0);
  number_bit(m);
  m.bit_orientation = shortest_turn(Eigen::Vector3d::UnitX(), tangent_from(0.75, 2.0));
  m.bit_inclination = 261.0;
  m.bit_azimuth = 262.0;
  m.bend_toolface = 263.0;
  m.floor_height = 264.0;
  m.cuttings_volume = 265.0;
  m.bed_height = 266.0;
  m.bottom_hole_temperature = 267.0;
  return m;
}

Row truth_row()
{
  return {{"time", 100},
          {"hook_load", 101},
          {"torque", 108},
          {"block_height", 104},
          {"top_drive_speed", 107},
          {"wob", 251},
          {"bit_torque", 252},
          {"bit_speed", 253},
          {"bit_depth", 113},
          {"hole_depth", 112},
          {"rop", 115},
          {"inclination", 261},
          {"azimuth", 262},
          {"toolface", 263},
          {"bit_east", 201},
          {"bit_north", 202},
          {"bit_up", 203},
          {"bit_inclination", 0.75},
          {"in_slips", 0},
          {"motor_stalled", 0},
          {"winch_limited", 0},
          {"top_drive_limited", 0},
          {"stop_reached", 0},
          {"slack_line", 0},
          {"relief_valve_open", 0},
          {"over_stress", 0},
          {"over_torque", 0},
          {"buckled", 0},
          {"accuracy_warning", 0},
          {"stand_pipe_pressure", 109},
          {"differential_pressure", 110},
          {"flow", 111},
          {"floor_height", 264},
          {"dead_line_hook_load", 102},
          {"hook_load_string", 103},
          {"stroke_rate", 117},
          {"pump_strokes", 118},
          {"ecd", 116},
          {"flow_line_temperature", 122},
          {"encoder_bit_depth", 121},
          {"block_velocity", 105},
          {"floor_velocity", 120},
          {"top_drive_angle", 106},
          {"surface_wob", 114},
          {"tared", 0},
          {"on_bottom", 0},
          {"stand_count", 0},
          {"brake_set", 0},
          {"cuttings_volume", 265},
          {"bed_height", 266},
          {"bottom_hole_temperature", 267},
          {"top_drive_brake_set", 0},
          {"command_clamped", 0},
          {"commands_timed_out", 0},
          {"over_pull", 0},
          {"pump_tripped", 0},
          {"drive_tripped", 0}};
}
}  // namespace

TEST(Csv, eachColumnHasItsFieldOfTheTruth)
{
  const File file(std::tmpfile());
  write_csv_header(file.get(), false);
  write_csv_row(file.get(), numbered_truth(), nullptr);
  const std::vector<Row> rows = rows_of(file.get());
  ASSERT_EQ(1u, rows.size());
  expect_row(truth_row(), rows[0]);
}

TEST(Csv, eachFlagHasItsColumn)
{
  const std::pair<const char*, bool Truth::*> flags[] = {{"in_slips", &Truth::in_slips},
                                                         {"motor_stalled", &Truth::motor_stalled},
                                                         {"winch_limited", &Truth::winch_limited},
                                                         {"top_drive_limited", &Truth::top_drive_limited},
                                                         {"stop_reached", &Truth::stop_reached},
                                                         {"slack_line", &Truth::slack_line},
                                                         {"relief_valve_open", &Truth::relief_valve_open},
                                                         {"over_stress", &Truth::over_stress},
                                                         {"over_torque", &Truth::over_torque},
                                                         {"buckled", &Truth::buckled},
                                                         {"accuracy_warning", &Truth::accuracy_warning}};
  for (const auto& [name, flag] : flags)
  {
    Truth m = numbered_truth();
    m.*flag = true;
    const File file(std::tmpfile());
    write_csv_header(file.get(), false);
    write_csv_row(file.get(), m, nullptr);
    Row expected = truth_row();
    expected[name] = 1;
    expect_row(expected, rows_of(file.get()).at(0));
  }
}

TEST(Csv, readingsStandBesideTheTruth)
{
  Readings r;
  number_signals(r, 300.0);
  r.tared = true;
  const File file(std::tmpfile());
  write_csv_header(file.get(), true);
  write_csv_row(file.get(), numbered_truth(), &r);
  const std::vector<Row> rows = rows_of(file.get());
  ASSERT_EQ(1u, rows.size());
  Row expected = truth_row();
  expected.insert({{"reading_hook_load", 301},
                   {"reading_torque", 308},
                   {"reading_stand_pipe_pressure", 309},
                   {"reading_flow", 311},
                   {"reading_block_height", 304},
                   {"reading_bit_depth", 313},
                   {"reading_hole_depth", 312},
                   {"reading_rop", 315},
                   {"reading_surface_wob", 314},
                   {"reading_differential_pressure", 310},
                   {"reading_dead_line_hook_load", 302},
                   {"reading_hook_load_string", 303},
                   {"reading_stroke_rate", 317},
                   {"reading_pump_strokes", 318},
                   {"reading_ecd", 316},
                   {"reading_flow_line_temperature", 322},
                   {"reading_encoder_bit_depth", 321},
                   {"reading_block_velocity", 305},
                   {"reading_floor_height", 319},
                   {"reading_floor_velocity", 320},
                   {"reading_top_drive_angle", 306},
                   {"reading_top_drive_speed", 307},
                   {"reading_tared", 1},
                   {"reading_lost_gauges", 0}});
  for (const char* flag : {"in_slips", "stand_count", "brake_set", "winch_limited", "slack_line", "stop_reached",
                           "relief_valve_open", "accuracy_warning", "top_drive_brake_set", "top_drive_limited", "command_clamped",
                           "commands_timed_out", "over_pull", "pump_tripped", "drive_tripped"})
    expected[std::string("reading_") + flag] = 0;
  expect_row(expected, rows[0]);
}

TEST(Csv, aReadingWithoutZeroIsAnEmptyCell)
{
  Readings r;
  number_signals(r, 300.0);
  const File file(std::tmpfile());
  write_csv_row(file.get(), numbered_truth(), &r);
  EXPECT_NE(std::string::npos, text_of(file.get()).find(",315,,,302,"))
      << "rop, surface_wob, differential_pressure, dead_line_hook_load";
  r.tared = true;
  r.surface_wob = 0.0;
  const File zeroed(std::tmpfile());
  write_csv_row(zeroed.get(), numbered_truth(), &r);
  EXPECT_NE(std::string::npos, text_of(zeroed.get()).find(",315,0,310,302,"));
}

TEST(Csv, errorsAndTheCompanionsTruthStandBesideTheTruth)
{
  Scene scene = drilling_scene();
  scene.numerics.companion = CompanionKind::finer;
  Simulator simulator(scene);
  drill_ahead(simulator, 6.0, 0.0, 0.01);
  for (int k = 0; k < 100; ++k) ASSERT_EQ(FrameStatus::running, simulator.frame(0.01));
  const File file(std::tmpfile()), of_companion(std::tmpfile());
  write_csv_header(file.get(), false, true);
  write_csv_row(file.get(), numbered_truth(), nullptr, &simulator);
  write_csv_header(of_companion.get(), false);
  write_csv_row(of_companion.get(), simulator.companion_truth(0), nullptr);
  Row expected = truth_row(), row = rows_of(file.get()).at(0);
  for (const OutputTraits& output : output_traits)
  {
    const std::string name = std::string("error_") + output.name;
    expected[name] = simulator.measured_error(static_cast<Output>(&output - output_traits.data()));
    EXPECT_NEAR(expected[name], row.at(name), 1e-3 * expected[name]);  // four digits
    row[name] = expected[name];
  }
  Row companion = rows_of(of_companion.get()).at(0);
  EXPECT_NE(companion["hook_load"], simulator.truth().hook_load);
  companion.erase("time");
  for (const auto& [name, value] : companion) expected["companion_" + name] = value;
  expect_row(expected, row);
}

TEST(Csv, aCompanionThatHasEndedIsEmptyCells)
{
  Simulator simulator(drilling_scene());
  const auto alone = simulator.save();
  simulator.add_companion(simulator.scene().numerics);
  ASSERT_TRUE(simulator.restore(*alone));  // holds no companion
  const File truth(std::tmpfile()), file(std::tmpfile());
  write_csv_row(truth.get(), numbered_truth(), nullptr);
  write_csv_row(file.get(), numbered_truth(), nullptr, &simulator);
  std::string expected = text_of(truth.get());
  expected.insert(expected.size() - 1, std::string(output_count + truth_row().size() - 1, ','));
  EXPECT_EQ(expected, text_of(file.get()));
}

TEST(Profile, eachColumnHasItsArray)
{
  StringProfile p;
  for (const double base : {0.0, 100.0})
  {
    p.md.push_back(base + 1);
    p.from_bit.push_back(base + 2);
    p.position.emplace_back(base + 3, base + 4, base + 5);
    p.tension.push_back(base + 6);
    p.true_axial_force.push_back(base + 7);
    p.torque.push_back(base + 8);
    p.bending_moment.push_back(base + 9);
    p.contact_force.push_back(base + 10);
    p.contact_side.push_back((base + 11) * degree);
  }
  const File file(std::tmpfile()), series(std::tmpfile());
  write_profile(file.get(), p);
  const std::vector<Row> rows = rows_of(file.get());
  ASSERT_EQ(2u, rows.size());
  write_profile_series_header(series.get());
  for (const double time : {12.5, 13.5}) write_profile_series_rows(series.get(), time, p);
  const std::vector<Row> at_times = rows_of(series.get());
  ASSERT_EQ(4u, at_times.size());
  const std::vector<std::string> columns = {
      "md",     "from_bit",       "east",          "north",           "up", "tension", "true_axial_force",
      "torque", "bending_moment", "contact_force", "contact_side_deg"};
  for (int i = 0; i < 2; ++i)
  {
    Row expected;
    for (std::size_t k = 0; k < columns.size(); ++k) expected[columns[k]] = 100.0 * i + 1.0 + static_cast<double>(k);
    expect_row(expected, rows[i]);
    expected["time"] = 12.5;
    expect_row(expected, at_times[i]);
    expected["time"] = 13.5;
    expect_row(expected, at_times[i + 2]);
  }
}

TEST(Path, isTheWellsNodesAndItsBottom)
{
  const Simulator simulator(curved_scene());
  const Wellbore& well = simulator.wellbore();
  const File file(std::tmpfile());
  write_path(file.get(), simulator);
  const std::vector<Row> rows = rows_of(file.get());
  ASSERT_EQ(static_cast<std::size_t>(well.node_count()) + 1, rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const WellNode node = i + 1 < rows.size() ? well.node(static_cast<int>(i)) : well.at(well.hole_depth());
    Row row = rows[i];
    EXPECT_NEAR(node.md, row["md"], 1e-6);
    EXPECT_NEAR(0.0, (node.position - Eigen::Vector3d(row["east"], row["north"], row["up"])).norm(), 1e-6);
    EXPECT_NEAR(0.0, (node.tangent - tangent_from(row["inclination"], row["azimuth"])).norm(), 1e-8);
    EXPECT_NEAR(node.radius, row["radius"], 1e-6);
  }
  EXPECT_NEAR(60.0 * degree, Row(rows.back())["inclination"], 1e-6);
  EXPECT_NEAR(5.5, Row(rows.back())["azimuth"], 1e-6);
}

TEST(RawPath, isThePathBeforeItsCorrection)
{
  Simulator simulator(drilling_scene());
  drill_ahead(simulator, 6.0, 0.0, 0.01);
  for (int k = 0; k < 300; ++k) ASSERT_EQ(FrameStatus::running, simulator.frame(0.01));
  std::vector<Eigen::Vector3d> points;
  simulator.raw_path(points);
  ASSERT_GT(points.size(), 2u);
  const File file(std::tmpfile());
  write_raw_path(file.get(), simulator);
  const std::vector<Row> rows = rows_of(file.get());
  ASSERT_EQ(points.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_NEAR(0.0, (points[i] - Eigen::Vector3d(rows[i].at("east"), rows[i].at("north"), rows[i].at("up"))).norm(), 1e-9);
}

TEST(Output, whatCannotBeWrittenIsRefusedByOptionAndName)
{
  EXPECT_EQ(nullptr, open_output("--csv", ""));
  close_output(File(), "");
  try
  {
    open_output("--csv", "/nowhere/at/all");
    FAIL();
  }
  catch (const UsageError& e)
  {
    EXPECT_STREQ("--csv: /nowhere/at/all cannot be written: No such file or directory", e.what());
  }
}

}  // namespace drill_rig_sim::test_tools_output
