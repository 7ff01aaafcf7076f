// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_DRILL_AHEAD_H
#define DRILL_RIG_SIM_TEST_DRILL_AHEAD_H

#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// Commands top drive [rad/s], pump [m3/s] and winch; `feed` [m/s] is how fast the block comes down.
inline void drill_ahead(Simulator& rig, double speed, double flow, double feed)
{
  TopDriveSetpoint drive;
  drive.speed = speed;
  rig.command(drive);
  rig.command(PumpSetpoint{flow});
  rig.command(WinchSetpoint{-feed, false});
}

}  // namespace drill_rig_sim

#endif
