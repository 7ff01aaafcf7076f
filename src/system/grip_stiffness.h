#ifndef DRILL_RIG_SIM_SRC_SYSTEM_GRIP_STIFFNESS_H
#define DRILL_RIG_SIM_SRC_SYSTEM_GRIP_STIFFNESS_H

namespace drill_rig_sim
{
// a stuck pipe holds like ten joints' worth of steel
constexpr double grip_stiffness = 1e8;  ///< [N/m]
constexpr double grip_torsion = 1e6;    ///< [N m/rad]

}  // namespace drill_rig_sim

#endif
