// SPDX-License-Identifier: BSD-3-Clause
// How runs of one rig are compared, by series whose differences are known.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/accuracy/verification.h"

namespace test_accuracy_verification
{
using namespace drill_rig_sim;

constexpr double frame = 0.01;  // [s]

/// Hook loads of a run, a finer one and the finest over a minute; the finest swings by 50 kN about 500 kN.
template <class Run, class Finer>
Verification verified(const Run& off, const Finer& finer_off, double warned_from = 1e9)
{
  Verification verification(0.02, need_hook_load);
  for (int k = 1; k <= 6000; ++k)
  {
    const double t = k * frame, finest = 500e3 + 50e3 * std::sin(t);
    verification.add({finest + off(t)}, {finest + finer_off(t)}, {finest}, t >= warned_from, {0.25 * off(t)}, t, frame);
  }
  return verification;
}
const auto nothing = [](double) { return 0.0; };
const auto from_21_s = [](double t) { return t > 21.0 ? 5e3 : 0.0; };

TEST(OutputDifference, isTheRootMeanSquareOfThreeSecondsOverTheRange)
{
  OutputDifference difference(Output::hook_load);
  for (int k = 1; k <= 3000; ++k) difference.add(1e5 + 300.0 * std::sin(40.0 * k * frame) + k * 10.0, 1e5 + k * 10.0, frame);
  EXPECT_NEAR(difference.absolute(), 300.0 / std::sqrt(2.0), 2.0);
  EXPECT_NEAR(difference.scale(), 29990.0, 1.0);
  for (int k = 1; k <= 310; ++k) difference.add(1e5, 1e5, frame);
  EXPECT_EQ(difference.absolute(), 0.0) << "forgets what is older than its window";
}

TEST(OutputDifference, ofAnOutputThatStandsIsOverATenthOfItsLevelOrWhatCanBeRead)
{
  OutputDifference level(Output::hook_load), nothing_there(Output::hook_load);
  for (int k = 0; k < 300; ++k) level.add(101e3, 100e3, frame), nothing_there.add(100.0, 0.0, frame);
  EXPECT_NEAR(level.absolute() / level.scale(), 0.1, 1e-9);
  EXPECT_NEAR(nothing_there.absolute() / nothing_there.scale(), 0.1, 1e-9) << "of 1 kN";
}

TEST(OutputDifference, aSecondAfterTheStartIsAThirdOfAWindow)
{
  OutputDifference difference(Output::hook_load);
  for (int k = 0; k < 100; ++k) difference.add(101e3, 100e3, frame);
  EXPECT_NEAR(difference.absolute(), 1e3 / std::sqrt(3.0), 1.0);
}

TEST(OutputDifference, aRateOfPenetrationThatJumpsAFrameLaterIsHardlyAnother)
{
  OutputDifference difference(Output::rop);
  for (int k = 0; k < 500; ++k) difference.add(k > 250 ? 1e-2 : 0.0, k > 251 ? 1e-2 : 0.0, frame);
  EXPECT_LT(difference.absolute() / difference.scale(), 0.01);
}

TEST(Verification, aRunLikeTheFinestIsRight)
{
  const Verification verification = verified(nothing, nothing);
  EXPECT_EQ(verification.verdict(), Verification::Verdict::right);
  const Verification::Finding found = verification.finding(Output::hook_load);
  EXPECT_EQ(found.worst, 0.0);
  EXPECT_TRUE(std::isnan(found.wrong_from));
  EXPECT_NEAR(found.scale, 1e5, 10.0);
}

TEST(Verification, tellsFromWhenARunIsWrongAndWhetherItWarned)
{
  const Verification missed = verified(from_21_s, nothing);
  EXPECT_EQ(missed.verdict(), Verification::Verdict::missed);
  const Verification::Finding found = missed.finding(Output::hook_load);
  EXPECT_NEAR(found.wrong_from, 21.0, 0.02);
  EXPECT_NEAR(found.worst, 0.05, 1e-3);
  ASSERT_EQ(found.off.size(), 20u);
  EXPECT_NEAR(found.off[10], 0.05, 1e-3);
  EXPECT_EQ(found.measured[10], 1250.0);
  EXPECT_NEAR(found.mean - found.finest_mean, 5e3 * 39.0 / 60.0, 10.0);
  EXPECT_EQ(verified(from_21_s, nothing, 23.5).verdict(), Verification::Verdict::warned);
  EXPECT_EQ(verified(from_21_s, nothing, 30.0).verdict(), Verification::Verdict::missed) << "too late";
}

TEST(Verification, finerRunsThatDisagreeTellNothing)
{
  EXPECT_EQ(verified(from_21_s, [](double) { return 9e3; }).verdict(), Verification::Verdict::unknown);
  EXPECT_EQ(verified(nothing, [](double) { return 9e3; }).verdict(), Verification::Verdict::unknown);
  EXPECT_EQ(verified(
                from_21_s, [](double) { return 9e3; }, 0.0)
                .verdict(),
            Verification::Verdict::warned);
  EXPECT_EQ(verified(nothing, [](double) { return 1e3; }).verdict(), Verification::Verdict::right);
}

/// Torques over `duration` [s] of a bit that sticks and slips every 4 s: the finest run's and one whose period is `longer` [-],
/// with an error on top; the finer run is as the finest.
template <class Error>
Verification of_stick_slip(double longer, const Error& error, double duration = 100.0)
{
  constexpr double period = 4.0, mean = 5e3, amplitude = 2e3;  // [s], [N m]
  Verification verification(0.02, need_torque);
  for (int k = 1; k <= static_cast<int>(duration / frame); ++k)
  {
    const double t = k * frame, angle = 2.0 * M_PI * t / period;
    const double finest = mean + amplitude * std::sin(angle),
                 run = mean + amplitude * std::sin(angle / (1.0 + longer)) + error(t);
    verification.add({0.0, run}, {0.0, finest}, {0.0, finest}, false, {}, t, frame);
  }
  return verification;
}

// After a time t the phase is off by 2 pi t/4 s/1000: by 2 % of the range 2 A where A times that over sqrt(2) is 0.04 A, at 36 s.
TEST(Verification, aVibrationThatGetsOutOfPhaseIsJudgedByItsStatistics)
{
  const Verification drifts = of_stick_slip(1e-3, nothing);
  const Verification::Finding found = drifts.finding(Output::torque);
  EXPECT_EQ(drifts.verdict(), Verification::Verdict::right);
  EXPECT_GT(found.worst, 0.05) << "its instants are wrong";
  EXPECT_NEAR(found.parted_from, 36.0, 3.0);
  EXPECT_NEAR(found.statistics.period, 1e-3, frame / 24.0) << "rises are known to a frame, 24 s from the first to the last";
  EXPECT_LT(found.statistics.mean, 0.01);
  EXPECT_EQ(of_stick_slip(1e-3, nothing, 60.0).verdict(), Verification::Verdict::missed) << "no whole window since";
}

TEST(Verification, aVibrationWithAnotherPeriodMeanOrAmplitudeIsWrong)
{
  EXPECT_EQ(of_stick_slip(0.03, nothing).verdict(), Verification::Verdict::missed);
  EXPECT_EQ(of_stick_slip(1e-3, [](double t) { return t > 40.0 ? 120.0 : 0.0; }).verdict(), Verification::Verdict::missed);
  EXPECT_EQ(of_stick_slip(1e-3, [](double t) { return 200.0 * std::sin(2.0 * M_PI * t / 4.0); }).verdict(),
            Verification::Verdict::missed);
}

TEST(Verification, anErrorThatPassesOrDoesNotVibrateIsJudgedByItsInstants)
{
  const Verification passes = of_stick_slip(0.0, [](double t) { return t > 40.0 && t < 43.0 ? 300.0 : 0.0; });
  EXPECT_EQ(passes.verdict(), Verification::Verdict::missed);
  EXPECT_TRUE(std::isnan(passes.finding(Output::torque).parted_from));
  Verification still(0.02, need_torque);
  for (int k = 1; k <= 10000; ++k) still.add({0.0, 5e3 + 0.1 * k}, {0.0, 5e3}, {0.0, 5e3}, false, {}, k * frame, frame);
  EXPECT_EQ(still.verdict(), Verification::Verdict::missed);
  EXPECT_TRUE(std::isnan(still.finding(Output::torque).parted_from));
}

TEST(Verification, outputsThatNobodyNeedsDoNotCount)
{
  Verification verification(0.02, need_torque);
  for (int k = 1; k <= 600; ++k) verification.add({1e6 + 1e4 * k}, {0.0}, {1e4 * k}, false, {}, k * frame, frame);
  EXPECT_EQ(verification.verdict(), Verification::Verdict::right);
  EXPECT_GT(verification.finding(Output::hook_load).worst, 0.02);
}
}  // namespace test_accuracy_verification
