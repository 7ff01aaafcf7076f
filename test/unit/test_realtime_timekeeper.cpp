// SPDX-License-Identifier: BSD-3-Clause
// The timekeeper against steady times given by hand: absolute deadlines, backlog dropped and counted, speeds, another rig's
// clock, the wall; and the cadence of what comes at a rate.
#include <gtest/gtest.h>

#include "drill_rig_sim/realtime/cadence.h"
#include "drill_rig_sim/realtime/timekeeper.h"

namespace drill_rig_sim::test_realtime_timekeeper
{
namespace
{
constexpr std::int64_t ms = 1'000'000, second = 1'000'000'000, period = 10 * ms;
constexpr std::int64_t start = 1000 * second;  // of the steady clock

Timekeeper in_real_time()
{
  return Timekeeper(TimeSource::own, ClockMode::realtime, period, 77);
}
}  // namespace

TEST(Timekeeper, stampsBeginAtOnePeriodAndGrowByPeriods)
{
  Timekeeper time(TimeSource::own, ClockMode::realtime, period, 77);
  EXPECT_EQ(0, time.stamp());
  time.tick();
  EXPECT_EQ(period, time.stamp());
  time.tick();
  EXPECT_EQ(2 * period, time.stamp());
  EXPECT_DOUBLE_EQ(0.02, time.ticked_seconds());
}

TEST(Timekeeper, stampsOfTheWallBeginAtItsTime)
{
  Timekeeper time(TimeSource::wall, ClockMode::realtime, period, 77 * second);
  EXPECT_FALSE(time.has_own_clock());
  EXPECT_FALSE(time.follows());
  time.tick();
  EXPECT_EQ(77 * second + period, time.stamp());
  EXPECT_DOUBLE_EQ(0.01, time.ticked_seconds());
}

TEST(Timekeeper, deadlinesAreAbsoluteSoThatDelaysAreCaughtUp)
{
  Timekeeper time = in_real_time();
  time.restart(start);
  std::int64_t due = start;
  for (const std::int64_t late : {0 * ms, 4 * ms, 9 * ms, 1 * ms, 0 * ms})
  {
    EXPECT_EQ(due, time.next_frame_at());
    time.frame_begins(due + late);
    due += period;
  }
  EXPECT_EQ(start + 5 * period, time.next_frame_at());
  EXPECT_EQ(0.0, time.dropped_seconds());
}

TEST(Timekeeper, aFrameMoreThanATenthOfAPeriodLateIsAnOverrun)
{
  Timekeeper time = in_real_time();
  time.restart(start);
  time.frame_begins(start + ms);
  EXPECT_EQ(0u, time.overruns());
  time.frame_begins(start + period + ms + 1);
  EXPECT_EQ(1u, time.overruns());
}

TEST(Timekeeper, backlogBeyondATenthOfASecondIsDroppedAndCounted)
{
  Timekeeper time = in_real_time();
  time.restart(start);
  time.frame_begins(start + 100 * ms);  // as much as is caught up
  EXPECT_EQ(0.0, time.dropped_seconds());
  EXPECT_EQ(start + period, time.next_frame_at());

  const std::int64_t due = time.next_frame_at();
  time.frame_begins(due + 350 * ms);
  EXPECT_DOUBLE_EQ(0.25, time.dropped_seconds());
  EXPECT_EQ(due + 250 * ms + period, time.next_frame_at()) << "a tenth of a second stays to be caught up";
  time.frame_begins(time.next_frame_at() + 101 * ms);
  EXPECT_DOUBLE_EQ(0.251, time.dropped_seconds());
  EXPECT_EQ(3u, time.overruns());
}

TEST(Timekeeper, speedStretchesDeadlinesNotStamps)
{
  Timekeeper time = in_real_time();
  time.set_speed(2.0, start);
  EXPECT_EQ(start, time.next_frame_at());
  time.frame_begins(start);
  time.tick();
  EXPECT_EQ(start + period / 2, time.next_frame_at());
  EXPECT_EQ(period, time.stamp());
  time.set_speed(0.5, start + second);
  time.frame_begins(start + second);
  EXPECT_EQ(start + second + 2 * period, time.next_frame_at());
}

TEST(Timekeeper, asFastAsItGoesIsDueAtOnceAndNeverLate)
{
  Timekeeper time = in_real_time();
  time.set_speed(0.0, start);
  EXPECT_FALSE(time.is_realtime());
  EXPECT_EQ(0, time.next_frame_at());
  time.frame_begins(start + 3600 * second);
  EXPECT_EQ(0u, time.overruns());
  EXPECT_EQ(0.0, time.dropped_seconds());
}

TEST(Timekeeper, freeRunAndLockstepKeepNoDeadlines)
{
  for (const ClockMode mode : {ClockMode::free_run, ClockMode::lockstep})
  {
    Timekeeper time(TimeSource::own, mode, period, 0);
    EXPECT_FALSE(time.is_realtime());
    EXPECT_EQ(0, time.next_frame_at());
    EXPECT_EQ(mode == ClockMode::lockstep, time.in_lockstep());
  }
}

TEST(Timekeeper, afterAPauseNothingIsCaughtUp)
{
  Timekeeper time = in_real_time();
  time.restart(start);
  time.frame_begins(start);
  time.restart(start + 60 * second);
  EXPECT_EQ(start + 60 * second, time.next_frame_at());
  time.frame_begins(start + 60 * second);
  EXPECT_EQ(0u, time.overruns());
  EXPECT_EQ(0.0, time.dropped_seconds());
}

TEST(Timekeeper, followsAnotherRigsClockFrameByFrame)
{
  Timekeeper time(TimeSource::other_rig, ClockMode::realtime, period, 77);
  EXPECT_TRUE(time.follows());
  EXPECT_FALSE(time.is_realtime());
  EXPECT_EQ(Timekeeper::not_yet, time.next_frame_at()) << "no clock heard yet";
  time.hear_clock(3 * period - 1);
  for (int i = 0; i < 2; ++i)
  {
    time.adopt_clock();
    EXPECT_EQ(0, time.next_frame_at());
    time.tick();
  }
  EXPECT_EQ(2 * period, time.stamp());
  EXPECT_EQ(Timekeeper::not_yet, time.next_frame_at()) << "the third frame ends a nanosecond later";
}

TEST(Timekeeper, goesAtOnceToAClockFarAway)
{
  Timekeeper time(TimeSource::other_rig, ClockMode::realtime, period, 77);
  time.hear_clock(500 * second);
  time.adopt_clock();
  EXPECT_EQ(500 * second - period, time.stamp());
  time.tick();
  EXPECT_EQ(Timekeeper::not_yet, time.next_frame_at());
  EXPECT_DOUBLE_EQ(0.01, time.ticked_seconds()) << "the jump is no simulated time";

  time.hear_clock(510 * second);
  time.adopt_clock();
  EXPECT_EQ(500 * second, time.stamp()) << "ten seconds are followed frame by frame";
  EXPECT_EQ(0.0, time.dropped_seconds());
  time.hear_clock(3 * second);  // the master began again
  EXPECT_TRUE(time.adopt_clock()) << "back";
  EXPECT_EQ(3 * second - period, time.stamp());
  EXPECT_EQ(0.0, time.dropped_seconds());
  time.hear_clock(100 * second);
  EXPECT_FALSE(time.adopt_clock()) << "forth";
}

TEST(Timekeeper, waitsForAClockThatItIsALittleAheadOf)
{
  Timekeeper time(TimeSource::other_rig, ClockMode::realtime, period, 77);
  time.hear_clock(500 * second + period);
  time.adopt_clock();
  time.hear_clock(499 * second);
  EXPECT_FALSE(time.adopt_clock());
  EXPECT_EQ(500 * second, time.stamp());
  EXPECT_EQ(Timekeeper::not_yet, time.next_frame_at());
  time.hear_clock(499 * second - 1);
  EXPECT_TRUE(time.adopt_clock());
  EXPECT_EQ(499 * second - 1 - period, time.stamp());
}

// One that cannot keep up leaves out what is beyond the longest jump, and counts it.
TEST(Timekeeper, whatASlowFollowerLeavesOutIsDropped)
{
  Timekeeper time(TimeSource::other_rig, ClockMode::realtime, period, 77);
  time.adopt_clock();
  time.hear_clock(20 * second);  // the first one heard
  time.adopt_clock();
  time.tick();
  EXPECT_EQ(0.0, time.dropped_seconds());
  time.hear_clock(30 * second + 1);
  time.adopt_clock();
  time.tick();
  EXPECT_EQ(30 * second + 1, time.stamp());
  EXPECT_DOUBLE_EQ(10.0 + 1e-9 - 0.01, time.dropped_seconds()) << "but for the frame itself";
}

TEST(Timekeeper, itsOwnClockIsNotMovedByAnothers)
{
  Timekeeper time = in_real_time();
  time.hear_clock(500 * second);
  time.adopt_clock();
  EXPECT_EQ(0, time.stamp());
}

TEST(Cadence, isDueOncePerPeriodWithoutDrift)
{
  Cadence thirty(30.0);
  int due = 0;
  for (std::int64_t now = start; now < start + 10 * second; now += 10 * ms) due += thirty.due(now) ? 1 : 0;
  EXPECT_EQ(300, due);
}

TEST(Cadence, isNotDueEarly)
{
  Cadence ten(10.0);
  EXPECT_TRUE(ten.due(start));
  EXPECT_FALSE(ten.due(start));
  EXPECT_FALSE(ten.due(start + 99 * ms));
  EXPECT_TRUE(ten.due(start + 100 * ms - 1000)) << "a microsecond is rounding";
}

TEST(Cadence, afterAGapThereIsNoBurst)
{
  Cadence ten(10.0);
  EXPECT_TRUE(ten.due(start));
  int due = 0;
  for (std::int64_t now = start + 60 * second; now < start + 60 * second + 50 * ms; now += ms) due += ten.due(now) ? 1 : 0;
  EXPECT_EQ(3, due) << "one, and two made up for";
}

TEST(Cadence, restartedItIsDueAtOnce)
{
  Cadence ten(10.0);
  EXPECT_TRUE(ten.due(start));
  ten.restart();
  EXPECT_TRUE(ten.due(start + ms));
  EXPECT_FALSE(ten.due(start + 2 * ms));
}

}  // namespace drill_rig_sim::test_realtime_timekeeper
