// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_RIG_DESCRIPTION_H
#define DRILL_RIG_SIM_ROS_RIG_DESCRIPTION_H

#include <std_msgs/Header.h>

#include "drill_rig_sim/RigDescription.h"
#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// What a display needs of a scene beside what moves. The planned path is the survey's (well/survey.h), a point at every station
/// and at least every 10 m. `scene`: checked; `header`: stamp, and the name of the frame `rig_floor`.
RigDescription to_rig_description(const Scene& scene, const std_msgs::Header& header);

}  // namespace drill_rig_sim

#endif
