// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with /clock, and how far those are that follow it, by times given by hand.
#include <gtest/gtest.h>

#include "drill_rig_sim/ros/clock_watch.h"
#include "drill_rig_sim/ros/follower_watch.h"

namespace drill_rig_sim::test_ros_clock
{
namespace
{
ros::SteadyTime at(double seconds)
{
  return ros::SteadyTime(1000.0 + seconds);
}
}  // namespace

TEST(HeardClock, aFollowerMissesAClockThatNeverCame)
{
  const HeardClock clock("", at(0.0));
  EXPECT_EQ("", clock.trouble(at(3.0), false)) << "not yet";
  EXPECT_EQ("waiting for /clock, which has not been published yet", clock.trouble(at(3.1), false));
}

TEST(HeardClock, aFollowerMissesAClockThatStopped)
{
  HeardClock clock("", at(0.0));
  clock.hear("/leader", at(5.0));
  EXPECT_EQ("", clock.trouble(at(8.0), true));
  EXPECT_EQ("/clock has stopped: /leader is paused or dead", clock.trouble(at(8.1), true));
  EXPECT_EQ("/clock is no longer published; its last publisher was /leader", clock.trouble(at(8.1), false));
  clock.hear("/leader", at(9.0));
  EXPECT_EQ("", clock.trouble(at(9.1), true));
}

TEST(HeardClock, aSecondClockIsToldAsLongAsItIsHeard)
{
  HeardClock clock("", at(0.0));
  clock.hear("/leader", at(1.0));
  clock.hear("/other", at(2.0));
  EXPECT_EQ("two nodes publish /clock: /leader and /other", clock.trouble(at(2.1), true));
  clock.hear("/leader", at(4.9));
  EXPECT_EQ("two nodes publish /clock: /leader and /other", clock.trouble(at(5.0), true));
  EXPECT_EQ("", clock.trouble(at(5.1), true));
}

TEST(HeardClock, aFollowerGoesOnWithWhoeverGoesOn)
{
  HeardClock clock("", at(0.0));
  clock.hear("/leader", at(1.0));
  clock.hear("/heir", at(4.1));
  EXPECT_EQ("", clock.trouble(at(4.2), true)) << "one clock: the first is gone";
  clock.hear("/leader", at(4.3));
  EXPECT_EQ("two nodes publish /clock: /heir and /leader", clock.trouble(at(4.4), true));
}

TEST(HeardClock, whoPublishesItsOwnMissesNothingButSeesAnother)
{
  HeardClock clock("/rig", at(0.0));
  EXPECT_EQ("", clock.trouble(at(100.0), false)) << "paused, it publishes none";
  clock.hear("/rig", at(100.0));
  EXPECT_EQ("", clock.trouble(at(100.1), true));
  clock.hear("/other", at(110.0));
  EXPECT_EQ("two nodes publish /clock: /rig and /other", clock.trouble(at(113.0), true));
  EXPECT_EQ("", clock.trouble(at(113.1), true));
}

TEST(Followers, aFollowerIsBehindUntilItsNextFrameIsLaterThanTheStamp)
{
  Followers followers;
  EXPECT_EQ("", followers.behind(1000)) << "there is none";
  followers.hear("/b", Followers::not_begun, at(0.0));
  EXPECT_EQ("/b", followers.behind(1000));
  EXPECT_EQ(INT64_MAX, followers.slowest()) << "one without a clock needs this rig's frames";
  followers.hear("/b", 1000, at(0.0));
  EXPECT_EQ("/b", followers.behind(1000));
  EXPECT_EQ(1000, followers.slowest());
  followers.hear("/b", 1001, at(0.0));
  EXPECT_EQ("", followers.behind(1000));
}

TEST(Followers, theSlowestOfSeveralIsWaitedFor)
{
  Followers followers;
  followers.hear("/b", 5000, at(0.0));
  followers.hear("/c", 2000, at(0.0));
  EXPECT_EQ("/c", followers.behind(3000));
  EXPECT_EQ(2000, followers.slowest());
}

TEST(Followers, aFailedOneIsNotWaitedForButKnown)
{
  Followers followers;
  followers.hear("/b", Followers::failed, at(0.0));
  EXPECT_EQ("", followers.behind(1000));
  EXPECT_EQ("/b", followers.a_failed_one());
  EXPECT_EQ(INT64_MAX, followers.slowest());
}

TEST(Followers, oneThatStillShowsTheClockOfAnEarlierRunIsBehind)
{
  Followers followers;
  followers.hear("/b", 500'000'000'000, at(0.0));
  EXPECT_EQ("/b", followers.behind(10'000'000));
  followers.hear("/b", 1'000'000'000, at(0.0));
  EXPECT_EQ("", followers.behind(10'000'000)) << "a few frames ahead, after resets of its own";
}

TEST(Followers, theSilentOneIsLeftOutWhereOneHasGone)
{
  Followers followers;
  followers.hear("/b", 1000, at(0.0));
  followers.hear("/c", 9000, at(0.0));
  EXPECT_FALSE(followers.leave_out_lost(2, at(10.0)));
  followers.hear("/c", 9000, at(9.0));
  EXPECT_TRUE(followers.leave_out_lost(1, at(10.0)));
  EXPECT_EQ("", followers.behind(1000));
  EXPECT_EQ(9000, followers.slowest());
}

}  // namespace drill_rig_sim::test_ros_clock
