// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_STUCK_POINT_H
#define DRILL_RIG_SIM_MODEL_FORCES_STUCK_POINT_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// The formation holds the pipe at a node (State::stuck_point) by stiff springs against displacement and spin.
extern const Force stuck_point;

// it holds like ten joints' worth of steel
constexpr double stuck_point_stiffness = 1e8;  ///< [N/m]
constexpr double stuck_point_torsion = 1e6;    ///< [N m/rad]

}  // namespace drill_rig_sim

#endif
