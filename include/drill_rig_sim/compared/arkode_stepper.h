// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_COMPARED_ARKODE_STEPPER_H
#define DRILL_RIG_SIM_COMPARED_ARKODE_STEPPER_H

#include <memory>

#include "drill_rig_sim/solve/halving_integrator.h"
#include "drill_rig_sim/solve/newton.h"

namespace drill_rig_sim
{
/// SUNDIALS ARKODE (ARKStep, fixed step; Reynolds et al., ACM Trans. Math. Software 49 (2023), 17) with our block-tridiagonal
/// elimination as its linear solver: a second opinion on our own steppers, for comparison. It allocates inside.
///
/// Within a step y = (u, v), 6 per node each: u' = v, v' = -M^-1 R(u, v, no acceleration). The table is ARKODE_TRBDF2_3_3_2:
/// second order, L-stable, stiffly accurate (contacts and stuck bristles are in balance at the end of the step; SUNDIALS' other
/// table of second order, SDIRK 2-1-2, is not), and the formula of our own trbdf2: only the machinery differs in cost.
/// Newton's method is SUNDIALS' with our criterion of convergence and our first guess. With d_v = c (d_u - r_u), c = 1/gamma, its
/// system (1 - gamma J) d = r is (c^2 M + c C + K) d_u = c M (r_v + c r_u), where r_u is zero: the first guess keeps u' = v,
/// which is linear. The rotor stays condensed into the top's spin, with the relations that the same table gives it; bristles,
/// motor, winch and rock are functions of the time since the step's start as with every method.
class ArkodeStepper : public HalvingIntegrator
{
public:
  /// Throws std::runtime_error if SUNDIALS cannot be set up, or is older than 6.
  explicit ArkodeStepper(std::shared_ptr<const Model> model);
  ~ArkodeStepper() override;

  /// Whether this build's SUNDIALS has what it needs.
  static bool available() noexcept;

  NewtonLimits& limits() noexcept;

private:
  StepResult attempt(State& state, double step, const Setpoints& setpoints, int& budget, bool may_refine) noexcept override;

  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace drill_rig_sim

#endif
