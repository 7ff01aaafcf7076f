#ifndef DRILL_RIG_SIM_SOLVE_INDEX_THREE_H
#define DRILL_RIG_SIM_SOLVE_INDEX_THREE_H

#include <string>

#include "drill_rig_sim/solve/constrained_bodies.h"

namespace drill_rig_sim
{
/// Bodies under gravity and nothing else, +z up.
class FallingBodies : public ConstrainedBodies
{
public:
  using ConstrainedBodies::ConstrainedBodies;

protected:
  void add_forces(double t, const double* y, double* force) override;
  void add_force_jacobian(double t, const double* y, SparseJacobian& j) override;
};

/// What IDA made of a run with steps of one size.
struct DaeStepOutcome
{
  bool reached = false;  ///< the end of the run
  std::string flag;      ///< IDA's word for it
  std::uint64_t steps = 0;
  std::uint64_t newton_failures = 0;
  double multiplier_error = 0.0;  ///< largest error of the joint's force in the run's second half, relative to the weight [-]
  double drift = 0.0;             ///< largest violation of the joint [m]
};

/// A pendulum of 1 m and 2 kg that starts at 1 rad with 3 rad/s towards the lowest point: `steps` IDA steps of `step` [s] of the
/// given formulation, its joint's force against what the energy says, m (g cos + l phi'^2). Shows what index 3 does at very small
/// steps: the multiplier's row of Newton's matrix holds step^2, so round-off in the place is divided by step^2 in the force.
DaeStepOutcome pendulum_with_step(double step, Formulation formulation, int steps = 200);

}  // namespace drill_rig_sim

#endif
