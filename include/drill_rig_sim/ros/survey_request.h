#ifndef DRILL_RIG_SIM_ROS_SURVEY_REQUEST_H
#define DRILL_RIG_SIM_ROS_SURVEY_REQUEST_H

#include "drill_rig_sim/LoadSurvey.h"
#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// The scene with the well that the request asks for; the bit starts `off_bottom` [m] unless it says otherwise.
/// Throws std::runtime_error with one line that names the file or the station, its values and what is wrong.
Scene with_survey(const Scene& scene, double off_bottom, const LoadSurvey::Request& request);

}  // namespace drill_rig_sim

#endif
