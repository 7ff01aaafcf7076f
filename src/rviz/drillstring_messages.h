// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_DRILLSTRING_MESSAGES_H
#define DRILL_RIG_SIM_SRC_RVIZ_DRILLSTRING_MESSAGES_H

#include <nav_msgs/Path.h>

#include "drill_rig_sim/ControllerStatus.h"
#include "drill_rig_sim/DrillstringState.h"
#include "drill_rig_sim/RigDescription.h"
#include "drill_rig_sim/RigTruth.h"
#include "drawn_rig.h"
#include "picture/hole_axis.h"
#include "picture/string_data.h"

/// Messages as the data that pictures are made of. What they hold may be anything: problem_of() says whether it can be drawn.
namespace drill_rig_sim
{
StringData to_string_data(const DrillstringState& m);
/// An array that is shorter than part_name leaves what is missing at a value that problem_of() refuses.
RigData to_rig_data(const RigDescription& m);
/// A place that is not known is left NaN.
std::vector<DrawnRig::Fault> to_faults(const RigTruth& m);
/// None: no law commands the rig. A plan that is not all finite is left out.
std::optional<DrawnRig::Law> to_law(const ControllerStatus& m);
/// Why a path cannot be drawn, one line; empty where it can: there are places, all finite, with quaternions that are not 0.
std::string problem_of(const nav_msgs::Path& m);
HoleAxis to_hole_axis(const nav_msgs::Path& m);

}  // namespace drill_rig_sim

#endif
