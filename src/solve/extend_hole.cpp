#include "drill_rig_sim/solve/extend_hole.h"

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
void extend_hole(const System& system, SystemState& state, double step) noexcept
{
  state.bit.rock_velocity = system.rock_velocity(state);
  state.well.extend(step * state.bit.rock_velocity, x_axis(state.nodes[0].orientation));
}

}  // namespace drill_rig_sim
