// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/own_time.h"

#include <ros/ros.h>

#include <string>

namespace drill_rig_sim
{
namespace
{
const std::string sim_time = "/use_sim_time";

bool publishes_simulated_time()
{
  bool simulated = false, publishes = true;
  ros::param::get(sim_time, simulated);
  ros::param::get("~publish_clock", publishes);
  return simulated && publishes;
}
}  // namespace

void start_roscpp()
{
  if (!publishes_simulated_time())
  {
    ros::start();
    return;
  }
  // roscpp has no option for it: while it starts, it finds the parameter under a name at which there is nothing
  auto& remappings = const_cast<ros::M_string&>(ros::names::getRemappings());
  remappings[sim_time] = ros::this_node::getName() + "/no_subscription_to_own_clock";
  ros::start();
  remappings.erase(sim_time);
  ros::Time::setNow(ros::Time());  // until the first frame
}

}  // namespace drill_rig_sim
