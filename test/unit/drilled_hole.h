// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_DRILLED_HOLE_H
#define DRILL_RIG_SIM_TEST_DRILLED_HOLE_H

#include <gtest/gtest.h>

#include "drill_rig_sim/math/visit.h"
#include "well_fixtures.h"

/// What tests of a hole that grows share: the main job's bit and its helix [m].
namespace drill_rig_sim
{
inline constexpr double bit_radius = 0.1556;
inline constexpr double pitch = 10.3e-3;
inline constexpr double helix_radius = 30e-6;
inline constexpr double advance = 45e-6;  // 9 mm/s times 5 ms

inline TrajectorySpec every_metres(double length)
{
  return {length, 0};
}
inline TrajectorySpec every_steps(int steps)
{
  return {0.1, steps};
}

/// Everything that the next step depends on and shows, bit by bit.
inline void expect_identical(const Wellbore& a, const Wellbore& b)
{
  ASSERT_EQ(a.node_count(), b.node_count());
  ASSERT_EQ(to_bytes(a), to_bytes(b));
}

}  // namespace drill_rig_sim

#endif
