// SPDX-License-Identifier: BSD-3-Clause
// Pipe on a filter cake: the strip that it seals, by the geometry of two circles, and the pressure that bleeds off beneath it.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/contact/filter_cake.h"
#include "drill_rig_sim/math/units.h"

namespace test_contact_filter_cake
{
using namespace drill_rig_sim;

// Where the gap between the circles is as wide as the cake: (R - r)(1 - cos a) = h.
TEST(FilterCake, isSealedWhereTheGapIsNarrowerThanIt)
{
  const double radius = 0.0635;
  for (const double room : {0.003, 0.02, 0.0445, 0.2})
  {
    const double half = sealed_width(radius, room) / (2.0 * radius);
    EXPECT_NEAR(room * (1.0 - std::cos(half)), cake_thickness, 1e-12) << room;
  }
  EXPECT_NEAR(sealed_width(radius, 100.0), 2.0 * radius * std::sqrt(2.0 * cake_thickness / 100.0), 1e-6)
      << "thin beside the room";
}

TEST(FilterCake, sealsHalfThePipeAtMost)
{
  for (const double room : {cake_thickness, 1e-3, 0.0, -0.01}) EXPECT_DOUBLE_EQ(sealed_width(0.1, room), pi * 0.1) << room;
}

// Nothing at once, 1 - 1/e after its time, all in the end.
TEST(FilterCake, holdsMoreTheLongerThePipeRests)
{
  EXPECT_EQ(sealed_share(0.0), 0.0);
  EXPECT_NEAR(sealed_share(6.0), 0.01, 1e-4);
  EXPECT_NEAR(sealed_share(cake_bleeding_time), 1.0 - std::exp(-1.0), 1e-12);
  EXPECT_NEAR(sealed_share(1e5), 1.0, 1e-12);
}
}  // namespace test_contact_filter_cake
