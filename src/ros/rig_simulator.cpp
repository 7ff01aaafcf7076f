#include <ros/ros.h>

#include <iostream>

#include "drill_rig_sim/ros/own_time.h"
#include "drill_rig_sim/ros/rig_node.h"
#include "drill_rig_sim/ros/signals.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "rig_simulator", ros::init_options::NoSigintHandler);
  drill_rig_sim::end_on_signals();
  drill_rig_sim::start_roscpp();
  try
  {
    drill_rig_sim::RigNode node;
    node.wait_for_shutdown();
  }
  catch (const std::exception& error)
  {
    std::cerr << "rig_simulator: " << error.what() << std::endl;
    return 2;
  }
  return 0;
}
