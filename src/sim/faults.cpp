#include "drill_rig_sim/sim/faults.h"

#include <cmath>

namespace drill_rig_sim
{
bool stick_pipe(const Model& model, double bit_depth, double md, State& state) noexcept
{
  if (!(md > 0.0)) return false;
  int nearest = -1;
  double distance = model.scene().numerics.element_length;
  for (int i = 0; i < model.top(); ++i)
  {
    const double depth = bit_depth - model.mesh().nodes[i].from_bit;
    if (depth <= 0.0 || std::abs(depth - md) >= distance) continue;
    distance = std::abs(depth - md);
    nearest = i;
  }
  if (nearest < 0) return false;
  state.stuck_point = {nearest, state.nodes[nearest].position, state.nodes[nearest].spin_angle};
  return true;
}

void free_pipe(State& state) noexcept
{
  state.stuck_point = StuckPointState();
}

}  // namespace drill_rig_sim
