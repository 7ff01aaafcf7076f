// What is wrong with /clock, by wall times given by hand.
#include <gtest/gtest.h>

#include "drill_rig_sim/ros/clock_watch.h"

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

}  // namespace drill_rig_sim::test_ros_clock
