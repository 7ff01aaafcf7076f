// SPDX-License-Identifier: BSD-3-Clause
// Histograms of times by hand: bounds, percentiles, what was allowed; counted without memory.
#include <gtest/gtest.h>

#include "drill_rig_sim/realtime/time_histogram.h"

namespace drill_rig_sim::test_realtime_histogram
{
namespace
{
constexpr std::int64_t us = 1000, ms = 1000 * us, s = 1000 * ms;
}  // namespace

TEST(TimeHistogram, isEmptyAtFirst)
{
  const TimeHistogram times;
  EXPECT_EQ(0u, times.number());
  EXPECT_EQ(0.0, times.longest());
  EXPECT_EQ(0.0, times.percentile(0.99));
  EXPECT_EQ(1.0, times.share_below(ms)) << "none was too long";
  EXPECT_EQ(1.0, times.share_within());
}

TEST(TimeHistogram, aTimeIsBelowTheBoundsLongerThanIt)
{
  for (const std::int64_t bound : {us, 100 * us, 200 * us, 500 * us, ms, 2 * ms, 5 * ms, 10 * ms, 20 * ms, s, 8 * s})
  {
    TimeHistogram times;
    times.add(bound - 1, s);
    EXPECT_EQ(1u, times.below(bound)) << bound;
    times.add(bound, s);
    EXPECT_EQ(1u, times.below(bound)) << bound << " is not below itself";
    EXPECT_EQ(2u, times.number());
    EXPECT_DOUBLE_EQ(1e-9 * static_cast<double>(bound), times.longest());
  }
}

TEST(TimeHistogram, takesWhatIsShorterOrLongerThanItsBounds)
{
  TimeHistogram times;
  for (const std::int64_t time : {std::int64_t{-5}, std::int64_t{0}, 3600 * s}) times.add(time, s);
  EXPECT_EQ(2u, times.below(us));
  EXPECT_EQ(2u, times.below(8 * s));
  EXPECT_EQ(3u, times.number());
  EXPECT_DOUBLE_EQ(3600.0, times.longest());
  EXPECT_DOUBLE_EQ(3600.0, times.percentile(1.0));
}

TEST(TimeHistogram, countsWhatIsWithinTheTimeAllowed)
{
  TimeHistogram times;
  times.add(4 * ms, 5 * ms);
  times.add(5 * ms, 5 * ms);  // all of it
  times.add(5 * ms, 10 * ms);
  times.add(7 * ms, 7 * ms + 1);
  EXPECT_DOUBLE_EQ(0.75, times.share_within());
  EXPECT_DOUBLE_EQ(0.25, times.share_below(5 * ms));
}

TEST(TimeHistogram, aPercentileIsAtMostAQuarterTooLong)
{
  TimeHistogram times;
  for (std::int64_t i = 1; i <= 10000; ++i) times.add(i * us, s);
  for (const double share : {0.001, 0.01, 0.1, 0.5, 0.9, 0.99, 0.999})
  {
    const double exact = 1e-2 * share;  // [s]
    EXPECT_GE(times.percentile(share), exact) << share;
    EXPECT_LE(times.percentile(share), 1.28 * exact) << share;
  }
  EXPECT_DOUBLE_EQ(0.01, times.percentile(1.0)) << "never beyond the longest";
}

TEST(TimeHistogram, oneInTenThousandShowsFrom99Point99On)
{
  TimeHistogram times;
  for (int i = 0; i < 9999; ++i) times.add(90 * us, ms);
  times.add(7 * ms, ms);
  EXPECT_DOUBLE_EQ(1e-4, times.percentile(0.9999));
  EXPECT_DOUBLE_EQ(0.9999, times.share_below(ms));
  times.add(7 * ms, ms);
  EXPECT_DOUBLE_EQ(0.007, times.percentile(0.9999));
}

}  // namespace drill_rig_sim::test_realtime_histogram
