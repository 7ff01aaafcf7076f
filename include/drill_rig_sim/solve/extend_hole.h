#ifndef DRILL_RIG_SIM_SOLVE_EXTEND_HOLE_H
#define DRILL_RIG_SIM_SOLVE_EXTEND_HOLE_H

#include "drill_rig_sim/system/system.h"

namespace drill_rig_sim
{
/// What follows every step: the rock-breaking velocity as the system was left, and the hole extended by it times the step [s].
void extend_hole(const System& system, SystemState& state, double step) noexcept;

}  // namespace drill_rig_sim

#endif
