// SPDX-License-Identifier: BSD-3-Clause
// The simulation loop and time: a frame that fails, pauses, steps that end early, backlog, what is not taken, telemetry's
// latency, another rig's clock.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

#include "drill_rig_sim/ros/frame_messages.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "in_source.h"
#include "running_loop.h"

namespace drill_rig_sim::test_ros_loop_time
{
namespace
{
std::uint64_t ring_count(SimulationLoop& loop, const FrameRing& ring)
{
  std::uint64_t all = 0;
  loop.between_frames([&](SimulationLoop&) { all = ring.handed_over(); });
  return all;
}
}  // namespace

TEST(LoopTime, aFrameThatFailsIsSaidOnceWithTheLastGoodStamp)
{
  Parameters p = lockstep();
  p.rate = 20.0;
  p.play_program = true;
  p.state_rate = 2.0;
  RunningLoop rig(p, read_scene(in_source("test/scenes/unsolvable.yaml")));
  rig.start();
  const std::vector<FrameOutput> frames = rig.step(1000);
  ASSERT_EQ(StepResult::End::failed, rig.result.end);
  ASSERT_GE(frames.size(), 2u);
  EXPECT_EQ(frames.size(), rig.result.frames);
  const FrameOutput &last = frames.back(), &good = frames[frames.size() - 2];
  EXPECT_EQ(RunState::failed, last.frame.run_state);
  EXPECT_EQ(RunState::running, good.frame.run_state);
  EXPECT_EQ(good.frame.stamp, last.frame.stamp);
  EXPECT_TRUE(!last.new_stamp && last.state_again && !last.state_due && !last.tf_due);
  EXPECT_NE("", std::string(last.frame.failure.data()));
  EXPECT_EQ("", std::string(good.frame.failure.data()));
  EXPECT_FALSE(rig.between([](SimulationLoop& loop) { loop.set_paused(true); }).state_again) << "once";
  const FrameOutput reset =
      rig.between([](SimulationLoop& loop) { loop.replace(std::make_unique<Simulator>(vertical_scene(40.0, 39.0))); });
  EXPECT_EQ(RunState::waiting, reset.frame.run_state);
  EXPECT_EQ("", std::string(reset.frame.failure.data()));
  EXPECT_EQ(last.frame.stamp + 5 * period, reset.frame.stamp);
}

TEST(LoopTime, pauseIsSaidOnceWithTheSameStamp)
{
  RunningLoop rig(in_real_time());
  rig.start();
  rig.output(5);
  FrameOutput before;
  const FrameOutput paused = rig.between(
      [&](SimulationLoop& loop)
      {
        before.frame.stamp = loop.time().stamp();
        loop.set_paused(true);
      });
  EXPECT_EQ(RunState::paused, paused.frame.run_state);
  EXPECT_EQ(before.frame.stamp, paused.frame.stamp);
  EXPECT_TRUE(!paused.new_stamp && paused.state_again && !paused.state_due);
  EXPECT_FALSE(rig.between([](SimulationLoop& loop) { loop.set_paused(true); }).state_again);
  const FrameOutput resumed = rig.between([](SimulationLoop& loop) { loop.set_paused(false); });
  EXPECT_EQ(RunState::running, resumed.frame.run_state);
  EXPECT_TRUE(resumed.state_again);
  EXPECT_EQ(before.frame.stamp, resumed.frame.stamp);
}

// A tare between frames shows at once.
TEST(LoopTime, whilePausedWhatHasChangedIsSaidAgain)
{
  RunningLoop rig(in_real_time());
  rig.start();
  EXPECT_FALSE(rig.between([](SimulationLoop& loop) { loop.hand_over_again(); }).state_again) << "the next frame says it";
  const FrameOutput paused = rig.between([](SimulationLoop& loop) { loop.set_paused(true); });
  const FrameOutput again = rig.between(
      [](SimulationLoop& loop)
      {
        EXPECT_TRUE(loop.rig().simulator->tare());
        loop.hand_over_again();
      });
  EXPECT_TRUE(again.state_again && !again.new_stamp && !again.state_due);
  EXPECT_EQ(paused.frame.stamp, again.frame.stamp);
  EXPECT_TRUE(!paused.frame.readings.tared && again.frame.readings.tared && again.frame.truth.tared);
}

TEST(LoopTime, inLockstepToo)
{
  RunningLoop rig(lockstep());
  rig.start();
  EXPECT_TRUE(rig.between([](SimulationLoop& loop) { loop.hand_over_again(); }).state_again);
}

TEST(LoopTime, whileTimeStandsARefreshIsOnePicture)
{
  RunningLoop rig(lockstep());
  const FrameOutput first = rig.start();
  rig.loop.subscriptions().markers = true;
  rig.loop.refresh();
  const FrameOutput picture = rig.output(1);
  EXPECT_EQ(first.frame.stamp, picture.frame.stamp);
  EXPECT_TRUE(!picture.new_stamp && picture.markers_due && picture.well_due && !picture.state_due && !picture.tf_due &&
              !picture.profile_due);
  EXPECT_FALSE(picture.state_again);
  EXPECT_EQ(2u, rig.count());
}

TEST(LoopTime, aStepEndsEarlyWhereItIsAskedTo)
{
  RunningLoop rig(lockstep());
  rig.start();
  EXPECT_FALSE(rig.loop.end_step_early()) << "none is under way";
  rig.loop.between_frames([](SimulationLoop& loop) { loop.begin_step(100000); });
  rig.output(10);
  std::int64_t stamp = 0;
  const FrameOutput end = rig.between(
      [&](SimulationLoop& loop)
      {
        stamp = loop.time().stamp();
        EXPECT_TRUE(loop.end_step_early());
      });
  EXPECT_EQ(RunState::waiting, end.frame.run_state);
  EXPECT_TRUE(end.state_again && !end.new_stamp);
  EXPECT_EQ(stamp, end.frame.stamp);
  const StepResult result = rig.loop.wait_for_step();
  EXPECT_EQ(StepResult::End::ended_early, result.end);
  EXPECT_EQ((stamp - period) / period, result.frames);
  EXPECT_EQ(1u + result.frames + 1u, result.handed_over) << "the start, the frames, the end";
}

TEST(LoopTime, backlogIsDroppedAndCounted)
{
  RunningLoop rig(in_real_time());
  rig.start();
  rig.output(5);
  std::size_t next = 0;
  rig.loop.between_frames(
      [&](SimulationLoop&)
      {
        next = rig.ring.handed_over();
        std::this_thread::sleep_for(std::chrono::milliseconds(400));
      });
  const FrameRecord before = rig.output(next - 1).frame, after = rig.output(next).frame;
  EXPECT_GE(after.loop.dropped_seconds - before.loop.dropped_seconds, 0.4 - 0.1 - 0.01) << "due at most a period after it stood";
  EXPECT_GE(after.loop.overruns, before.loop.overruns + 1);
  EXPECT_GE(after.loop.lateness.longest(), 0.4 - 0.01) << "the whole of it, not what is caught up";
  EXPECT_EQ(before.loop.lateness.number() + 1, after.loop.lateness.number());
  EXPECT_EQ(after.loop.lateness.number(), after.loop.frame_times.number()) << "every frame of real time has both";
  EXPECT_EQ(before.stamp + period, after.stamp) << "simulated time falls behind, no frame is left out";
}

TEST(LoopTime, framesThatNobodyTakesAreCounted)
{
  const Parameters p = in_real_time();
  Mailbox mailbox;
  FrameRing ring(4);
  SimulationLoop loop(p, std::make_unique<Simulator>(vertical_scene(30.0, 29.0)), mailbox, ring);
  loop.start();
  std::uint64_t computed = 0;
  while (computed < 20) loop.between_frames([&](SimulationLoop& l) { computed = l.rig().simulator->statistics().frames; });
  const auto take = [&]
  {
    const FrameRecord frame = ring.next()->frame;
    ring.release();
    return frame;
  };
  FrameRecord last = take();
  for (int i = 0; i < 3; ++i) last = take();
  EXPECT_EQ(4 * period, last.stamp);
  EXPECT_EQ(0u, last.loop.unpublished_frames);
  const FrameRecord after = take();
  EXPECT_GE(after.loop.unpublished_frames, 17u);
  EXPECT_EQ(after.stamp - last.stamp, static_cast<std::int64_t>(after.loop.unpublished_frames + 1) * period)
      << "each missing stamp is counted";
  loop.halt();
  loop.join();
}

// A slow publisher misses pictures before it misses readings.
TEST(LoopTime, picturesThatFindNoRoomAreLeftOutAndCounted)
{
  Parameters p = in_real_time();
  p.drillstring_rate = p.rate;
  Mailbox mailbox;
  FrameRing ring(64, 2);
  SimulationLoop loop(p, std::make_unique<Simulator>(vertical_scene(30.0, 29.0)), mailbox, ring);
  loop.subscriptions().profile = true;
  loop.start();
  while (ring_count(loop, ring) < 20) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  loop.halt();
  loop.join();
  for (std::int64_t i = 1; i <= 20; ++i)
  {
    const FrameOutput* s = ring.next();
    EXPECT_EQ(i * period, s->frame.stamp);
    EXPECT_TRUE(s->state_due);
    EXPECT_EQ(i <= 2, s->profile_due) << i;
    EXPECT_EQ(i <= 2, !s->profile.md.empty()) << i;
    EXPECT_EQ(i <= 2 ? 0u : static_cast<std::uint64_t>(i) - 2, s->frame.loop.pictures_left_out);
    EXPECT_EQ(0u, s->frame.loop.unpublished_frames);
    ring.release();
  }
}

TEST(LoopTime, telemetryArrivesByItsLatencyLater)
{
  Scene scene = vertical_scene(60.0, 50.0);
  scene.string.insert(scene.string.begin() + 1, mwd_part());
  scene.instruments.mwd.latency = 0.25;
  scene.rig.mud_pump.flow_ramp = 1e3;
  scene.mud.bulk_modulus = 1e11;
  scene.instruments.toolface.latency = 0.07;
  RunningLoop rig(lockstep(), scene);
  rig.start();  // at 1
  rig.mailbox.receive(flow(0.02));
  const std::vector<FrameOutput> frames = rig.step(40);  // it flows from the first on, measured at its end: at 2
  for (const FrameOutput& s : frames)
  {
    EXPECT_EQ(s.frame.stamp >= 2 * period + 250 * ms ? 1u : 0u, s.frame.readings.mwd.sequence) << s.frame.stamp;
    EXPECT_EQ(s.frame.stamp >= 2 * period + 70 * ms ? 1u : 0u, s.frame.readings.toolface.sequence) << s.frame.stamp;
  }
  const FrameRecord& last = frames.back().frame;
  EXPECT_EQ(ros::Time().fromNSec(2 * period), to_mwd_survey(last, "").header.stamp);
  EXPECT_EQ(ros::Time().fromNSec(2 * period), to_mwd_toolface(last, "").header.stamp);
  FrameRecord early = last;  // as after a restored state in a node that has just started
  early.stamp = period;
  EXPECT_EQ(ros::Time(), to_mwd_survey(early, "").header.stamp);
  EXPECT_EQ(ros::Time(), to_mwd_toolface(early, "").header.stamp);
  EXPECT_NEAR(50.0 - 0.3 - 4.0, last.readings.mwd.md, 1e-3) << "a bit of 0.3 m and the sensor's offset above it";
}

TEST(LoopTime, aFollowerWaitsForTheClockAndGoesWithIt)
{
  Parameters p;
  p.publish_clock = false;
  p.use_sim_time = true;
  RunningLoop rig(p);
  const FrameOutput silent = rig.start();
  EXPECT_FALSE(silent.new_stamp) << "no stamp before the clock is heard";
  EXPECT_FALSE(silent.state_due);
  rig.loop.hear_clock(35 * ms);
  for (int i = 1; i <= 3; ++i)
  {
    const FrameOutput s = rig.output(i);
    EXPECT_EQ(i * period, s.frame.stamp);
    EXPECT_EQ(i == 1, s.rebuilt) << "the first with a stamp announces the rig";
  }
  EXPECT_EQ(4u, rig.count());
}

// Nothing is made without a subscriber; the first one gets it, also while time stands.
TEST(LoopTime, framesOfTheStringAreMadeForWhoeverAsksForThem)
{
  RunningLoop rig(lockstep());
  rig.start();
  for (const FrameOutput& s : rig.step(20)) EXPECT_FALSE(s.tf_due);
  rig.loop.subscriptions().tf = rig.loop.subscriptions().tf_missing = true;
  rig.loop.refresh();
  const FrameOutput picture = rig.output(21);
  EXPECT_TRUE(picture.tf_due && !picture.new_stamp && !picture.parts.empty());
  rig.loop.refresh();
  EXPECT_FALSE(rig.output(22).tf_due) << "no stamp is sent twice";
}

TEST(LoopTime, theStringToo)
{
  RunningLoop rig(lockstep());
  rig.start();
  rig.loop.subscriptions().profile = rig.loop.subscriptions().profile_missing = true;
  rig.loop.refresh();
  const FrameOutput picture = rig.output(1);
  EXPECT_TRUE(picture.profile_due && !picture.new_stamp && !picture.profile.md.empty());
  rig.loop.refresh();
  EXPECT_FALSE(rig.output(2).profile_due) << "no stamp is sent twice";
  rig.loop.subscriptions().profile_missing = true;
  const std::vector<FrameOutput> frames = rig.step(20);
  EXPECT_EQ(2, std::count_if(frames.begin(), frames.end(), [](const FrameOutput& s) { return s.profile_due; }))
      << "while time runs on at its rate alone";
  EXPECT_FALSE(rig.loop.subscriptions().profile_missing);
}

TEST(LoopTime, aPauseShowsTheStringAsItStands)
{
  RunningLoop rig(lockstep());
  rig.loop.subscriptions().profile = true;
  EXPECT_TRUE(rig.start().profile_due);
  const auto pause = [&rig](bool paused)
  { return rig.between([&](SimulationLoop& loop) { loop.set_paused(paused); }).profile_due; };
  EXPECT_FALSE(pause(true)) << "no stamp is sent twice";
  EXPECT_FALSE(pause(false));
  EXPECT_FALSE(rig.step(1).at(0).profile_due) << "ten profiles a second";
  EXPECT_TRUE(pause(true));
  EXPECT_FALSE(pause(true)) << "no stamp is sent twice";
  EXPECT_FALSE(pause(false));
  rig.loop.subscriptions().profile = false;
  rig.step(1);
  EXPECT_FALSE(pause(true)) << "no subscriber receives it";
}

TEST(LoopTime, itSaysWhetherTimeStands)
{
  RunningLoop rig(in_real_time());
  rig.start();
  const auto after = [&rig](bool paused)
  {
    rig.between([&](SimulationLoop& loop) { loop.set_paused(paused); });
    for (int i = 0; i < 200 && rig.loop.subscriptions().time_stands != paused; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return rig.loop.subscriptions().time_stands == paused;
  };
  EXPECT_TRUE(after(true));
  EXPECT_TRUE(after(false));
  EXPECT_TRUE(after(true));
}

TEST(LoopTime, aStateThatWasSavedShowsItsString)
{
  RunningLoop rig(in_real_time());
  rig.loop.subscriptions().profile = true;
  rig.start();
  rig.between([](SimulationLoop& loop) { loop.set_paused(true); });
  const FrameOutput restored = rig.between(
      [](SimulationLoop& loop)
      {
        const auto state = loop.rig().simulator->save();
        const ScenePlayer player = loop.rig().player;
        loop.go_back(*state, player, false, {});
      });
  EXPECT_TRUE(restored.new_stamp && restored.restored && restored.profile_due);
}

// What is due by simulated time must not wait for stamps that the master's first life has had.
TEST(LoopTime, aFollowerGoesOnWithAMasterThatBeganAgain)
{
  Parameters p;
  p.publish_clock = false;
  p.use_sim_time = true;
  RunningLoop rig(p);
  rig.loop.subscriptions().profile = rig.loop.subscriptions().tf = true;
  rig.start();
  rig.loop.hear_clock(500 * 1000 * ms);
  EXPECT_EQ(500 * 1000 * ms, rig.output(1).frame.stamp);
  rig.loop.hear_clock(3 * period);
  const FrameOutput first = rig.output(2);
  EXPECT_EQ(3 * period, first.frame.stamp);
  EXPECT_TRUE(first.new_stamp && first.state_due && first.profile_due && first.tf_due);
  rig.loop.hear_clock(4 * period);
  const FrameOutput second = rig.output(3);
  EXPECT_EQ(4 * period, second.frame.stamp);
  EXPECT_TRUE(second.state_due && !second.profile_due) << "ten profiles a second";
}

}  // namespace drill_rig_sim::test_ros_loop_time
