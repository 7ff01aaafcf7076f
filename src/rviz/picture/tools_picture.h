// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_TOOLS_PICTURE_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_TOOLS_PICTURE_H

#include <vector>

#include "mesh_data.h"
#include "string_data.h"

/// What turns before one's eyes: bit and blades, each in the frame of its part: x along the string towards the bit, origin at the
/// part's lower end. Lengths are true; the display enlarges them across.
namespace drill_rig_sim
{
/// Radius of a body of revolution at a place along x.
struct ProfilePoint
{
  double x = 0.0;
  double radius = 0.0;
};

/// `count` blades about x, each over `share` of its part of the circle, from radius `inner` times the profile's to the profile's,
/// winding by `turn` [rad] from the first point of the profile to the last.
void add_blades(MeshData& mesh, const std::vector<ProfilePoint>& profile, int count, double inner, double turn, double share,
                const Color& color);

/// A drag bit: six blades over a core, shank on top. `length` and `radius` [m].
MeshData bit_mesh(double length, double radius);

/// The blades of a stabiliser: four, wound, over two thirds of its `length`; from its body to `widest` [m].
MeshData stabilizer_mesh(double length, double radius, double widest);

}  // namespace drill_rig_sim

#endif
