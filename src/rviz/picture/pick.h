// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_PICK_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_PICK_H

#include <optional>
#include <vector>

#include "string_tube.h"

namespace drill_rig_sim
{
/// What the eye looks along; `direction` is a unit vector.
struct Ray
{
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(), direction = -Eigen::Vector3d::UnitZ();
};

/// The place on the string that a ray meets: between which nodes, and where.
struct Picked
{
  Between place;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// The string is a chain of rods `radius` thick about its drawn nodes, which grow by `slope` times their distance from the eye,
/// so that a few pixels beside it still hit. Of several that are hit the one whose axis is nearest to the ray, measured in its
/// own thickness. Nothing where none is, or the rod lies behind the eye.
std::optional<Picked> pick(const std::vector<DrawnNode>& nodes, double radius, double slope, const Ray& ray);

}  // namespace drill_rig_sim

#endif
