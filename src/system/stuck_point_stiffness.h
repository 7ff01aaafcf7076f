#ifndef DRILL_RIG_SIM_SRC_SYSTEM_STUCK_POINT_STIFFNESS_H
#define DRILL_RIG_SIM_SRC_SYSTEM_STUCK_POINT_STIFFNESS_H

namespace drill_rig_sim
{
// a stuck pipe holds like ten joints' worth of steel
constexpr double stuck_point_stiffness = 1e8;  ///< [N/m]
constexpr double stuck_point_torsion = 1e6;    ///< [N m/rad]

}  // namespace drill_rig_sim

#endif
