#ifndef DRILL_RIG_SIM_MODEL_KERNELS_WALL_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_WALL_KERNEL_H

#include "drill_rig_sim/math/kernel.h"

namespace drill_rig_sim
{
/// A node that touches the wall: where its numbers are, and where those of its contact go. Pointers to the first of several numbers in a row.
struct WallPlace
{
  const double* moves;    ///< NodeMoves
  const double* closest;  ///< ClosestPoint
  const double* bristle;  ///< at the start of the step, 3
  const double* law;      ///< ContactLaw and the numbers of WallLaw behind it, as WallNumbers
  double* residual;       ///< 6, from which force and moment are taken
  double* diagonal;       ///< 36, from which their derivatives are taken; null: nobody wants them
  double* wall;           ///< WallForce::force, 3, overwritten; and so on:
  double* bristle_after;  ///< 3
  double* normal_force;
  double* rest;           ///< how long it has stuck: in before, out after
};

/// WallLaw as a row of numbers, and the section's radius.
struct WallNumbers
{
  double stiffness, exponent, damping, stribeck_speed, static_ratio, tangential_stiffness, tangential_damping, lever, radius;
  double spare[3];
};

struct WallTask
{
  const WallPlace* places;
  int count;
  double dv_du, time;
  bool exponential;  ///< StribeckCurve
};

/// wall_contact() of nodes that turn with the string, with the usual exponent of 3/2 alone, several at a time.
struct WallKernel
{
  void (*add)(const WallTask& task) noexcept;
};

/// Null: there is none, and one by one is the way.
const WallKernel* wall_kernel(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
