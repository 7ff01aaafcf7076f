// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_PLAYING_H
#define DRILL_RIG_SIM_TEST_PLAYING_H

#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/sim/simulator.h"

/// Playing on for a while, every frame of which must run.
namespace drill_rig_sim
{
constexpr double frame = 0.01;  // [s]

/// see(truth) after each frame.
template <typename See>
void play(Simulator& rig, double seconds, const See& see)
{
  for (int k = 0; k < std::lround(seconds / frame); ++k)
  {
    ASSERT_EQ(rig.frame(frame), FrameStatus::running) << rig.failure();
    see(rig.truth());
  }
}

inline void play(Simulator& rig, double seconds)
{
  play(rig, seconds, [](const Truth&) {});
}

}  // namespace drill_rig_sim

#endif
