// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_PLACES_H
#define DRILL_RIG_SIM_MODEL_PLACES_H

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"

/// Where in the hole nodes and elements' middles are at a stage: closest points, and who touches the wall. Part of evaluate().
namespace drill_rig_sim
{
/// Closest point of hole or mast to node i, which has moved; not for the shaft.
void find_closest(const Model& model, const State& start, int i, NodeMotion& node) noexcept;

/// The middle of element e, whose ends have moved, and its closest point.
void find_span(const Model& model, const State& start, const Stage& stage, int e, Workspace& work) noexcept;

/// All free nodes and the middles of all free elements, by the batch kernels where the motion kernel has moved the nodes. Of what
/// these find clear of the wall only that and the segment is known.
void find_in_hole(const Model& model, const State& start, const Stage& stage, Workspace& work) noexcept;

/// Section normal of a bent element's upper end, its node turned like this.
inline Eigen::Vector3d bent_normal(const MeshElement& element, const Eigen::Quaterniond& node) noexcept
{
  return x_axis(node * element.upper_end);
}

}  // namespace drill_rig_sim

#endif
