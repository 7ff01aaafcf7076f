#ifndef DRILL_RIG_SIM_MODEL_KERNELS_STRING_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_STRING_KERNEL_H

#include <cstddef>

#include "drill_rig_sim/math/kernel.h"
#include "drill_rig_sim/math/number_columns.h"

/// The string's inner loops, several nodes or elements at a time. They do what move_nodes() of evaluate.cpp and the forces `beams` (the
/// corotational element), `mud_drag` and `inertia` do node by node and element by element, to rounding.
namespace drill_rig_sim
{
/// Places and rates of free nodes at the increments u: into NodeMoves and columns.
struct MoveTask
{
  int first, last;  ///< nodes from and to, the latter not among them
  // of the first of them; 6 numbers a node
  const double *u, *rate, *acceleration;
  double dv_du, da_du;
  // at the start of the step, of the first of them; `state_stride` bytes apart
  const double *position, *orientation;
  std::ptrdiff_t state_stride;
  double* moves;  ///< NodeMoves of the first, `move_stride` bytes apart
  std::ptrdiff_t move_stride;
  NumberColumns* nodes;
};

/// Beams between free nodes (or a free one and a guided one), mud and inertia of these.
struct StringTask
{
  int first, last;  ///< elements from and to, the latter not among them
  const NumberColumns *nodes, *elements;
  double structural_damping, dv_du, da_du;
  double* residual;  ///< 6 a node, of node 0; of the nodes from `first` to `last` overwritten
  /// Tangent blocks of 36 numbers, of node 0 and of the element above it, overwritten as the residual; null: nobody wants them.
  double *diagonal, *upper, *lower;
};

/// RigForces of the elements, of element 0, and at the nodes, of node 0.
struct StringForces
{
  double *tension, *torque, *bending_moment;
};

/// A kernel's.
struct StringKernel
{
  void (*move)(const MoveTask& task) noexcept;
  void (*add)(const StringTask& task) noexcept;
  void (*find_forces)(const StringTask& task, const StringForces& out) noexcept;  ///< of the task neither residual nor tangent is looked at
};

/// Null: there is none, and one by one is the way.
const StringKernel* string_kernel(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
