// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REFERENCE_IDA_INTEGRATOR_H
#define DRILL_RIG_SIM_REFERENCE_IDA_INTEGRATOR_H

#include <memory>
#include <utility>
#include <vector>

#include "drill_rig_sim/reference/ida_solver.h"
#include "drill_rig_sim/solve/integrator.h"
#include "drill_rig_sim/reference/rig_dae.h"

namespace drill_rig_sim
{
/// The reference: the rig as a DAE (rig_dae.h), integrated by IDA within each step of `numerics.step`, at whose end the hole is
/// extended (the paper's order: integrate, extend the well, correct, next step). Steps of IDA go on across the ends of intervals;
/// it starts afresh at order one, from consistent accelerations, only where something jumps: set points, flow by more than 1e-3
/// m3/s, a stuck point, a node that dips into the mud, bases that are renewed because a section has tilted by more than 0.3 rad,
/// and the state itself. Order two at most by default: a string's fast axial and torsional modes are hardly damped, and the BDF
/// formulas of order three and more excite such modes unless the step resolves them. At 1e-6 the main job then takes a tenth of
/// the steps. Its joints hold within Newton's tolerance, 1e-8 m or rad in the mean over the unknowns. The work of one interval is
/// bounded: where IDA would need more than 1000 steps of its own it fails. Its memory is no part of a snapshot: after restore()
/// it starts afresh, so that runs repeat within the tolerance, not bit by bit. It allocates.
class IdaIntegrator : public Integrator
{
public:
  /// Tolerance and formulation as in the model's scene.
  explicit IdaIntegrator(std::shared_ptr<const Model> model) : Integrator(std::move(model)) {}

  bool advance(State& state, double step, const Setpoints& setpoints) noexcept override;
  void restart() noexcept override { lost_ = true; }
  /// The balance counts each of IDA's own steps.
  void keep_balance(EnergyBalance* balance) noexcept override { balance_ = balance; }
  const ReferenceReport* reference() const noexcept override { return &report_; }
  const char* failure() const noexcept override;

private:
  bool advance_or_throw(State& state, double step, const Setpoints& setpoints);
  bool start(const State& state, const Setpoints& setpoints);
  bool go_to(double t);
  void book(const State& start, const Setpoints& setpoints);
  bool jumped(const State& state, const Setpoints& setpoints) const;
  void note();

  std::unique_ptr<RigDae> rig_;
  std::unique_ptr<IdaSolver> ida_;
  std::vector<double> y_, rate_;
  // after one of IDA's steps; kept until the interval has succeeded, because it may be begun again
  struct Part
  {
    double time;
    std::vector<double> y, rate;
  };
  std::vector<Part> parts_;
  EnergyBalance* balance_ = nullptr;
  double time_ = 0.0;
  bool lost_ = true;
  bool too_much_work_ = false;  // in the last advance()
  Setpoints setpoints_;
  double flow_ = 0.0;
  int stuck_node_ = -1;
  IdaStatistics earlier_;
  ReferenceReport report_;
};

}  // namespace drill_rig_sim

#endif
