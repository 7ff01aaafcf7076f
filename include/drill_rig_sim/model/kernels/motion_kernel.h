#ifndef DRILL_RIG_SIM_MODEL_KERNELS_MOTION_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_MOTION_KERNEL_H

#include <cstddef>

#include "drill_rig_sim/math/kernel.h"
#include "drill_rig_sim/math/number_columns.h"

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

/// What move_free() of evaluate.cpp does node by node, to rounding.
struct MotionKernel
{
  void (*move)(const MoveTask& task) noexcept;
};

/// Null: there is none, and one by one is the way.
const MotionKernel* motion_kernel(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
