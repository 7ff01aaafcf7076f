#include <ros/ros.h>

#include <iostream>

#include "drill_rig_sim/ros/rig_node.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "rig_simulator");
  try
  {
    const drill_rig_sim::RigNode node;
    ros::waitForShutdown();
  }
  catch (const std::exception& error)
  {
    std::cerr << "rig_simulator: " << error.what() << std::endl;
    return 2;
  }
  return 0;
}
