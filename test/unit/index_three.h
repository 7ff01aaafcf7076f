// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_INDEX_THREE_H
#define DRILL_RIG_SIM_TEST_INDEX_THREE_H

#include <algorithm>
#include <cmath>
#include <string>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/reference/constrained_bodies.h"
#include "drill_rig_sim/reference/ida_solver.h"

namespace drill_rig_sim
{
/// Bodies under gravity and nothing else, +z up.
class FallingBodies : public ConstrainedBodies
{
public:
  using ConstrainedBodies::ConstrainedBodies;

protected:
  void add_forces(double, const double*, double* force) override
  {
    for (int i = 0; i < body_count(); ++i) force[6 * i + 2] += standard_gravity * bodies()[static_cast<std::size_t>(i)].mass;
  }
  void add_force_jacobian(double, const double*, SparseJacobian&) override {}
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
inline DaeStepOutcome pendulum_with_step(double step, Formulation formulation, int steps = 200)
{
  constexpr double angle = 1.0, mass = 2.0, inertia = 1e-3, speed = -3.0;  // [rad, kg, kg m2, rad/s]
  std::vector<BodyMotion> motions(1);
  motions[0].position = Eigen::Vector3d(std::sin(angle), 0.0, -std::cos(angle));
  motions[0].velocity = speed * Eigen::Vector3d(std::cos(angle), 0.0, std::sin(angle));
  motions[0].angular_velocity = -speed * Eigen::Vector3d::UnitY();
  const std::vector<Joint> joints = {ball_joint(-1, BodyMotion(), 0, motions[0], Eigen::Vector3d::Zero())};
  // the step is given, not to be judged: any local error passes, Newton's method converges to 1e-9 all the same
  FallingBodies body({{mass, 0.0, inertia, inertia}}, motions, joints, formulation, {1.0, 1.0, 1.0, 1.0, 0.0});

  DaeStepOutcome out;
  std::vector<double> y = body.at_bases(), rate(y.size());
  IdaOptions options;
  options.max_order = 2;
  options.fixed_step = step;
  options.newton_share = 1e-9;
  IdaSolver ida(body, options);
  out.reached = body.make_consistent(0.0, y, rate) && ida.start(0.0, y, rate);
  for (int k = 1; k <= steps && out.reached; ++k)
  {
    out.reached = ida.advance(k * step, y, rate);
    if (!out.reached) break;
    const Eigen::Vector3d lambda(y[static_cast<std::size_t>(body.multipliers_at())],
                                 y[static_cast<std::size_t>(body.multipliers_at()) + 1],
                                 y[static_cast<std::size_t>(body.multipliers_at()) + 2]);
    body.read(y.data());
    const double cosine = -body.motion(0).position.z() / body.motion(0).position.norm();
    // weight along the rod plus m l phi'^2, phi'^2 from the energy
    const double square = speed * speed + 2.0 * standard_gravity * (cosine - std::cos(angle)) / (1.0 + inertia / mass);
    const double expected = mass * (standard_gravity * cosine + square);
    out.drift = std::max(out.drift, body.drift(y.data()).position);
    if (2 * k < steps) continue;
    out.multiplier_error = std::max(out.multiplier_error, std::abs(lambda.norm() - expected) / (mass * standard_gravity));
  }
  out.flag = ida.flag_name();
  out.steps = ida.statistics().steps;
  out.newton_failures = ida.statistics().newton_failures;
  return out;
}

}  // namespace drill_rig_sim

#endif
