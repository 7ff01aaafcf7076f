// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_KERNELS_STRING_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_STRING_KERNEL_H

#include "drill_rig_sim/math/kernel.h"

/// The string's inner loops, several elements at a time: what the forces `beams` (the corotational element), `mud_drag` and
/// `inertia` do one by one, to rounding.
namespace drill_rig_sim
{
struct ElementColumns;
struct NodeColumns;
struct Stage;

/// Beams between free nodes (or a free one and a guided one), mud and inertia of these.
struct StringTask
{
  int first, last;  ///< elements from and to, the latter not among them
  const NodeColumns& nodes;
  const ElementColumns& elements;
  const Stage& stage;
  double* residual;  ///< 6 a node, of node 0; of the nodes from `first` to `last` overwritten
  /// Tangent blocks of 36 numbers, of node 0 and of the element above it, overwritten as the residual; null: not computed.
  double *diagonal, *upper, *lower;
};

/// RigForces of the elements, of element 0, and at the nodes, of node 0.
struct StringForces
{
  double *tension, *torque, *bending_moment;
};

/// Of elements: elastic, and the potential of their weight in mud [J].
struct StringEnergy
{
  double beams, weight;
};

/// A kernel's, on the columns that the motion kernel leaves.
struct StringKernel
{
  void (*add)(const StringTask& task) noexcept;
  // these look at neither residual nor tangent of the task
  void (*find_forces)(const StringTask& task, const StringForces& out) noexcept;
  /// Adds the beams' elastic forces and those of their structural damping, 6 a node, of node 0.
  void (*sample)(const StringTask& task, double* elastic, double* damping) noexcept;
  StringEnergy (*stored)(const StringTask& task) noexcept;
};

/// Null: there is none, and one by one is the way.
const StringKernel* string_kernel(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
