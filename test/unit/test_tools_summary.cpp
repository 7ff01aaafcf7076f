// SPDX-License-Identifier: BSD-3-Clause
// The runner's summary: each number under the name of what it is.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "drill_ahead.h"
#include "drill_rig_sim/math/units.h"
#include "drill_summary.h"
#include "test_scenes.h"

namespace drill_rig_sim::test_tools_summary
{
namespace
{
using Numbers = std::map<std::string, double>;

/// A bent motor and a survey tool in a slanted hole, from 5 mm above its bottom on: no reading is nought.
Scene steered_scene()
{
  Scene scene = slanted_scene(199.995, 0.2);
  scene.string = {bit_part(0.2159), motor_part(), mwd_part(), pipe_part(0, 9.5, tool_jointed_mass)};
  scene.instruments.mwd.latency = scene.instruments.toolface.latency = 0.0;
  return scene;
}

Simulator after_two_seconds(const Scene& scene, RunRecord& record, bool energy)
{
  Simulator simulator(scene);
  if (energy) simulator.balance_energy();
  simulator.tare();
  drill_ahead(simulator, 6.0, 0.03, 0.01);
  for (int k = 0; k < 200; ++k)
  {
    EXPECT_EQ(FrameStatus::running, simulator.frame(0.01));
    record.drilling.add(simulator.truth());
  }
  return simulator;
}

nlohmann::json summary_of(const Simulator& simulator, const RunRecord& record, bool readings)
{
  return nlohmann::json::parse(json_summary(simulator, Elapsed{0.5, 0.25}, record, readings));
}

/// All of them, none else, to the last bit.
void expect_numbers(const Numbers& expected, const nlohmann::json& block)
{
  EXPECT_EQ(expected.size(), block.size());
  for (const auto& [name, value] : expected)
  {
    ASSERT_TRUE(block.contains(name)) << name;
    EXPECT_EQ(value, block.at(name).get<double>()) << name;
  }
}

Numbers numbers_of(const Averages& a)
{
  return {{"hook_load", a.hook_load()},
          {"torque", a.torque()},
          {"wob", a.wob()},
          {"bit_torque", a.bit_torque()},
          {"bit_speed_rpm", a.bit_speed() / rpm},
          {"rop", a.rop()},
          {"hole_depth", a.hole_depth()},
          {"bit_east", a.bit_position().x()},
          {"bit_north", a.bit_position().y()},
          {"bit_up", a.bit_position().z()},
          {"inclination_deg", a.inclination() / degree},
          {"azimuth_deg", a.azimuth() / degree}};
}

/// One moment on bottom.
RunRecord drilled()
{
  RunRecord record;
  Truth m;
  m.on_bottom = true;
  m.hook_load = 1234e2;
  m.torque = 5670.0;
  m.wob = 8900.0;
  m.rop = 0.01;
  m.bit_speed = 2.0 * pi;
  record.drilling.add(m);
  return record;
}

/// Two moments off bottom, 9 s apart, of a hook load that rises from 100 to 200 kN.
RunRecord hung()
{
  RunRecord record;
  Truth m;
  m.torque = 1000.0;
  for (const auto& [time, load] : {std::pair{21.0, 100e3}, std::pair{30.0, 200e3}})
  {
    m.time = time;
    m.hook_load = load;
    record.latest.add(m);
  }
  return record;
}
}  // namespace

TEST(Summary, tellsWhatRanAndHowFast)
{
  RunRecord record;
  const Simulator simulator = after_two_seconds(drilling_scene(), record, false);
  const SimulatorStatistics& s = simulator.statistics();
  const nlohmann::json told = summary_of(simulator, record, false);
  EXPECT_EQ(simulator.truth().time, told["simulated_s"].get<double>());
  EXPECT_EQ(0.5, told["wall_s"].get<double>());
  EXPECT_EQ(0.25, told["cpu_s"].get<double>());
  EXPECT_EQ(simulator.truth().time / 0.25, told["real_time_factor"].get<double>());
  EXPECT_EQ("beam3d", told["level"]);
  EXPECT_EQ("bdf2", told["integrator"]);
  EXPECT_EQ(s.step, told["step"].get<double>());
  const std::map<std::string, std::uint64_t> counts = {{"nodes", s.nodes},
                                                       {"coordinates", s.coordinates},
                                                       {"steps", s.steps},
                                                       {"newton_iterations", s.newton_iterations},
                                                       {"rejected_steps", s.convergence_failures + s.error_test_failures},
                                                       {"convergence_failures", s.convergence_failures},
                                                       {"error_test_failures", s.error_test_failures},
                                                       {"residuals", s.work.residuals},
                                                       {"tangents", s.work.tangents},
                                                       {"solves", s.work.solves},
                                                       {"substitutions", s.work.substitutions}};
  for (const auto& [name, count] : counts) EXPECT_EQ(count, told[name].get<std::uint64_t>()) << name;
  EXPECT_EQ(0.0, told["guided_nodes"].get<double>());
  for (const char* name : {"reference", "energy", "final_readings", "failure"}) EXPECT_FALSE(told.contains(name)) << name;
}

TEST(Summary, sharesOfCostAreOfTheProfiledTime)
{
  RunRecord record;
  const Simulator simulator = after_two_seconds(drilling_scene(), record, false);
  // in the order of the sum
  const std::pair<const char*, Cost> costs[] = {{"kinematics", Cost::kinematics},
                                                {"elements", Cost::elements},
                                                {"guided", Cost::guided},
                                                {"inertia", Cost::inertia},
                                                {"contact", Cost::contact},
                                                {"bit", Cost::bit},
                                                {"rig", Cost::rig},
                                                {"linear_solve", Cost::linear_solve},
                                                {"rock_penetration", Cost::rock_penetration},
                                                {"other", Cost::other}};
  double total = 0.0;
  for (const auto& [name, cost] : costs) total += simulator.statistics().costs.seconds(cost);
  Numbers expected;
  for (const auto& [name, cost] : costs) expected[name] = simulator.statistics().costs.seconds(cost) / total;
  expect_numbers(expected, summary_of(simulator, record, false)["cost_share"]);
}

TEST(Summary, meansAreOfTheEndOfTheDrillingAndOfItsLastQuarter)
{
  RunRecord record;
  const Simulator simulator = after_two_seconds(steered_scene(), record, false);
  const nlohmann::json told = summary_of(simulator, record, false);
  Averages end;
  end.add(simulator.truth());
  expect_numbers(numbers_of(end), told["final"]);
  expect_numbers(numbers_of(record.drilling.all()), told["mean_drilling"]);
  expect_numbers(numbers_of(record.drilling.last_quarter()), told["mean_last_quarter"]);
  EXPECT_NE(told["mean_drilling"]["torque"], told["mean_last_quarter"]["torque"]);
  EXPECT_NE(told["final"]["torque"], told["mean_last_quarter"]["torque"]);
}

TEST(Summary, readingsAreTheInstruments)
{
  RunRecord record;
  const Simulator simulator = after_two_seconds(steered_scene(), record, false);
  const Readings& r = simulator.readings();
  Numbers expected = {{"hook_load", r.hook_load},
                      {"dead_line_hook_load", r.dead_line_hook_load},
                      {"hook_load_string", r.hook_load_string},
                      {"torque", r.torque},
                      {"stand_pipe_pressure", r.stand_pipe_pressure},
                      {"differential_pressure", r.differential_pressure},
                      {"flow", r.flow},
                      {"block_height", r.block_height},
                      {"bit_depth", r.bit_depth},
                      {"hole_depth", r.hole_depth},
                      {"rop", r.rop},
                      {"surface_wob", r.surface_wob},
                      {"mwd_md", r.mwd.md},
                      {"mwd_inclination_deg", r.mwd.inclination / degree},
                      {"mwd_azimuth_deg", r.mwd.azimuth / degree},
                      {"toolface_deg", r.toolface.toolface / degree}};
  nlohmann::json found = summary_of(simulator, record, true)["final_readings"];
  for (const auto& [name, value] : expected) EXPECT_NE(0.0, value) << name << ": nought could be anything's";
  EXPECT_EQ(r.tared, found["tared"].get<bool>());
  EXPECT_EQ(r.pump_strokes, found["pump_strokes"].get<unsigned>());
  expected["ecd"] = r.ecd;
  expected["block_velocity"] = r.block_velocity;
  expected["top_drive_speed"] = r.top_drive_speed;
  for (const auto& [name, value] : nlohmann::json::object_t(found))
    if (expected.count(name) == 0) found.erase(name);
  expect_numbers(expected, found);
}

TEST(Summary, energyIsToldAccountByAccountWhereItIsBalanced)
{
  RunRecord record;
  const Simulator simulator = after_two_seconds(steered_scene(), record, true);
  const EnergyAccounts& e = simulator.energy();
  expect_numbers({{"winch", e.winch},
                  {"drive", e.drive},
                  {"pump", e.pump},
                  {"heave", e.heave},
                  {"gravity", e.gravity},
                  {"steering", e.steering},
                  {"handled", e.handled},
                  {"stored", e.stored()},
                  {"wall_friction", e.wall_friction},
                  {"wall_damping", e.wall_damping},
                  {"bottom_damping", e.bottom_damping},
                  {"squeeze_film", e.squeeze_film},
                  {"mud", e.mud},
                  {"structural", e.structural},
                  {"block", e.block},
                  {"gearbox", e.gearbox},
                  {"motor_slip", e.motor_slip},
                  {"stuck_point_released", e.stuck_point_released},
                  {"ledge", e.ledge},
                  {"added_mass", e.added_mass},
                  {"rock_thrust", e.rock_thrust},
                  {"rock_torque", e.rock_torque},
                  {"correction", e.correction},
                  {"numerical_inertia", e.of_inertia},
                  {"numerical_beams", e.of_beams},
                  {"numerical_contact", e.of_contact},
                  {"numerical_line", e.of_line},
                  {"numerical_residual", e.of_residual},
                  {"numerical_rebasing", e.of_rebasing},
                  {"residual", e.residual()},
                  {"throughput", e.throughput()},
                  {"closure", e.closure()},
                  {"numerical_share", e.numerical_share()},
                  {"numerical_of_losses", e.numerical_of_losses()}},
                 summary_of(simulator, record, false)["energy"]);
}

TEST(Summary, aReferenceReportsItsWork)
{
  Scene scene = drilling_scene();
  scene.numerics.integrator = IntegratorKind::ida;
  Simulator simulator(scene);
  for (int k = 0; k < 5; ++k) ASSERT_EQ(FrameStatus::running, simulator.frame(0.01));
  const ReferenceReport& report = simulator.statistics().reference;
  expect_numbers({{"constraint_drift", report.drift},
                  {"constraint_rate_drift", report.rate_drift},
                  {"jacobians", report.ida.jacobians},
                  {"error_test_failures", report.ida.error_test_failures},
                  {"newton_failures", report.ida.newton_failures},
                  {"starts", report.ida.starts},
                  {"last_order", report.ida.last_order},
                  {"last_step", report.ida.last_step},
                  {"smallest_step", report.ida.smallest_step}},
                 summary_of(simulator, RunRecord(), false)["reference"]);
}

TEST(Summary, inTwoLines)
{
  const RunRecord record = drilled();
  const Simulator simulator(drilling_scene());
  testing::internal::CaptureStdout();
  print_summary(simulator, Elapsed{9.0, 0.5}, record, Printed("si"));
  print_summary(simulator, Elapsed{9.0, 0.5}, hung(), Printed("si"));
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_NE(std::string::npos, text.find(": 0.0 s simulated in 0.50 s (0.0 times real time), hole 100.000 m\n"));
  EXPECT_NE(std::string::npos, text.find("hook load 123.4 kN, torque 5.67 kN m, WOB 8.9 kN, ROP 36.00 m/h, bit 60 rpm\n"));
  EXPECT_NE(std::string::npos,
            text.find("the bit was never on bottom; mean of 21 to 30 s: hook load 150.0 kN, torque 1.00 kN m\n"))
      << text;
}

TEST(Summary, inUnitsOfTheOilfield)
{
  const RunRecord record = drilled();
  const Simulator simulator(drilling_scene());
  testing::internal::CaptureStdout();
  print_summary(simulator, Elapsed{9.0, 0.5}, record, Printed("oilfield"));
  print_summary(simulator, Elapsed{9.0, 0.5}, hung(), Printed("oilfield"));
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_NE(std::string::npos, text.find(", hole 328.08 ft\n")) << text;
  // 123.4 kN, 5.67 kN m, 8.9 kN, 36 m/h
  EXPECT_NE(std::string::npos,
            text.find("hook load 27.7 klbf, torque 4.18 kft.lbf, WOB 2.0 klbf, ROP 118.1 ft/h, bit 60.0 rpm\n"))
      << text;
  EXPECT_NE(std::string::npos, text.find("s: hook load 33.7 klbf, torque 0.74 kft.lbf\n")) << text;
}

TEST(Summary, saysWhatMayBeWrong)
{
  RunRecord record;
  const AccuracyReport first{AccuracyDoubt::twist, 1.3, 80.0, 9.5}, later{AccuracyDoubt::twist, 1.4, 80.0, 9.5};
  const AccuracyReport other{AccuracyDoubt::compression, 1.5, 80.0, 9.5};
  record.doubts.add(1.5, first);
  record.doubts.add(2.0, AccuracyReport());
  record.doubts.add(2.5, later);
  record.doubts.add(3.5, first);
  record.doubts.add(4.5, other);
  const Simulator simulator(drilling_scene());
  const nlohmann::json expected = {{{"since", 1.5}, {"until", 3.5}, {"lasted", 1.0}, {"text", text_of(later)}},
                                   {{"since", 4.5}, {"until", 4.5}, {"lasted", 0.0}, {"text", text_of(other)}}};
  EXPECT_EQ(expected, summary_of(simulator, record, false)["accuracy_warnings"]);
  testing::internal::CaptureStdout();
  print_summary(simulator, Elapsed{9.0, 0.5}, record, Printed("si"));
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_NE(std::string::npos, text.find("accuracy warning, 1.0 s between 1.5 and 3.5 s: " + text_of(later) + "\n")) << text;
}

TEST(Summary, saysWhichLimitsWerePassed)
{
  RunRecord record;
  Truth m;
  StringLoads loads;
  m.time = 1.0;
  record.limits.add(m, loads, 1e6);
  m.time = 2.0;
  m.slack_line = true;
  record.limits.add(m, loads, 1e6);
  m.over_stress = true;
  m.slack_line = false;
  m.hook_load = 1.1e6;
  for (const auto& [time, share, from_bit] : {std::tuple{3.0, 1.5, 80.0}, {4.0, 1.25, 90.0}})
  {
    m.time = time;
    loads.stress = {share, from_bit};
    record.limits.add(m, loads, 1e6);
  }
  const Simulator simulator(drilling_scene());
  const nlohmann::json expected = {
      {{"flag", "slack_line"}, {"since", 2.0}, {"until", 2.0}, {"lasted", 0.0}},
      {{"flag", "over_stress"}, {"since", 3.0}, {"until", 4.0}, {"lasted", 1.0}, {"share", 1.5}, {"from_bit", 80.0}},
      {{"flag", "max_hook_load"}, {"since", 3.0}, {"until", 4.0}, {"lasted", 1.0}}};
  EXPECT_EQ(expected, summary_of(simulator, record, false)["limits_passed"]);
  testing::internal::CaptureStdout();
  print_summary(simulator, Elapsed{9.0, 0.5}, record, Printed("si"));
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_NE(std::string::npos, text.find("limit passed, 2.0 to 2.0 s: the lines carry nothing (slack_line)\n")) << text;
  EXPECT_NE(std::string::npos, text.find("limit passed, 3.0 to 4.0 s: pipe beyond its yield strength, at most 1.50 times it, 80 "
                                         "m above the bit (over_stress)\n"))
      << text;
}

TEST(Summary, withoutDrillingTellsWhatHangsAndTurns)
{
  RunRecord record;
  const Simulator simulator = after_two_seconds(steered_scene(), record, false);
  RunRecord hanging;
  hanging.latest.add(simulator.truth());
  testing::internal::CaptureStdout();
  print_summary(simulator, Elapsed{9.0, 0.5}, hanging, Printed("si"));
  const std::string text = testing::internal::GetCapturedStdout(), words = "hook load ";
  double load = 0.0, torque = 0.0;
  ASSERT_NE(std::string::npos, text.find(words));
  ASSERT_EQ(2, std::sscanf(text.c_str() + text.find(words), "hook load %lf kN, torque %lf kN m", &load, &torque)) << text;
  EXPECT_NEAR(simulator.truth().hook_load, 1e3 * load, 51.0);
  EXPECT_NEAR(simulator.truth().torque, 1e3 * torque, 5.1);
  EXPECT_GT(std::abs(torque), 0.0);
}

}  // namespace drill_rig_sim::test_tools_summary
