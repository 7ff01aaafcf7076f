// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_POINTING_H
#define DRILL_RIG_SIM_MODEL_POINTING_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"

/// A rotary steerable tool that points the bit. At its pivot, a node, the shaft that carries the bit leans against the collar.
/// The lean's direction stays in space while both turn: the pipe turns through it, and the tool's actuator turns back in the pipe
/// as fast.
///
/// Symbols, world axes: n the collar's section normal at the pivot, n_0 at the start of the step, Q its orientation; l the lean,
/// across n, |l| its angle; index s: the shaft's upper end, where the element below the pivot begins.
///   l goes straight to its target, the set points' ratio and toolface times the tool's tilt, by at most tilt/tilting_time a
///   second; within a step along n_0, and carried from n_0 to n by the shortest rotation Q_s = exp(n x l) Q,   n_s = n cos|l| + l
///   sin|l|/|l|        a joint of constant velocity: a spin about n is one about n_s w_s = w + s (n_s - n),   d theta_s = (1 +
///   (n_s - n) n^T) d theta,   s the collar's spin      the lean's own rate is left out of the damping
/// All of this holds for any spin, whatever the pipe turns within a step. The joint has no mass: the element's moment on the
/// shaft is the shaft's on the collar. M.(w_s - w), and what the lean's moving does, is the work of the tool's actuator, which
/// lives on the mud (EnergyAccounts::steering).
///
/// Left out: friction of the joint and bearings, what the actuator cannot hold, a shaft that hits its collar. Guided pipe does
/// not lean.
namespace drill_rig_sim
{
constexpr double tilting_time = 5.0;  ///< from straight to full tilt; assumed [s]

/// Towards the set points' toolface about an axis, times their ratio and `full`.
Eigen::Vector3d steering(const Eigen::Vector3d& axis, const Setpoints& setpoints, double full) noexcept;

/// l `time` [s] after the start of a step; zero where no tool points.
Eigen::Vector3d lean_after(const Model& model, const State& state, const Setpoints& setpoints, double time) noexcept;

/// Q_s, of a collar that is turned like this.
Eigen::Quaterniond leaning(const Eigen::Quaterniond& collar, const Eigen::Vector3d& lean) noexcept;

/// The shaft's upper end at a stage.
struct ShaftEnd
{
  Eigen::Quaterniond orientation;
  Eigen::Vector3d normal;  ///< n_s
  Eigen::Vector3d off;     ///< n_s - n
  Eigen::Vector3d lean;    ///< l, across n
  double spin = 0.0;       ///< s [rad/s]
};
ShaftEnd shaft_end(const Model& model, const Stage& stage, const Workspace& work) noexcept;

}  // namespace drill_rig_sim

#endif
