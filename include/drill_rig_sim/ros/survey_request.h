// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_SURVEY_REQUEST_H
#define DRILL_RIG_SIM_ROS_SURVEY_REQUEST_H

#include "drill_rig_sim/LoadSurvey.h"
#include "drill_rig_sim/scene/new_well.h"

namespace drill_rig_sim
{
/// The well that a request asks for. Throws std::runtime_error with one line where a file is not found or its map of columns is
/// wrong.
NewWell to_new_well(const LoadSurvey::Request& request);

}  // namespace drill_rig_sim

#endif
