// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_SHIFTED_SENSOR_H
#define DRILL_RIG_SIM_TEST_SHIFTED_SENSOR_H

#include <gtest/gtest.h>

#include "drill_rig_sim/instruments/sensor.h"

namespace drill_rig_sim
{
/// Two alike, one of them moved by 64 s half-way: what follows is the same, 64 s later.
inline void expect_to_move_with_the_clock(const SensorSpec& spec)
{
  Sensor still(spec, 0.125), moved(spec, 0.125);
  double shift = 0.0;
  for (int k = 0; k < 40; ++k)
  {
    if (k == 20) moved.shift_time(shift = 64.0);
    EXPECT_EQ(still.read(k * k, 0.125 * k), moved.read(k * k, 0.125 * k + shift)) << k;
  }
}

}  // namespace drill_rig_sim

#endif
