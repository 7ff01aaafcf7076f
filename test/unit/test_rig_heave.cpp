// SPDX-License-Identifier: BSD-3-Clause
// The floor of a floating rig: regular waves that come up from rest.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/heave.h"

namespace drill_rig_sim::test_rig_heave
{
// 1.5 m in 8 s: after five waves and a quarter 1.5 m; after five and a half, down at 1.5 2 pi/8 = 1.1781 m/s; 0.92528 m/s2.
TEST(Heave, wavesByHand)
{
  const HeaveSpec waves{1.5, 8.0};
  EXPECT_NEAR(floor_motion(waves, 42.0).height, 1.5, 1e-12);
  EXPECT_NEAR(floor_motion(waves, 42.0).speed, 0.0, 1e-12);
  EXPECT_NEAR(floor_motion(waves, 44.0).height, 0.0, 1e-12);
  EXPECT_NEAR(floor_motion(waves, 44.0).speed, -1.1781, 1e-4);
  EXPECT_NEAR(heave_acceleration(waves), 0.92528, 1e-5);
}

// In the first five: after a wave and a quarter r = 1/16 (3 - 1/2) = 0.15625.
TEST(Heave, comesUpFromRest)
{
  const HeaveSpec waves{1.5, 8.0};
  EXPECT_NEAR(floor_motion(waves, 10.0).height, 1.5 * 0.15625, 1e-12);
  constexpr double soon = 1e-3;
  EXPECT_EQ(floor_motion(waves, 0.0).height, 0.0);
  EXPECT_EQ(floor_motion(waves, 0.0).speed, 0.0);
  EXPECT_LT(floor_motion(waves, soon).speed / soon, 1e-3) << "acceleration";
}

TEST(Heave, speedIsTheHeightsSlope)
{
  const HeaveSpec waves{1.5, 8.0};
  constexpr double h = 1e-5;
  for (double time = 0.1; time < 60.0; time += 0.37)
  {
    const double slope = (floor_motion(waves, time + h).height - floor_motion(waves, time - h).height) / (2.0 * h);
    EXPECT_NEAR(floor_motion(waves, time).speed, slope, 1e-8) << time;
  }
}

TEST(Heave, noneOnTheGround)
{
  EXPECT_EQ(floor_motion(HeaveSpec(), 12.3).height, 0.0);
  EXPECT_EQ(floor_motion(HeaveSpec(), 12.3).speed, 0.0);
}
}  // namespace drill_rig_sim::test_rig_heave
