// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_MAST_H
#define DRILL_RIG_SIM_MODEL_MAST_H

#include "drill_rig_sim/well/wellbore.h"

namespace drill_rig_sim
{
/// Half the width inside a mast, and how fast the guides below open from the table's bore to that: slant holes of 30 deg go
/// through free.
constexpr double mast_radius = 1.5;   ///< [m]
constexpr double mast_opening = 0.6;  ///< [m/m]

/// Makes the hole's vertical line above the rotary table the inside of the mast: pipe that is pushed aside there finds a guide
/// and a bound, and nothing jumps where it passes the table. `closest`: as found by Wellbore::locate(); elsewhere nothing
/// changes.
void open_mast(ClosestPoint& closest) noexcept;

/// Whether a section of `radius` [m] about `point` above the table is clear of the mast for sure: it is even of a hole as wide as
/// the table's bore.
bool clear_in_mast(const Wellbore& well, const Eigen::Vector3d& point, double radius) noexcept;

}  // namespace drill_rig_sim

#endif
