// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_SLIPS_H
#define DRILL_RIG_SIM_MODEL_FORCES_SLIPS_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// The slips in the rotary table hold the pipe at a node (State::slips). With d the node's displacement from where they were set
/// and z up:
///
///   F_z = k max(0, -d_z),   F_xy = -k d_xy,   T = -k_t (turn about the string's axis)
///
/// They carry the load below and let the pipe move up. They hold sideways and in spin while they are set, because the rotary
/// table is locked. Springs without damping: the mud damps the vibration of the pipe. They yield by a millimetre under 1 MN.
extern const Force slips;

/// Load of the string on them [N]; 0 if they are not set.
double slips_load(const State& state) noexcept;

constexpr double slips_stiffness = 1e9;  ///< k [N/m]
constexpr double slips_torsion = 1e7;    ///< k_t [N m/rad]

}  // namespace drill_rig_sim

#endif
