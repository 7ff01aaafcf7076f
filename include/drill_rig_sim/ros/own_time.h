// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_OWN_TIME_H
#define DRILL_RIG_SIM_ROS_OWN_TIME_H

#include <string>

namespace drill_rig_sim
{
/// ros::init() without a handler of SIGINT, in which /use_sim_time is remapped for this process to a parameter of its own.
/// roscpp has no other option for a node that publishes /clock and sets its time itself (ros::Time::setNow()): it would subscribe
/// to /clock, and each message would come back through three threads, a frame late.
void init_roscpp(int argc, char** argv, const std::string& node_name);

/// ros::start(), after init_roscpp() and before the first NodeHandle. Only a node that does not publish /clock subscribes to it.
void start_roscpp();

/// The global parameter /use_sim_time; false where it is not set. After init_roscpp().
bool simulated_time();

}  // namespace drill_rig_sim

#endif
