// SPDX-License-Identifier: BSD-3-Clause
// A downlink by the pump's flow: what it says, and what is lost.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "drill_rig_sim/instruments/downlink.h"
#include "drill_rig_sim/math/units.h"

namespace test_sim_downlink
{
using namespace drill_rig_sim;

namespace
{
constexpr double bit_time = 12.0, dt = 0.1, high = 0.03;

/// Flow [m3/s] of a downlink that began `time` [s] ago; the pump takes 3 s from low to high.
double flow_of(const SteeringSetpoint& command, double time, double lowered = 0.7)
{
  const auto at = [&](double t)
  { return high * (DownlinkReceiver::is_low(command, static_cast<int>(std::floor(t / bit_time))) ? lowered : 1.0); };
  double mean = 0.0;
  for (int k = 0; k < 30; ++k) mean += at(time - 0.1 * k) / 30.0;
  return mean;
}

/// What a receiver that has heard a steady flow makes of one as `flow(time)` from then on.
template <class Flow>
std::optional<SteeringSetpoint> heard(const Flow& flow)
{
  DownlinkReceiver receiver;
  std::optional<SteeringSetpoint> command;
  for (int k = 0; k < 2500; ++k)
  {
    const double time = k * dt;
    const auto now = receiver.hear(time, time < 20.0 ? high : flow(time - 20.0), bit_time);
    if (now) command = now;
  }
  return command;
}
}  // namespace

TEST(Downlink, saysToolfaceAndRatio)
{
  for (int direction = 0; direction < 16; ++direction)
    for (const int tenths : {0, 3, 10})
    {
      const SteeringSetpoint command{direction * 22.5 * degree, 0.1 * tenths};
      const auto got = heard([&](double time) { return flow_of(command, time); });
      ASSERT_TRUE(got) << direction << ' ' << tenths;
      EXPECT_NEAR(got->toolface, command.toolface, 1e-12);
      EXPECT_NEAR(got->ratio, command.ratio, 1e-12);
    }
}

TEST(Downlink, takesTheNearestThatItCanSay)
{
  const auto got = heard([](double time) { return flow_of({-85.0 * degree, 0.52}, time); });
  ASSERT_TRUE(got);
  EXPECT_NEAR(got->toolface, 270.0 * degree, 1e-12);
  EXPECT_NEAR(got->ratio, 0.5, 1e-12);
}

TEST(Downlink, aFlowThatIsLoweredForGoodSaysNothing)
{
  EXPECT_FALSE(heard([](double) { return 0.7 * high; }));
}

TEST(Downlink, aStopOfThePumpSaysNothing)
{
  EXPECT_FALSE(heard([](double time) { return time < 100.0 ? 0.0 : high; }));
  EXPECT_FALSE(heard([](double time) { return time > 30.0 && time < 60.0 ? 0.0 : flow_of({1.0, 1.0}, time); })) << "in its midst";
}

TEST(Downlink, aDipOfTheFlowIsNoStart)
{
  EXPECT_FALSE(heard([](double time) { return time < 4.0 ? 0.7 * high : high; }));
}

TEST(Downlink, aWrongBitIsLost)
{
  for (int wrong = 1; wrong < 10; ++wrong)
  {
    const SteeringSetpoint command{90.0 * degree, 0.6};
    const auto got = heard(
        [&](double time)
        {
          const bool here = static_cast<int>(std::floor(time / bit_time)) == wrong;
          const bool is_low = DownlinkReceiver::is_low(command, static_cast<int>(std::floor(time / bit_time))) != here;
          return is_low ? 0.7 * high : high;
        });
    EXPECT_FALSE(got) << wrong;
  }
}

TEST(Downlink, isHeardAfterAnotherOne)
{
  DownlinkReceiver receiver;
  int count = 0;
  for (int k = 0; k < 5000; ++k)
  {
    const double time = k * dt;
    const double since = std::fmod(time, 200.0) - 20.0;
    if (receiver.hear(time, since < 0.0 ? high : flow_of({2.0, 0.7}, since), bit_time)) ++count;
  }
  EXPECT_EQ(count, 2);
}
}  // namespace test_sim_downlink
