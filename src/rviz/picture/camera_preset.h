// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_CAMERA_PRESET_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_CAMERA_PRESET_H

#include "hole_axis.h"

namespace drill_rig_sim
{
enum class Preset
{
  derrick,     ///< the rig above its floor
  along_hole,  ///< from within the hole, down at the bit
  bit,         ///< the bit and what is above it, from the side
  plan,        ///< the well from above, north up
  section      ///< the well from the side, at right angles to the way from the table to the bottom
};

/// An eye on a sphere about what it looks at: rviz' orbit. The eye stands at focus + distance (cos yaw cos pitch, sin yaw cos
/// pitch, sin pitch); up is z.
struct OrbitView
{
  Eigen::Vector3d focus = Eigen::Vector3d::Zero();
  double distance = 10.0;         ///< [m]
  double yaw = 0.0, pitch = 0.0;  ///< [rad]
};

/// What a preset depends on.
struct Subject
{
  Eigen::Vector3d bit = Eigen::Vector3d::Zero();  ///< as it is drawn
  double bit_md = 0.0;                            ///< [m]
  double hole_radius = 0.1;                       ///< at the bit, exaggerated [m]
  double crown_height = 46.0;                     ///< [m]
};

/// What makes the hole well seen from there: true size at the derrick, ten times by the bit, and where the whole well is seen a
/// round number that makes it about a fiftieth of the well's extent, at least ten. `hole_radius`: true [m].
double exaggeration_for(Preset preset, const HoleAxis& axis, double hole_radius) noexcept;

OrbitView view_of(Preset preset, const HoleAxis& axis, const Subject& subject) noexcept;

}  // namespace drill_rig_sim

#endif
