// SPDX-License-Identifier: BSD-3-Clause
// The error that a companion measures, by series whose differences are known.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/accuracy/measured_error.h"
#include "drill_rig_sim/math/units.h"

namespace test_accuracy_measured_error
{
using namespace drill_rig_sim;

namespace
{
/// A frame of 10 ms.
void add(MeasuredError& measured, const Outputs& run, const Outputs& companion, double top_drive_speed = 0.0)
{
  measured.add_run(run, top_drive_speed, 0.01);
  measured.add_companion(companion);
  while (measured.due()) ASSERT_TRUE(measured.compare());
}
}  // namespace

TEST(MeasuredError, isTheDifferenceOverTheRangeTimesItsFactor)
{
  MeasuredError measured;
  for (int k = 0; k < 2000; ++k) add(measured, {1e6 + 1e3, 5e3 * (k % 2)}, {1e6 + 50.0 * k, 5e3 * (k % 2)});
  MeasuredError far(1.2);
  for (int k = 0; k < 2000; ++k) add(far, {1e6, 1e5}, {1e6, 1e5 - 300.0});
  EXPECT_NEAR(far.error(Output::torque), 1.2 * 300.0 / 1e4, 1e-5) << "over a tenth of its level";
  EXPECT_NEAR(far.absolute_error(Output::torque), 1.2 * 300.0, 1e-6);
  EXPECT_EQ(measured.error(Output::torque), 0.0);
}

// Two sines of the same deviation that are out of phase: averages agree.
TEST(MeasuredError, ofAveragesIsSmallWhereAVibrationRunsOutOfPhase)
{
  MeasuredError measured;
  for (int k = 0; k < 4000; ++k)
    add(measured, {1e6, 1e4 + 5e3 * std::sin(0.02 * pi * k)}, {1e6, 1e4 + 5e3 * std::sin(0.02 * pi * k + 1.0)});
  EXPECT_NEAR(measured.error(Output::torque), 2.0 * std::sin(0.5) / std::sqrt(2.0) * 5e3 / 1e4, 0.01);
  const StatisticDifferences of_torque = measured.statistics(Output::torque);
  EXPECT_LT(of_torque.mean, 0.01);
  EXPECT_LT(of_torque.deviation, 0.01);
  EXPECT_LT(of_torque.extremes, 0.001);
  EXPECT_LT(of_torque.period, 0.05);
  EXPECT_TRUE(std::isnan(measured.statistics(Output::hook_load).period)) << "that does not swing";
}

TEST(MeasuredError, ofStatisticsTellsALargerAndSlowerVibration)
{
  MeasuredError measured;
  for (int k = 0; k < 4000; ++k)
    add(measured, {1e6, 1e4 + 5e3 * std::sin(0.02 * pi * k)}, {1e6, 1e4 + 6e3 * std::sin(0.018 * pi * k)});
  const StatisticDifferences off = measured.statistics(Output::torque);
  EXPECT_NEAR(off.deviation, 1e3 / std::sqrt(2.0) / 1e4, 0.005);
  EXPECT_NEAR(off.extremes, 1e3 / 1e4, 0.002);
  EXPECT_NEAR(off.period, 0.1, 0.02);
}

TEST(WindowStatistics, areThoseOfTheLastHalfMinute)
{
  WindowStatistics signal;
  for (int k = 0; k < 1000; ++k) signal.add(1e6, 0.01);  // forgotten below
  for (int k = 0; k < 6200; ++k) signal.add(3.0 + 2.0 * std::sin(0.04 * pi * k), 0.01);
  const WindowStatistics::Summary window = signal.summary();
  EXPECT_NEAR(window.mean, 3.0, 0.01);
  EXPECT_NEAR(window.deviation, std::sqrt(2.0), 0.01);
  EXPECT_NEAR(window.least, 1.0, 0.01);
  EXPECT_NEAR(window.largest, 5.0, 0.01);
  EXPECT_NEAR(window.period, 0.5, 0.01);
}

TEST(MeasuredError, isOverTheResolutionWhereAnOutputHardlyMoves)
{
  MeasuredError measured;
  for (int k = 0; k < 400; ++k) add(measured, {0.0, 0.0, 0.0, 0.0, 0.01}, {});
  EXPECT_NEAR(measured.error(Output::bit_speed), 0.01 / 0.1, 1e-9);
}

// A steady weight of 6 kN below a hook load of 500 kN: 180 N are apart.
TEST(MeasuredError, ofALightWeightIsOverItsOwnRange)
{
  MeasuredError measured;
  add(measured, {5e5}, {5e5});
  for (int k = 0; k < 400; ++k) add(measured, {5e5, 0.0, 6000.0}, {5e5, 0.0, 6180.0});
  EXPECT_NEAR(measured.error(Output::wob), 180.0 / 6000.0, 1e-6);
}

// A scene that starts on bottom: the weight has not been 0 yet.
TEST(MeasuredError, ofAWeightCountsFromOffBottom)
{
  MeasuredError measured;
  for (int k = 0; k < 400; ++k) add(measured, {5e5, 0.0, 40000.0}, {5e5, 0.0, 40400.0});
  EXPECT_NEAR(measured.error(Output::wob), 400.0 / 40000.0, 1e-6);
}

// The drive has begun to turn, the bit follows a second later.
TEST(MeasuredError, ofTheBitSpeedIsOverThatOfTheTopDrive)
{
  MeasuredError measured;
  for (int k = 0; k < 400; ++k) add(measured, {0.0, 0.0, 0.0, 0.0, 0.01}, {}, 10.0);
  EXPECT_NEAR(measured.error(Output::bit_speed), 0.01 / (10.0 - 0.01), 1e-9)
      << "its range is that from its own speed to the drive's";
}

TEST(MeasuredError, theLargestIsOfWhatIsNeeded)
{
  MeasuredError measured;
  for (int k = 0; k < 400; ++k) add(measured, {1e6, 1e4, 4e5}, {0.98e6, 0.999e4, 3e5});
  EXPECT_EQ(largest_of(measured.errors(), every_need).output, Output::wob);
  EXPECT_EQ(largest_of(measured.errors(), need_hook_load | need_torque).output, Output::hook_load);
  EXPECT_EQ(largest_of(measured.errors(), need_direction).error, 0.0);
}

// The hook load is some 13 % off; frames of 0.1 s, one of 1 s.
TEST(MeasuredError, anErrorIsWarnedOfOnceItLasts)
{
  MeasuredError measured;
  for (int k = 0; k < 400; ++k) add(measured, {1e6 + 100.0 * k}, {1e6 + 90.0 * k - 1e4});
  const auto hook_load = [&](double tolerance, double frame) { return measured.lasting(measured.errors(), tolerance, frame)[0]; };
  ASSERT_GT(measured.error(Output::hook_load), 0.05);
  for (const bool lasts : {false, false, true, true}) EXPECT_EQ(hook_load(0.05, 0.1) > 0.05, lasts);
  EXPECT_EQ(hook_load(1.0, 0.1), 0.0);
  EXPECT_EQ(hook_load(0.05, 0.1), 0.0);
  EXPECT_EQ(hook_load(0.05, 1.0), measured.error(Output::hook_load));
}

// Where a bit comes to bottom they have hardly a range yet.
TEST(MeasuredError, oneOfTheWeightOrRateOfPenetrationMustLastForTwoSeconds)
{
  MeasuredError measured;
  for (int k = 0; k < 400; ++k) add(measured, {1e6, 0.0, 1e2 * k, 1e-6 * k}, {1e6, 0.0, 90.0 * k - 1e3, 0.9e-6 * k - 1e-5});
  for (const bool lasts : {false, true})
  {
    const Outputs told = measured.lasting(measured.errors(), 0.05, 1.0);
    EXPECT_EQ(told[static_cast<std::size_t>(Output::wob)] > 0.05, lasts);
    EXPECT_EQ(told[static_cast<std::size_t>(Output::rop)] > 0.05, lasts);
    EXPECT_EQ(largest_of(told, every_need).error > 0.0, lasts);
  }
}

TEST(MeasuredError, comparesTheSameFramesAtTheSameTimeHoweverLateTheCompanionIs)
{
  MeasuredError prompt, late;
  int waited = 0;
  for (int k = 0; k < 400; ++k)
  {
    const Outputs run = {1e6 + 50.0 * k, 1e3 * std::sin(0.1 * k)}, companion = {1e6 + 49.0 * k, 1e3 * std::sin(0.11 * k)};
    add(prompt, run, companion);
    late.add_run(run, 0.0, 0.01);
    for (; late.due() && !late.ready(); ++waited) late.add_companion({1e6 + 49.0 * waited, 1e3 * std::sin(0.11 * waited)});
    while (late.due()) ASSERT_TRUE(late.compare());
    ASSERT_EQ(prompt.errors(), late.errors());
  }
  EXPECT_EQ(waited, 400 - 10) << "0.1 s behind";
}

TEST(MeasuredError, aCompanionThatFailedMeasuresNothing)
{
  MeasuredError measured;
  Outputs failed{};
  failed.fill(std::nan(""));
  for (int k = 0; k < 11; ++k) measured.add_run({1e6}, 0.0, 0.01);
  ASSERT_TRUE(measured.due());
  ASSERT_FALSE(measured.ready());
  measured.add_companion(failed);
  ASSERT_TRUE(measured.ready());
  EXPECT_FALSE(measured.compare());
}

TEST(MeasuredError, takesNoMoreFramesThanItHasPlacesFor)
{
  MeasuredError measured;
  for (std::uint64_t k = 0; k < MeasuredError::capacity; ++k)
  {
    ASSERT_FALSE(measured.due());
    measured.add_run({1e6}, 0.0, 1e-4);
  }
  EXPECT_TRUE(measured.is_full());
  EXPECT_TRUE(measured.due());
}
}  // namespace test_accuracy_measured_error
