// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_OWN_TIME_H
#define DRILL_RIG_SIM_ROS_OWN_TIME_H

namespace drill_rig_sim
{
/// Starts roscpp, after ros::init() and before the first NodeHandle. A node that publishes /clock then sets its time itself
/// (ros::Time::setNow()), not by the messages that it sends: roscpp would subscribe to them, and each would come back through
/// three threads, a frame late.
void start_roscpp();

}  // namespace drill_rig_sim

#endif
