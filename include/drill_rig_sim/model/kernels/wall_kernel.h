// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_KERNELS_WALL_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_WALL_KERNEL_H

#include <Eigen/Core>

#include "drill_rig_sim/contact/contact_spec.h"
#include "drill_rig_sim/math/kernel.h"

namespace drill_rig_sim
{
struct NodeMotion;

/// A node that touches the wall: how it moves, the law there, and where the numbers of its contact go.
struct WallPlace
{
  const NodeMotion* node;
  const Eigen::Vector3d* bristle;  ///< at the start of the step
  const WallLaw* law;
  double lever, radius;                   ///< of the friction, of the section [m]
  double* residual;                       ///< 6, from which force and moment are taken
  double* diagonal;                       ///< 36, from which their derivatives are taken; null: not wanted
  Eigen::Vector3d *wall, *bristle_after;  ///< WallForce::force and bristle, overwritten
  double* normal_force;                   ///< too
  double* rest;                           ///< how long it has stuck: in before, out after
};

struct WallTask
{
  const WallPlace* places;
  int count;
  double dv_du, time;
  bool exponential;  ///< StribeckCurve
};

/// wall_contact() of several nodes at once. Only for nodes that turn with the string, and for the exponent 3/2.
struct WallKernel
{
  void (*add)(const WallTask& task) noexcept;
};

/// Null: there is none, and one by one is the way.
const WallKernel* wall_kernel(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
