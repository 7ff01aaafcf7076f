// The error that a companion measures, by series whose differences are known.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/accuracy/measured_error.h"

namespace test_accuracy_measured_error
{
using namespace drill_rig_sim;

TEST(MeasuredError, isTheDifferenceOverTheRangeTimesWhatFinerModelsLeave)
{
  MeasuredError measured(0.02);
  for (int k = 0; k < 2000; ++k) measured.add({1e6 + 1e3, 5e3 * (k % 2)}, {1e6 + 50.0 * k, 5e3 * (k % 2)}, 0.01);
  MeasuredError far(0.02);
  for (int k = 0; k < 2000; ++k) far.add({1e6, 1e4}, {1e6, 1e4 - 300.0}, 0.01);
  EXPECT_NEAR(far.error(Output::torque), error_over_difference * 300.0 / 970.0, 1e-3) << "over a tenth of its level";
  EXPECT_EQ(measured.error(Output::torque), 0.0);
}

TEST(MeasuredError, ofWhatNobodyCanReadIsWithinTheTolerance)
{
  // 90 N of weight between two models of a bit that barely touches: a load cell tells 1 kN apart, a tenth of it is seen
  MeasuredError measured(0.02);
  for (int k = 0; k < 400; ++k) measured.add({0.0, 0.0, 90.0}, {}, 0.01);
  EXPECT_LE(measured.error(Output::wob), error_over_difference * 0.02);
}

TEST(MeasuredError, theLargestIsOfWhatIsNeeded)
{
  MeasuredError measured(0.02);
  for (int k = 0; k < 400; ++k) measured.add({1e6, 1e4, 4e4}, {0.9e6, 0.99e4, 3e4}, 0.01);
  EXPECT_EQ(largest_of(measured.errors(), every_need).output, Output::wob);
  EXPECT_EQ(largest_of(measured.errors(), need_hook_load | need_torque).output, Output::hook_load);
  EXPECT_EQ(largest_of(measured.errors(), need_direction).error, 0.0);
}
}  // namespace test_accuracy_measured_error
