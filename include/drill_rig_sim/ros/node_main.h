// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_NODE_MAIN_H
#define DRILL_RIG_SIM_ROS_NODE_MAIN_H

namespace drill_rig_sim
{
/// The node, until it is shut down. Returns its exit status: 0 shut down, 2 bad input, which is explained on stderr in one line.
int node_main(int argc, char** argv);

}  // namespace drill_rig_sim

#endif
