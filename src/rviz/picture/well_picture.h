// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_WELL_PICTURE_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_WELL_PICTURE_H

#include <vector>

#include "hole_axis.h"
#include "mesh_data.h"
#include "string_data.h"

namespace drill_rig_sim
{
/// What a layer of rock is coloured by; the colours come again after the sixth.
Color layer_color(std::size_t layer) noexcept;

/// Rings of the hole's wall, top down, for a tube seen from within, so that what lies between it and the eye is open: in the
/// colour of casing above `shoe` [m], below it of the rock's layers. They are `spacing` [m] apart at most, and at steps of the
/// hole's radius; across the hole all is `exaggeration` times as large.
std::vector<Ring> wall_rings(const HoleAxis& axis, const RigData& rig, double shoe, double exaggeration, double spacing);

/// Layers of rock as bands of a vertical plane through the table and the hole's bottom, which reaches `margin` [m] beyond the
/// well on all sides but above; with lines where they meet.
void add_layers(MeshData& bands, MeshData& lines, const HoleAxis& axis, const RigData& rig, double margin);

/// Horizontal direction from the table to the hole's bottom, unit; where it lies below the table, the direction in which the hole
/// leans there, or east.
Eigen::Vector3d closure_direction(const HoleAxis& axis) noexcept;

/// How far the hole's bottom is from the planned path, and where on that it is nearest. The plan goes on straight for 1 m beyond
/// its end: what is drilled beyond is no error. `there` is false where there is no plan, or where it ends more than that before
/// the bottom.
struct PlanDistance
{
  bool there = false;
  double distance = 0.0;  ///< [m]
  Eigen::Vector3d nearest = Eigen::Vector3d::Zero();
};
PlanDistance distance_to_plan(const std::vector<Eigen::Vector3d>& plan, const Eigen::Vector3d& bottom) noexcept;

}  // namespace drill_rig_sim

#endif
