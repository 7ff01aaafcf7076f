#include "drill_rig_sim/sim/faults.h"

#include <cmath>

namespace drill_rig_sim
{
bool is_in_hole(double md, double bit_depth) noexcept
{
  return md > 0.0 && md <= bit_depth;
}

void stick_pipe(const Model& model, double bit_depth, double md, State& state) noexcept
{
  int nearest = 0;
  for (int i = 1; i < model.top(); ++i)
  {
    const double depth = bit_depth - model.mesh().nodes[i].from_bit;
    const double of_nearest = bit_depth - model.mesh().nodes[nearest].from_bit;
    if (depth > 0.0 && std::abs(depth - md) < std::abs(of_nearest - md)) nearest = i;
  }
  state.stuck_point = {nearest, state.nodes[nearest].position, state.nodes[nearest].spin_angle};
}

void free_pipe(State& state) noexcept
{
  state.stuck_point = HeldNode();
}

}  // namespace drill_rig_sim
