// SPDX-License-Identifier: BSD-3-Clause
// A user's program: one second of a scene by the library, as a message.
#include <drill_rig_sim/RigState.h>
#include <drill_rig_sim/scene/read_scene.h>
#include <drill_rig_sim/sim/simulator.h>

#include <iostream>

int main(int, char** argv)
{
  drill_rig_sim::Simulator simulator(drill_rig_sim::read_scene(argv[1]), 0);
  for (int i = 0; i < 100; ++i) simulator.frame(0.01);
  drill_rig_sim::RigState state;
  state.hook_load = simulator.readings().hook_load;
  std::cout << state << '\n';
}
