#ifndef DRILL_RIG_SIM_SOLVE_STATICS_H
#define DRILL_RIG_SIM_SOLVE_STATICS_H

#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/stage.h"

namespace drill_rig_sim
{
struct StaticOutcome
{
  bool converged = false;
  double share = 1.0;       ///< of the friction that the equilibrium has; below 1: it is the last that was found on the way, 0: none was
  int iterations = 0;       ///< Newton iterations, continuation and KINSOL together
  double residual = 0.0;    ///< largest force or moment left at a node [N, N m]
  double top_force = 0.0;   ///< vertical force that holds the top node, + up: hook load of the string [N]
  double top_torque = 0.0;  ///< torque that holds the top node, + drives the string clockwise [N m]
  RigForces forces;         ///< in the equilibrium; hook load and meter torque are the caller's
};

/// Static equilibrium of the string in its hole, the top node held where it is: `state` in, a guess; out, at rest in equilibrium
/// (rates, bristles and history cleared). Without sliding: frictionless, the start of a run; else full slip along the given motion, the
/// stiff-string form of torque and drag. Where the whole friction is too much at once it is raised by and by, from none.
///
/// Pseudo-transient continuation (inertia M c^2 with c falling to 0, Kelley and Keyes 1998) walks into the basin of the solution:
/// a long string out of contact has almost no lateral stiffness, and a full Newton step would throw it through the wall. KINSOL's
/// Newton method with line search then finishes it, to 1 mN or to what the rounding of the nodes' places leaves of stiff elements.
/// `most_iterations` bounds the work of all together. Allocates; not for use in a frame.
StaticOutcome solve_static(const Model& model, State& state, const SlidingMotion& sliding, int most_iterations = 5000);

}  // namespace drill_rig_sim

#endif
