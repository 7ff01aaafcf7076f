// SPDX-License-Identifier: BSD-3-Clause
// The simulation loop without a master: what it hands over and when, commands from the mailbox, going back.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "running_loop.h"

namespace drill_rig_sim::test_ros_loop
{
namespace
{
ProgramStep pump_at(double time, double rate)
{
  ProgramStep line;
  line.at = time;
  line.flow = rate;
  return line;
}

Scene with_program()
{
  Scene scene = vertical_scene(30.0, 29.0);
  scene.program = {pump_at(0.0, 0.01), pump_at(0.05, 0.02), pump_at(0.08, 0.03)};
  return scene;
}

/// Stamps [in periods] of the outputs that have the flag set.
std::vector<std::int64_t> due(const std::vector<FrameOutput>& outputs, bool FrameOutput::*flag)
{
  std::vector<std::int64_t> stamps;
  for (const FrameOutput& s : outputs)
    if (s.*flag) stamps.push_back(s.frame.stamp / period);
  return stamps;
}

using Stamps = std::vector<std::int64_t>;
}  // namespace

TEST(Loop, startHandsOverTheWholePicture)
{
  RunningLoop rig(lockstep());
  rig.loop.subscriptions().markers = rig.loop.subscriptions().profile = rig.loop.subscriptions().tf = true;
  const FrameOutput s = rig.start();
  EXPECT_EQ(period, s.frame.stamp) << "never 0";
  EXPECT_EQ(RunState::waiting, s.frame.run_state);
  EXPECT_TRUE(s.new_stamp && s.rebuilt && s.state_due && s.tf_due && s.markers_due && s.profile_due && s.well_due);
  EXPECT_FALSE(s.state_again) << "it comes with a stamp";
  EXPECT_EQ(0.0, s.frame.truth.time);
  EXPECT_EQ(1.0, s.frame.loop.speed);
  EXPECT_EQ(0, s.frame.commands.last);
}

TEST(Loop, whatIsDrawnLiesOnTheWell)
{
  RunningLoop rig(lockstep());
  rig.loop.subscriptions().profile = rig.loop.subscriptions().tf = true;
  const FrameOutput s = rig.start();
  ASSERT_EQ(s.profile.md.size(), s.axis.size());
  for (std::size_t i = 0; i < s.axis.size(); ++i) EXPECT_NEAR(-s.profile.md[i], s.axis[i].position.z(), 1e-9);
  ASSERT_EQ(2u, s.stations.size());
  EXPECT_NEAR(-30.0, s.stations[1].position.z(), 1e-9);
  EXPECT_EQ(0.0, s.well.front().md);
  EXPECT_EQ(30.0, s.well.back().md);
  // 49 m of string: a bit of 0.3 m and six joints of 9.5 m, the last one cut; every fifth has a frame at its lower end
  const std::vector<std::pair<std::string, double>> parts = {{"bit", 0.0}, {"pipe_0", 0.3}, {"pipe_5", 0.3 + 5 * 9.5}};
  ASSERT_EQ(parts.size(), s.parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    EXPECT_EQ(parts[i].first, s.parts[i].name);
    EXPECT_NEAR(-29.0 + parts[i].second, s.parts[i].position.z(), 1e-3) << "it stretches by less than a millimetre";
  }
}

TEST(Loop, theDrawnWellHasAPointAMetreAndItsEnd)
{
  Scene scene = vertical_scene(30.0, 29.0);
  auto& survey = scene.well.survey;
  survey.insert(survey.begin() + 1, {{0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.5, 0.0, 0.0}, {2.25, 0.0, 0.0}, {29.75, 0.0, 0.0}});
  RunningLoop rig(lockstep(), scene);
  std::vector<double> drawn;
  for (const WellNode& node : rig.start().well) drawn.push_back(node.md);
  EXPECT_EQ((std::vector<double>{0.0, 1.0, 2.25, 29.75, 30.0}), drawn);
}

TEST(Loop, aStepIsSoManyFramesWithStampsOfOnePeriod)
{
  RunningLoop rig(lockstep());
  rig.start();
  const std::vector<FrameOutput> frames = rig.step(5);
  ASSERT_EQ(5u, frames.size());
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_EQ((2 + i) * period, frames[i].frame.stamp);
    EXPECT_DOUBLE_EQ(0.01 * (1 + i), frames[i].frame.truth.time);
    EXPECT_DOUBLE_EQ(0.01 * (1 + i), frames[i].frame.readings.time);
    EXPECT_DOUBLE_EQ(0.01 * (2 + i), frames[i].frame.loop.ticked_seconds);
    EXPECT_TRUE(frames[i].new_stamp && !frames[i].rebuilt);
    EXPECT_EQ(i < 4 ? RunState::running : RunState::waiting, frames[i].frame.run_state);
  }
  EXPECT_EQ(StepResult::End::complete, rig.result.end);
  EXPECT_EQ(5u, rig.result.frames);
  EXPECT_EQ(5u, frames[4].frame.loop.frame_times.number()) << "every frame is timed";
  EXPECT_EQ(0u, frames[4].frame.loop.lateness.number()) << "none has a time to begin at";
  EXPECT_TRUE(rig.step(0).empty());
  EXPECT_EQ(StepResult::End::complete, rig.result.end);
}

TEST(Loop, eachOutputComesAtItsRate)
{
  Parameters p = lockstep();
  p.state_rate = 25.0;
  p.drillstring_rate = 20.0;
  p.tf_rate = 10.0;
  p.marker_rate = 12.5;
  RunningLoop rig(p);
  rig.loop.subscriptions().markers = rig.loop.subscriptions().profile = rig.loop.subscriptions().tf = true;
  rig.start();  // at 1
  const std::vector<FrameOutput> frames = rig.step(20);
  EXPECT_EQ((Stamps{5, 9, 13, 17, 21}), due(frames, &FrameOutput::state_due));
  EXPECT_EQ((Stamps{6, 11, 16, 21}), due(frames, &FrameOutput::profile_due));
  EXPECT_EQ((Stamps{11, 21}), due(frames, &FrameOutput::tf_due));
  EXPECT_EQ((Stamps{9, 17}), due(frames, &FrameOutput::markers_due));
  EXPECT_EQ((Stamps{}), due(frames, &FrameOutput::well_due)) << "it has not grown";
  EXPECT_EQ((Stamps{}), due(frames, &FrameOutput::state_again));
}

TEST(Loop, theAccuracyComesOnceASecond)
{
  Scene scene = vertical_scene(30.0, 29.0);
  scene.numerics.companion = CompanionKind::finer;
  scene.numerics.tolerance = 0.03;
  scene.needs = need_torque;
  RunningLoop rig(lockstep(), scene);
  const FrameOutput start = rig.start();  // at 1
  EXPECT_TRUE(start.accuracy_due);
  EXPECT_EQ(0.03, start.frame.accuracy.tolerance);
  EXPECT_EQ(static_cast<unsigned>(need_torque), start.frame.accuracy.needs);
  rig.mailbox.receive(winch(0.1));
  const std::vector<FrameOutput> frames = rig.step(250);
  EXPECT_EQ((Stamps{101, 201}), due(frames, &FrameOutput::accuracy_due));
  const FrameRecord& last = frames.back().frame;
  EXPECT_TRUE(last.physics.error_is_measured);
  EXPECT_GT(last.accuracy.absolute_errors[0], 0.0) << "of the hook load, while the block is raised";
  EXPECT_GT(last.physics.companion.seconds, 0.0);
}

TEST(Loop, heavyOutputsComeWhereSomebodyLooks)
{
  RunningLoop rig(lockstep());
  rig.start();
  const std::vector<FrameOutput> frames = rig.step(30);
  EXPECT_EQ((Stamps{}), due(frames, &FrameOutput::markers_due));
  EXPECT_EQ((Stamps{}), due(frames, &FrameOutput::profile_due));
}

TEST(Loop, theWellIsHandedOverOncePerSecondWhereItGrows)
{
  Scene scene = drilling_scene(0.005);
  scene.start.bit_depth = 100.0;
  scene.start.weight_on_bit = 20e3;
  RunningLoop rig(lockstep(), scene);
  rig.loop.subscriptions().markers = true;
  EXPECT_TRUE(rig.start().tube_due);
  rig.mailbox.receive(winch(-0.01));
  TopDriveCommand turn;
  turn.speed = 9.0;
  rig.mailbox.receive(turn);
  const std::vector<FrameOutput> frames = rig.step(350);
  ASSERT_GT(frames.back().frame.truth.hole_depth, 100.005) << "it drills";
  const Stamps stamps = due(frames, &FrameOutput::well_due), pictures = due(frames, &FrameOutput::tube_due);
  ASSERT_GE(stamps.size(), 3u);
  ASSERT_GE(pictures.size() + 1, stamps.size()) << "that of the last may come later";
  for (std::size_t i = 0; i < pictures.size(); ++i)
  {
    EXPECT_GE(pictures[i], stamps[i]) << "the next picture shows the well that has grown";
    EXPECT_LT(pictures[i], stamps[i] + 20) << "at 5 Hz";
    EXPECT_EQ(frames[pictures[i] - 2].frame.truth.hole_depth, frames[pictures[i] - 2].well.back().md);
    EXPECT_TRUE(frames[pictures[i] - 2].markers_due);
  }
  for (std::size_t i = 1; i < stamps.size(); ++i) EXPECT_EQ(100, stamps[i] - stamps[i - 1]);
  for (const std::int64_t stamp : stamps) EXPECT_EQ(frames[stamp - 2].frame.truth.hole_depth, frames[stamp - 2].well.back().md);
}

TEST(Loop, theLatestCommandWinsAndIsStampedWhereItsFrameBegins)
{
  RunningLoop rig(lockstep());
  rig.start();
  rig.step(2);  // at 3
  rig.mailbox.receive(winch(0.1));
  rig.mailbox.receive(winch(0.2));
  rig.mailbox.receive(flow(0.03));
  const FrameRecord after = rig.step(1).back().frame;
  EXPECT_EQ(0.2, after.truth.setpoints.winch.block_velocity);
  EXPECT_EQ(0.03, after.truth.setpoints.pump.flow);
  EXPECT_EQ((std::array<std::int64_t, 4>{3 * period, 0, 3 * period, 0}), after.commands.accepted);
  EXPECT_EQ(3 * period, after.commands.last);
  TopDriveCommand turn;
  turn.speed = 1.0;
  rig.mailbox.receive(turn);
  const FrameRecord next = rig.step(1).back().frame;
  EXPECT_EQ((std::array<std::int64_t, 4>{3 * period, 4 * period, 3 * period, 0}), next.commands.accepted);
  EXPECT_EQ(4 * period, next.commands.last);
  EXPECT_EQ(0.2, rig.step(1).back().frame.truth.setpoints.winch.block_velocity) << "it stays in force";
}

// A broken publisher beside a good one: its commands must not take the place of those that no frame has taken yet.
TEST(Loop, aRefusedCommandLeavesTheGoodOneBeforeItAndIsToldAtOnce)
{
  RunningLoop rig(lockstep());
  rig.start();
  TopDriveCommand turn, unknown;
  turn.speed = 1.5;
  unknown.mode = 99;
  rig.mailbox.receive(winch(0.25));
  rig.mailbox.receive(winch(std::nan("")));
  rig.mailbox.receive(turn);
  rig.mailbox.receive(unknown);
  rig.mailbox.receive(flow(0.01));
  rig.mailbox.receive(flow(HUGE_VAL));
  EXPECT_EQ(3u, rig.mailbox.refusals().number()) << "before a frame";
  EXPECT_EQ("flow: must be finite", std::string(rig.mailbox.refusals().last()));
  const Setpoints asked = rig.step(1).back().frame.truth.setpoints;
  EXPECT_EQ(0.25, asked.winch.block_velocity);
  EXPECT_EQ(1.5, asked.top_drive.speed);
  EXPECT_EQ(0.01, asked.pump.flow);
  EXPECT_EQ(3u, rig.mailbox.refusals().number());
}

TEST(Loop, refusalsAndClampsAreCountedWithTheirReasons)
{
  RunningLoop rig(lockstep());
  rig.start();
  rig.mailbox.receive(winch(0.1));
  rig.step(1);
  rig.mailbox.receive(winch(std::nan("")));
  FrameRecord after = rig.step(1).back().frame;
  EXPECT_EQ(0.1, after.truth.setpoints.winch.block_velocity);
  EXPECT_EQ(1u, rig.mailbox.refusals().number());
  EXPECT_NE(std::string::npos, std::string(rig.mailbox.refusals().last()).find("block_velocity"));
  EXPECT_EQ(1 * period, after.commands.last) << "of the last accepted one";
  EXPECT_EQ("", std::string(after.last_clamp));
  rig.mailbox.receive(SteeringCommand());
  after = rig.step(1).back().frame;
  EXPECT_EQ(2u, rig.mailbox.refusals().number());
  EXPECT_EQ("steering: the string has no rotary_steerable", std::string(rig.mailbox.refusals().last()));
  rig.mailbox.receive(winch(9.0));
  after = rig.step(1).back().frame;
  EXPECT_EQ(1u, after.physics.commands_clamped);
  EXPECT_EQ(2u, rig.mailbox.refusals().number());
  EXPECT_NE(std::string::npos, std::string(after.last_clamp).find("block_velocity"));
  EXPECT_EQ(4 * period, after.commands.last) << "a clamped one is accepted";
}

TEST(Loop, anotherRigForgetsWhatWasOnTheWayAndBeginsItsRatesAnew)
{
  Parameters p = lockstep();
  p.state_rate = 25.0;
  RunningLoop rig(p);
  rig.start();
  rig.mailbox.receive(winch(0.1));
  rig.step(2);                      // at 3
  rig.mailbox.receive(winch(0.3));  // not taken yet
  rig.mailbox.receive(flow(0.03));
  TopDriveCommand turn;
  turn.speed = 1.0;
  rig.mailbox.receive(turn);
  const Scene other = vertical_scene(40.0, 39.0);
  const FrameOutput s = rig.between([&](SimulationLoop& loop) { loop.replace(std::make_unique<Simulator>(other)); });
  EXPECT_TRUE(s.rebuilt && s.new_stamp && s.state_due && s.well_due);
  EXPECT_EQ(4 * period, s.frame.stamp) << "time runs on";
  EXPECT_EQ(40.0, s.frame.truth.hole_depth);
  EXPECT_EQ(0, s.frame.commands.last);
  EXPECT_EQ((std::array<std::int64_t, 4>{}), s.frame.commands.accepted);
  const std::vector<FrameOutput> frames = rig.step(8);
  EXPECT_TRUE(frames[0].frame.truth.brake_set);
  EXPECT_EQ(0.0, frames[0].frame.truth.setpoints.pump.flow);
  EXPECT_EQ(0.0, frames[0].frame.truth.setpoints.top_drive.speed);
  EXPECT_EQ((Stamps{8, 12}), due(frames, &FrameOutput::state_due));
}

TEST(Loop, goingBackBringsStateAndProgramAndLeavesTheClock)
{
  Parameters p = lockstep();
  p.play_program = true;
  RunningLoop rig(p, with_program());
  rig.start();
  EXPECT_EQ(0.01, rig.step(3).back().frame.truth.setpoints.pump.flow);  // at 0.03 s
  std::shared_ptr<const SimulatorState> state;
  std::optional<ScenePlayer> player;
  const CommandStamps commands{7 * period, {0, 5 * period, 7 * period}};
  rig.loop.between_frames(
      [&](SimulationLoop& loop)
      {
        state = loop.rig().simulator->save();
        player = loop.rig().player;
      });
  std::vector<double> first;
  for (const FrameOutput& s : rig.step(8)) first.push_back(s.frame.truth.setpoints.pump.flow);
  EXPECT_EQ((std::vector<double>{0.01, 0.01, 0.02, 0.02, 0.02, 0.03, 0.03, 0.03}), first);  // lines of 0.05 s and 0.08 s
  rig.mailbox.receive(flow(0.05));
  EXPECT_EQ(0.05, rig.step(1).back().frame.truth.setpoints.pump.flow);  // at 13; the program is over
  rig.mailbox.receive(flow(0.06));                                      // not taken yet
  const FrameOutput back = rig.between([&](SimulationLoop& loop) { loop.go_back(*state, *player, true, commands); });
  EXPECT_EQ(14 * period, back.frame.stamp);
  EXPECT_TRUE(back.restored);
  EXPECT_EQ(7 * period, back.frame.commands.last) << "as they were saved";
  EXPECT_EQ((std::array<std::int64_t, 4>{0, 5 * period, 7 * period, 0}), back.frame.commands.accepted);
  EXPECT_DOUBLE_EQ(0.03, back.frame.truth.time);
  EXPECT_TRUE(back.new_stamp && !back.rebuilt);
  std::vector<double> again;
  for (const FrameOutput& s : rig.step(8)) again.push_back(s.frame.truth.setpoints.pump.flow);
  EXPECT_EQ(first, again);
  rig.between([&](SimulationLoop& loop) { loop.go_back(*state, *player, false, commands); });
  for (const FrameOutput& s : rig.step(8)) EXPECT_EQ(0.01, s.frame.truth.setpoints.pump.flow) << "as it was saved: not playing";
}

TEST(Loop, aCommandTakesOverFromTheProgram)
{
  Parameters p = lockstep();
  p.play_program = true;
  RunningLoop rig(p, with_program());
  rig.start();
  rig.step(1);
  rig.mailbox.receive(winch(0.1));
  EXPECT_EQ(0.01, rig.step(20).back().frame.truth.setpoints.pump.flow) << "no further line";
}

TEST(Loop, aProgramIsNotPlayedUnasked)
{
  RunningLoop rig(lockstep(), with_program());
  rig.start();
  EXPECT_EQ(0.0, rig.step(20).back().frame.truth.setpoints.pump.flow);
}

TEST(Loop, silenceOfAStreamIsNoticedAndThatOfAProgramIsNot)
{
  Parameters p = lockstep();
  p.play_program = true;
  p.command_timeout = 0.045;
  Scene scene = with_program();
  scene.program[0].block_velocity = 0.1;
  scene.program[0].top_drive_speed = 1.0;
  RunningLoop rig(p, scene);
  rig.start();
  EXPECT_FALSE(rig.step(30).back().frame.truth.commands_timed_out) << "a program speaks once per line";
  for (int i = 1; i < CommandStream::shortest; ++i)
  {
    rig.mailbox.receive(winch(0.1));
    rig.step(2);
  }
  rig.mailbox.receive(winch(0.1));
  const std::vector<FrameOutput> frames = rig.step(10);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(i >= 5, frames[i].frame.truth.commands_timed_out) << i << ": silent for i periods";
}

// A driller's click, a `rostopic pub -1`: each stands until the next one, however few there are.
TEST(Loop, aSingleCommandStands)
{
  Parameters p = lockstep();
  p.command_timeout = 0.045;
  RunningLoop rig(p, with_program());
  rig.start();
  for (int i = 1; i < CommandStream::shortest; ++i)
  {
    rig.mailbox.receive(winch(0.1));
    EXPECT_FALSE(rig.step(2).back().frame.truth.commands_timed_out) << i;
  }
  EXPECT_FALSE(rig.step(50).back().frame.truth.commands_timed_out);
  for (int i = 0; i < 3 * CommandStream::shortest; ++i)
  {
    rig.mailbox.receive(winch(0.1));
    EXPECT_FALSE(rig.step(3).back().frame.truth.commands_timed_out) << i << ": each later than half the timeout";
  }
  const FrameOutput last = rig.step(50).back();
  EXPECT_FALSE(last.frame.truth.commands_timed_out || last.frame.truth.brake_set);
  EXPECT_EQ(0.1, last.frame.truth.setpoints.winch.block_velocity);
}

// The console's button that is let go: ten commands a second, then a speed of 0.
TEST(Loop, aStreamThatStopsWhatItMovedIsAtItsEnd)
{
  Parameters p = lockstep();
  p.command_timeout = 0.045;
  RunningLoop rig(p, with_program());
  rig.start();
  for (int i = 0; i < 10; ++i)
  {
    rig.mailbox.receive(winch(0.1));
    rig.step(1);
  }
  rig.mailbox.receive(winch(0.0));
  EXPECT_FALSE(rig.step(50).back().frame.truth.commands_timed_out);
}

// Nobody lets a frame begin for 0.4 s: a tenth of a second is caught up, the rest is dropped and counted.
// The scene's latency lies between measurement and surface, to the frame; the stamp is the measurement's.
}  // namespace drill_rig_sim::test_ros_loop
