// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/own_time.h"

#include <ros/ros.h>
#include <unistd.h>

#include <string>
#include <vector>

namespace drill_rig_sim
{
namespace
{
const std::string sim_time = "/use_sim_time";

/// What roscpp finds as /use_sim_time: a parameter that no other process has, set only while roscpp starts.
const std::string& own_sim_time()
{
  static const std::string name =
      "/drill_rig_sim_start/process_" + std::to_string(getpid()) + "_" + std::to_string(ros::WallTime::now().toNSec());
  return name;
}
}  // namespace

void init_roscpp(int argc, char** argv, const std::string& node_name)
{
  std::string remapping = sim_time + ":=" + own_sim_time();
  std::vector<char*> words(argv, argv + argc);
  words.push_back(&remapping.front());
  int count = static_cast<int>(words.size());
  ros::init(count, words.data(), node_name, ros::init_options::NoSigintHandler);
}

void start_roscpp()
{
  bool publishes = true;
  ros::param::get("~publish_clock", publishes);
  const bool simulated = simulated_time(), listens = simulated && !publishes;
  if (listens) ros::param::set(own_sim_time(), true);
  ros::start();
  if (listens) ros::param::del(own_sim_time());
  if (simulated && publishes) ros::Time::setNow(ros::Time());  // until the first frame
}

bool simulated_time()
{
  XmlRpc::XmlRpcValue request, response, value;  // ros::param would remap the name
  request[0] = ros::this_node::getName();
  request[1] = sim_time;
  return ros::master::execute("getParam", request, response, value, false) &&
         value.getType() == XmlRpc::XmlRpcValue::TypeBoolean && static_cast<bool>(value);
}

}  // namespace drill_rig_sim
