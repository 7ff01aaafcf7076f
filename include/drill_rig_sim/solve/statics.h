// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_STATICS_H
#define DRILL_RIG_SIM_SOLVE_STATICS_H

#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/stage.h"

namespace drill_rig_sim
{
constexpr int most_static_iterations = 8000;
/// A share of the friction that pipe stands as it buckles into a helix, turn by turn.
constexpr double gradual_share = 0.25;

struct StaticOutcome
{
  bool converged = false;
  bool gradual = false;  ///< the friction was raised by and by
  double share =
      1.0;  ///< of the friction that the equilibrium has; below 1: it is the last that was found on the way, 0: none was
  int iterations = 0;           ///< Newton iterations, continuation and KINSOL together
  double residual = 0.0;        ///< largest force or moment left at a node [N, N m]
  double top_force = 0.0;       ///< vertical force that holds the top node, + up: hook load of the string [N]
  double top_torque = 0.0;      ///< torque that holds the top node, + drives the string clockwise [N m]
  double holding_torque = 0.0;  ///< that holds the bend of solve_held(), + clockwise; else 0 [N m]
  RigForces forces;             ///< in the equilibrium; hook load and meter torque are the caller's
};

/// A bend that is held at its toolface from outside.
struct ToolfaceHold
{
  int node = -1;                                     ///< of the bend; -1: nothing is held
  double toolface = 0.0;                             ///< [rad]
  Eigen::Vector3d hole = -Eigen::Vector3d::UnitZ();  ///< the hole's tangent there, for the toolface's reference (toolface_side())
};

/// Static equilibrium of the string in its hole, the top node held where it is: `state` in, a guess; out, at rest in equilibrium
/// (rates, bristles and history cleared). Without sliding: frictionless, the start of a run; else full slip along the given
/// motion, the stiff-string form of torque and drag. `first_share`: of the friction that is tried first; it is raised by and by
/// from there, and in smaller steps where the string does not rest. A helix that friction pushes into being all at once may have
/// fewer turns than one that grows.
///
/// Pseudo-transient continuation (inertia M c^2 with c falling to 0, Kelley and Keyes 1998) walks into the basin of the solution:
/// a long string out of contact has almost no lateral stiffness, and a full Newton step would throw it through the wall. KINSOL's
/// Newton method with line search then finishes it, to 1 mN or to what the rounding of the nodes' places leaves of stiff
/// elements. Where an increment would go uphill, against the forces, more inertia turns it: compressed pipe that snaps across its
/// hole has no stiffness there. `most_iterations` bounds the work of all together. `in_mud`: the speeds of `sliding` are those of
/// the string, which has the mud's linear drag at them (mud_damping.h). Allocates; not for use in a frame.
StaticOutcome solve_static(const Model& model, State& state, const SlidingMotion& sliding,
                           int most_iterations = most_static_iterations, double first_share = 1.0, bool in_mud = false);

/// The same without friction, and with the bend held by a stiff spring about its axis: for toolfaces in which a long string, soft
/// in torsion, does not rest by itself. The equilibrium is the string's own where `holding_torque` is 0: the caller turns the top
/// until it is.
StaticOutcome solve_held(const Model& model, State& state, const ToolfaceHold& hold, int most_iterations);

}  // namespace drill_rig_sim

#endif
