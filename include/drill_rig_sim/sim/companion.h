// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_COMPANION_H
#define DRILL_RIG_SIM_SIM_COMPANION_H

#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// What the run's companion (numerics.companion) shows after the last frame. Null without one, and once it no longer goes along.
inline const Truth* truth_of_companion(const Simulator& simulator) noexcept
{
  const bool goes_along = simulator.companions() > 0 && !*simulator.companion_failure(0);
  return goes_along ? &simulator.companion_truth(0) : nullptr;
}

}  // namespace drill_rig_sim

#endif
