// SPDX-License-Identifier: BSD-3-Clause
// What diagnostics say of a frame: each condition alone, its level and its words; the real-time factor and the histogram by hand.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>

#include "drill_rig_sim/ros/diagnostics_report.h"
#include "numbered_frame.h"

namespace drill_rig_sim::test_ros_diagnostics
{
namespace
{
using diagnostic_msgs::DiagnosticStatus;

constexpr std::int64_t ms = 1'000'000, second = 1'000 * ms, start = 77 * second;

FrameRecord sound_frame()
{
  FrameRecord frame = numbered_record();
  frame.physics.level = "beam3d";
  frame.physics.integrator = "auto_one";
  frame.physics.kernel = Kernel::sse4;
  return frame;
}

const DiagnosticStatus& part(const diagnostic_msgs::DiagnosticArray& array, const std::string& name)
{
  for (const DiagnosticStatus& s : array.status)
    if (s.name == "rig/node: " + name) return s;
  throw std::runtime_error("no part " + name);
}

std::map<std::string, std::string> values(const diagnostic_msgs::DiagnosticArray& array)
{
  std::map<std::string, std::string> all;
  for (const DiagnosticStatus& s : array.status)
    for (const auto& pair : s.values) EXPECT_TRUE(all.emplace(pair.key, pair.value).second) << pair.key << " twice";
  return all;
}

double number(const diagnostic_msgs::DiagnosticArray& array, const std::string& key)
{
  return std::stod(values(array).at(key));
}

/// The levels of time, physics, accuracy, commands.
std::vector<int> levels(const diagnostic_msgs::DiagnosticArray& array)
{
  return {part(array, "time").level, part(array, "physics").level, part(array, "accuracy").level, part(array, "commands").level};
}

constexpr int ok = DiagnosticStatus::OK, warn = DiagnosticStatus::WARN, error = DiagnosticStatus::ERROR;
const std::vector<int> all_well = {ok, ok, ok, ok};

class Report : public testing::Test
{
protected:
  DiagnosticsReport report_{"rig/node"};
  FrameRecord frame_ = sound_frame();
  Refusals refusals_;
  std::int64_t now_ = start;

  diagnostic_msgs::DiagnosticArray next(const std::string& trouble = "")
  {
    now_ += second;
    return report_.on(frame_, refusals_, trouble, now_);
  }
};

/// What the frame of eachNumberIsItsOwn says, by key.
const std::map<std::string, double> own_numbers = {{"simulated_time", 123.5},
                                                   {"speed", 2.5},
                                                   {"overruns", 22},
                                                   {"dropped_seconds", 0.75},
                                                   {"unpublished_frames", 23},
                                                   {"longest_frame_ms", 24.5},
                                                   {"longest_lateness_ms", 0.5},
                                                   {"pictures_left_out", 25},
                                                   {"frame_time_p50_ms", 24.5},
                                                   {"frame_time_p99_ms", 24.5},
                                                   {"frame_time_p99.9_ms", 24.5},
                                                   {"frame_time_p99.99_ms", 24.5},
                                                   {"frame_time_share_below_1_ms", 0.0},
                                                   {"frame_time_share_below_period", 1.0},
                                                   {"lateness_p50_ms", 0.5},
                                                   {"lateness_p99_ms", 0.5},
                                                   {"lateness_p99.9_ms", 0.5},
                                                   {"lateness_p99.99_ms", 0.5},
                                                   {"lateness_share_below_1_ms", 1.0},
                                                   {"lateness_share_below_period", 0.0},
                                                   {"step", 0.005},
                                                   {"last_step", 0.0025},
                                                   {"nodes", 11},
                                                   {"coordinates", 12},
                                                   {"frames", 13},
                                                   {"steps", 20},
                                                   {"newton_iterations", 50},
                                                   {"newton_iterations_per_step", 2.5},
                                                   {"convergence_failures", 16},
                                                   {"error_test_failures", 17},
                                                   {"error_estimate", 1.8e-5},
                                                   {"clamped", 19},
                                                   {"refused", 21},
                                                   {"yield_share", 0.31},
                                                   {"yield_from_bit", 32.0},
                                                   {"pull_to_yield", 9.3e5},
                                                   {"make_up_share", 0.33},
                                                   {"make_up_from_bit", 34.0},
                                                   {"buckling_share", 0.35},
                                                   {"buckling_from_bit", 36.0},
                                                   {"error_window", 3.0},
                                                   {"tolerance", 0.02},
                                                   {"companion_cost_share", 0.0}};
const std::map<std::string, std::string> own_words = {{"state", "running"},
                                                      {"level", "beam3d"},
                                                      {"integrator", "auto_one"},
                                                      {"kernel", "sse4"},
                                                      {"last_refusal", "a refusal"},
                                                      {"last_clamp", "a clamp"},
                                                      {"measured_errors", ""},
                                                      {"companion", ""},
                                                      {"why_not_measured", "no frame has been compared yet"},
                                                      {"reason_code", ""},
                                                      {"active_faults", "pump_trip"}};
}  // namespace

TEST_F(Report, allIsWell)
{
  const auto array = next();
  EXPECT_EQ(ros::Time(12, 345678901), array.header.stamp);
  ASSERT_EQ(4u, array.status.size());
  EXPECT_EQ(all_well, levels(array));
  EXPECT_EQ("running", part(array, "time").message);
  EXPECT_EQ("solved", part(array, "physics").message);
  EXPECT_EQ("obeyed", part(array, "commands").message);
  for (const DiagnosticStatus& s : array.status) EXPECT_EQ("rig/node", s.hardware_id);
}

TEST_F(Report, eachNumberIsItsOwn)
{
  SimulatorStatistics& p = frame_.physics;
  p.step = 0.005;
  p.last_step = 0.0025;
  p.nodes = 11;
  p.coordinates = 12;
  p.frames = 13;
  p.steps = 20;
  p.newton_iterations = 50;
  p.convergence_failures = 16;
  p.error_test_failures = 17;
  p.last_error_estimate = 1.8e-5;
  p.commands_clamped = 19;
  p.loads = {{0.31, 32.0}, {0.33, 34.0}, {0.35, 36.0}, 9.3e5};
  frame_.accuracy.tolerance = 0.02;
  for (int i = 0; i < 21; ++i) refusals_.count(i < 20 ? "an older one" : "a refusal");
  frame_.loop.ticked_seconds = 123.5;
  frame_.loop.speed = 2.5;
  frame_.loop.overruns = 22;
  frame_.loop.dropped_seconds = 0.75;
  frame_.loop.unpublished_frames = 23;
  frame_.loop.pictures_left_out = 25;
  frame_.loop.frame_times.add(24'500'000, 24'500'001);
  frame_.loop.lateness.add(500'000, 400'000);
  frame_.last_clamp = "a clamp";
  frame_.faults.of_rig = 1u << static_cast<int>(FaultKind::pump_trip);
  const auto array = next();
  for (const auto& [key, value] : own_numbers) EXPECT_DOUBLE_EQ(value, number(array, key)) << key;
  for (const auto& [key, value] : own_words) EXPECT_EQ(value, values(array).at(key)) << key;
  EXPECT_EQ(own_numbers.size() + own_words.size() + 2, values(array).size())
      << "and two histograms; a real-time factor needs half a second";
}

TEST_F(Report, saysWhyTheNumbersMayBeWrong)
{
  frame_.truth.accuracy_warning = true;
  frame_.physics.accuracy = {AccuracyDoubt::twist, 1.2, 80.0, 9.5};
  const auto array = next();
  EXPECT_EQ(text_of(frame_.physics.accuracy), part(array, "accuracy").message);
  EXPECT_EQ((std::vector<int>{ok, ok, warn, ok}), levels(array));
}

TEST_F(Report, saysHowLargeTheMeasuredErrorsAre)
{
  frame_.physics.error_is_measured = true;
  frame_.physics.errors = {0.00314, 0.0125, 0.5, 0.104, 0.3, 5e-6};
  frame_.physics.companion = {"beam3d", 181, 1086, 3.0};
  frame_.accuracy.needs = need_hook_load | need_torque | need_rop | need_pressure | need_direction;
  frame_.accuracy.tolerance = 0.02;
  const auto array = next();
  const std::string errors =
      "hook load 0.31 %, torque 1.2 %, rate of penetration 10 %, stand pipe pressure below 0.01 % (allowed 2 %)";
  EXPECT_EQ("measured errors, relative to the ranges: " + errors, part(array, "accuracy").message);
  EXPECT_EQ(all_well, levels(array)) << "whether that is too much is for the simulator to say";
  const auto said = values(array);
  EXPECT_EQ(errors, said.at("measured_errors"));
  EXPECT_EQ("beam3d, 181 nodes, 1086 coordinates", said.at("companion"));
  EXPECT_EQ("", said.at("why_not_measured"));
  const std::map<std::string, double> numbers = {
      {"error_hook_load", 0.00314}, {"error_torque", 0.0125}, {"error_wob", 0.5},
      {"error_rop", 0.104},         {"error_bit_speed", 0.3}, {"error_stand_pipe_pressure", 5e-6},
      {"error_window", 3.0},        {"tolerance", 0.02},      {"companion_cost_share", 1.0}};
  for (const auto& [key, value] : numbers) EXPECT_DOUBLE_EQ(value, number(array, key)) << key;
  frame_.accuracy.needs = need_direction;
  EXPECT_EQ("measured errors, relative to the ranges: none for the outputs in `needs`", part(next(), "accuracy").message);
}

TEST_F(Report, saysWhyNoErrorIsMeasured)
{
  frame_.physics.companion = {"beam3d", 181, 0, 0.0};
  auto array = next();
  EXPECT_EQ("error not measured: no frame has been compared yet", part(array, "accuracy").message);
  EXPECT_EQ("beam3d, 181 nodes", values(array).at("companion"));
  EXPECT_EQ(0u, values(array).count("error_torque"));
  EXPECT_EQ("", values(array).at("measured_errors"));
  EXPECT_EQ(0.0, number(array, "companion_cost_share"));
  frame_.physics.not_measured = "the companion is not in the snapshot";
  array = next();
  EXPECT_EQ("error not measured: the companion is not in the snapshot", part(array, "accuracy").message);
  EXPECT_EQ("the companion is not in the snapshot", values(array).at("why_not_measured"));
  EXPECT_EQ(all_well, levels(array));
}

TEST_F(Report, aMotorThatDoesNotFitIsTold)
{
  frame_.physics.tight = TightAssembly{58e3, 8e3, 0.03};
  const auto array = next();
  EXPECT_EQ(text_of(*frame_.physics.tight), part(array, "physics").message);
  EXPECT_EQ((std::vector<int>{ok, warn, ok, ok}), levels(array));
}

TEST_F(Report, anOpenReliefValveIsTold)
{
  frame_.truth.relief_valve_open = true;
  EXPECT_EQ(part(next(), "physics").message, "relief valve open: part of the flow goes back to the tanks");
}

TEST_F(Report, withoutAStepThereAreNoIterationsPerStep)
{
  EXPECT_EQ(0.0, number(next(), "newton_iterations_per_step"));
}

TEST_F(Report, statesAreNamed)
{
  for (const auto& [state, word] : std::map<RunState, std::string>{
           {RunState::running, "running"}, {RunState::paused, "paused"}, {RunState::waiting, "waiting for a step"}})
  {
    frame_.run_state = state;
    const auto array = next();
    EXPECT_EQ(word, part(array, "time").message);
    EXPECT_EQ(word, values(array).at("state"));
    EXPECT_EQ(all_well, levels(array)) << word;
  }
}

TEST_F(Report, aFailedFrameIsAnErrorAndSaysWhy)
{
  frame_.run_state = RunState::failed;
  std::snprintf(frame_.failure.data(), frame_.failure.size(), "no solution at 3 s");
  const auto array = next();
  EXPECT_EQ((std::vector<int>{ok, error, ok, ok}), levels(array));
  EXPECT_EQ("simulation stopped at the last good state: no solution at 3 s", part(array, "physics").message);
  EXPECT_EQ("failed", part(array, "time").message);
}

TEST_F(Report, backlogDroppedSinceTheLastReportIsAWarning)
{
  frame_.loop.dropped_seconds = 0.25;
  const auto array = next();
  EXPECT_EQ((std::vector<int>{warn, ok, ok, ok}), levels(array));
  EXPECT_EQ("running, slower than the requested speed", part(array, "time").message);
  EXPECT_EQ(all_well, levels(next())) << "nothing since";
  frame_.loop.dropped_seconds = 0.26;
  EXPECT_EQ(warn, part(next(), "time").level);
}

TEST_F(Report, troubleWithTheClockIsAWarning)
{
  const auto array = next("two nodes publish /clock");
  EXPECT_EQ((std::vector<int>{warn, ok, ok, ok}), levels(array));
  EXPECT_EQ("two nodes publish /clock", part(array, "time").message);
  EXPECT_EQ(all_well, levels(next()));
}

TEST_F(Report, aCommandRefusedSinceTheLastReportIsAWarning)
{
  refusals_.count("flow is not finite");
  const auto array = next();
  EXPECT_EQ((std::vector<int>{ok, ok, ok, warn}), levels(array));
  EXPECT_EQ("refused: flow is not finite", part(array, "commands").message);
  EXPECT_EQ(all_well, levels(next()));
}

TEST_F(Report, aCommandClampedNowOrSinceTheLastReportIsAWarning)
{
  frame_.last_clamp = "speed";
  frame_.truth.command_clamped = true;  // the last command is at a limit still
  for (int i = 0; i < 2; ++i)
  {
    const auto array = next();
    EXPECT_EQ((std::vector<int>{ok, ok, ok, warn}), levels(array));
    EXPECT_EQ("beyond a limit: speed", part(array, "commands").message);
  }
  frame_.truth.command_clamped = false;
  EXPECT_EQ(all_well, levels(next()));
  frame_.physics.commands_clamped = 2;  // two were, between two reports
  EXPECT_EQ("beyond a limit: speed", part(next(), "commands").message);
  EXPECT_EQ(all_well, levels(next()));
  frame_.physics.commands_clamped = 1;  // one of another rig
  EXPECT_EQ("beyond a limit: speed", part(next(), "commands").message);
  frame_.physics.commands_clamped = 0;
  EXPECT_EQ(all_well, levels(next()));
}

TEST_F(Report, aStreamThatStoppedIsAWarning)
{
  frame_.truth.commands_timed_out = true;
  const auto array = next();
  EXPECT_EQ((std::vector<int>{ok, ok, ok, warn}), levels(array));
  EXPECT_EQ("no commands for winch or top drive: brake set, drive coasts until commands arrive", part(array, "commands").message);
}

TEST_F(Report, twoSendersAreAWarning)
{
  const auto array = report_.on(frame_, refusals_, "", now_, "2 nodes publish /rig/winch/command: /a, /b");
  EXPECT_EQ((std::vector<int>{ok, ok, ok, warn}), levels(array));
  EXPECT_EQ("2 nodes publish /rig/winch/command: /a, /b", part(array, "commands").message);
  EXPECT_EQ(all_well, levels(next()));
}

TEST(CommandSenders, areTwoWhileBothAreHeard)
{
  CommandSenders senders;
  const ros::SteadyTime begin(1000.0);
  const auto after = [&](double seconds) { return begin + ros::WallDuration(seconds); };
  senders.note("winch/command", "/a", after(0.0));
  senders.note("winch/command", "/a", after(1.0));
  senders.note("top_drive/command", "/b", after(1.0));
  EXPECT_EQ("", senders.trouble(after(1.0))) << "each has a topic of its own";
  senders.note("winch/command", "/c", after(2.0));
  EXPECT_EQ("2 nodes publish winch/command: /a, /c", senders.trouble(after(2.0)));
  senders.note("top_drive/command", "/a", after(3.0));
  senders.note("top_drive/command", "/c", after(3.0));
  EXPECT_EQ("3 nodes publish top_drive/command: /a, /b, /c; 2 nodes publish winch/command: /a, /c", senders.trouble(after(3.0)));
  EXPECT_EQ("2 nodes publish top_drive/command: /a, /c", senders.trouble(after(7.5))) << "what is older than 5 s is forgotten";
  EXPECT_EQ("", senders.trouble(after(9.0)));
}

TEST_F(Report, realTimeFactorIsSimulatedOverWallSeconds)
{
  frame_.loop.ticked_seconds = 10.0;
  EXPECT_EQ(0u, values(next()).count("real_time_factor")) << "nothing to compare with";
  frame_.loop.ticked_seconds = 10.75;  // 0.75 s in a wall second
  EXPECT_DOUBLE_EQ(0.75, number(next(), "real_time_factor"));
  frame_.loop.ticked_seconds = 13.75;
  EXPECT_DOUBLE_EQ(3.0, number(next(), "real_time_factor"));
}

TEST(RealTimeFactor, needsHalfASecondAndLeavesPausesOut)
{
  RealTimeFactor factor;
  EXPECT_FALSE(factor.update(5.0, RunState::running, start));
  EXPECT_FALSE(factor.update(5.25, RunState::running, start + 499 * ms));
  EXPECT_DOUBLE_EQ(0.5, *factor.update(5.25, RunState::running, start + 500 * ms));
  EXPECT_DOUBLE_EQ(0.5, *factor.update(5.5, RunState::running, start + 600 * ms)) << "the last one until the next half second";
  for (const RunState standing : {RunState::paused, RunState::failed})
  {
    RealTimeFactor other;
    other.update(1.0, RunState::running, start);
    EXPECT_DOUBLE_EQ(1.0, *other.update(2.0, RunState::running, start + second));
    EXPECT_DOUBLE_EQ(0.0, *other.update(2.0, standing, start + 11 * second));
    EXPECT_DOUBLE_EQ(0.0, *other.update(2.1, RunState::running, start + 30 * second)) << "begins anew where it goes on";
    EXPECT_DOUBLE_EQ(0.5, *other.update(2.6, RunState::running, start + 31 * second));
  }
}

TEST_F(Report, histogramsNameEachBinWhichBeginsAtItsBound)
{
  const std::vector<std::int64_t> bins = {100'000, 200'000, 500'000, ms,    2 * ms,
                                          5 * ms,  10 * ms, 20 * ms, second};  // where each ends
  for (std::size_t i = 0; i < bins.size(); ++i)
  {
    for (std::size_t n = 0; n < 31 + i; ++n) frame_.loop.frame_times.add(n == 0 && i > 0 ? bins[i - 1] : bins[i] - 1, ms);
    for (std::size_t n = 0; n < 51 + i; ++n) frame_.loop.lateness.add(n == 0 && i > 0 ? bins[i - 1] : bins[i] - 1, ms);
  }
  const auto array = next();
  EXPECT_EQ(
      "< 0.1 ms: 31, < 0.2 ms: 32, < 0.5 ms: 33, < 1 ms: 34, < 2 ms: 35, < 5 ms: 36, < 10 ms: 37, < 20 ms: 38, >= 20 ms: 39",
      values(array).at("frame_times"));
  EXPECT_EQ(
      "< 0.1 ms: 51, < 0.2 ms: 52, < 0.5 ms: 53, < 1 ms: 54, < 2 ms: 55, < 5 ms: 56, < 10 ms: 57, < 20 ms: 58, >= 20 ms: 59",
      values(array).at("latenesses"));
}

}  // namespace drill_rig_sim::test_ros_diagnostics
