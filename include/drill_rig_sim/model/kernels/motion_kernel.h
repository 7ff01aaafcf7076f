// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_KERNELS_MOTION_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_MOTION_KERNEL_H

#include "drill_rig_sim/math/kernel.h"
#include "drill_rig_sim/model/guides.h"

namespace drill_rig_sim
{
/// What move_free() of evaluate.cpp does node by node, to rounding.
struct MotionKernel
{
  /// Places and rates of free nodes at the increments u, 6 per node, of node 0: into work.nodes and work.columns.
  void (*move)(const State& start, const Stage& stage, const double* u, Runs::Run nodes, Workspace& work) noexcept;
};

/// Null: there is none, and one by one is the way.
const MotionKernel* motion_kernel(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
