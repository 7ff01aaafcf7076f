// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/node_main.h"

int main(int argc, char** argv)
{
  return drill_rig_sim::node_main(argc, argv);
}
