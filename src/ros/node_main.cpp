// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/node_main.h"

#include <iostream>

#include "drill_rig_sim/ros/own_time.h"
#include "drill_rig_sim/ros/rig_node.h"
#include "drill_rig_sim/ros/signals.h"

namespace drill_rig_sim
{
int node_main(int argc, char** argv)
{
  init_roscpp(argc, argv, "rig_simulator");
  end_on_signals();
  {
    const SignalHold until_it_has_started;
    start_roscpp();
  }
  try
  {
    RigNode node;
    node.wait_for_shutdown();
  }
  catch (const std::exception& error)
  {
    std::cerr << "rig_simulator: " << error.what() << std::endl;
    return 2;
  }
  return 0;
}

}  // namespace drill_rig_sim
