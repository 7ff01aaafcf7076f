// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/reference/ida_integrator.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "drill_rig_sim/solve/energy_balance.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kLargestTilt = 0.3;  // [rad]
// Flow reaches the mechanics through the motor's speed alone, which lags behind it: smaller changes from step to step, as while a
// pump's ramp or compressed mud brings it, are smooth enough. [m3/s]
constexpr double kFlowJump = 1e-3;
// IDA's own steps in one interval, tried ones that failed among them. The benchmark's references, at 1e-7, take tens in 10 ms.
constexpr long kMostSteps = 1000;

bool same(const Setpoints& a, const Setpoints& b)
{
  return a.winch.block_velocity == b.winch.block_velocity && a.winch.brake == b.winch.brake &&
         a.top_drive.mode == b.top_drive.mode && a.top_drive.speed == b.top_drive.speed &&
         a.top_drive.torque == b.top_drive.torque && a.top_drive.angle == b.top_drive.angle &&
         a.top_drive.torque_limit == b.top_drive.torque_limit && a.top_drive.brake == b.top_drive.brake &&
         a.steering == b.steering && a.magnetic_steering == b.magnetic_steering;
}
}  // namespace

bool IdaIntegrator::advance(State& state, double step, const Setpoints& setpoints) noexcept
{
  try
  {
    if (advance_or_throw(state, step, setpoints)) return true;
  }
  catch (const std::exception&)
  {
    // memory, in all that is called: as if it had not converged
  }
  lost_ = true;
  return false;
}

bool IdaIntegrator::jumped(const State& state, const Setpoints& setpoints) const
{
  return !same(setpoints, setpoints_) || std::abs(state.flow - flow_) > kFlowJump || state.stuck_point.node != stuck_node_;
}

/// From the state (lost_) or from where IDA stands.
bool IdaIntegrator::start(const State& state, const Setpoints& setpoints)
{
  const NumericsSpec& numerics = model_->scene().numerics;
  if (lost_)
  {
    if (ida_) earlier_ = report_.ida;
    const Formulation formulation = numerics.reference_index == 3 ? Formulation::index_3 : Formulation::stabilised_index_2;
    ida_.reset();
    rig_ = std::make_unique<RigDae>(*model_, stage_, work_, state, formulation, numerics.reference_tolerance);
    IdaOptions options;
    options.max_order = numerics.reference_order;
    options.max_steps = kMostSteps;
    ida_ = std::make_unique<IdaSolver>(*rig_, options);
    y_ = rig_->initial(state);
    time_ = state.time;
    lost_ = false;
  }
  else
    rig_->renew_bases(y_);
  rig_->begin(time_, state, setpoints, y_);
  if (!rig_->make_consistent(time_, y_, rate_)) return false;
  rig_->begin(time_, state, setpoints, y_);
  return ida_->start(time_, y_, rate_);
}

bool IdaIntegrator::go_to(double t)
{
  if (!balance_) return ida_->advance(t, y_, rate_);
  parts_.clear();
  const std::size_t size = y_.size();
  return ida_->advance(t, y_, rate_,
                       [this, size](double time, const double* y, const double* rate) {
                         parts_.push_back({time, {y, y + size}, {rate, rate + size}});
                       });
}

void IdaIntegrator::book(const State& start, const Setpoints& setpoints)
{
  if (!balance_) return;
  balance_->begin_step(start, setpoints);
  Stage stage(*model_);
  std::vector<double> u(6 * static_cast<std::size_t>(model_->nodes()));
  begin_step(*model_, start, 0.0, setpoints, stage);
  for (const Part& part : parts_)
  {
    rig_->fill_stage(part.time, part.y.data(), part.rate.data(), stage, u.data());
    balance_->end_step(start, stage, u.data());
  }
}

bool IdaIntegrator::advance_or_throw(State& state, double step, const Setpoints& setpoints)
{
  begin_step(*model_, state, step, setpoints, stage_);
  bool fresh = lost_ || jumped(state, setpoints) || rig_->largest_tilt(y_.data()) > kLargestTilt;
  if (!fresh) fresh = rig_->begin(time_, state, setpoints, y_);
  setpoints_ = setpoints;
  flow_ = state.flow;
  stuck_node_ = state.stuck_point.node;
  if (fresh && !start(state, setpoints)) return false;
  bool done = go_to(time_ + step);
  if (!done && !ida_->too_much_work())
  {
    // once more from the start of the step, at order one
    ++counters_.convergence_failures;
    lost_ = true;
    done = start(state, setpoints) && go_to(time_ + step);
  }
  too_much_work_ = !done && ida_->too_much_work();
  if (!done) return false;
  book(state, setpoints);
  time_ += step;
  rig_->finish(time_, y_, state);
  note();
  return true;
}

const char* IdaIntegrator::failure() const noexcept
{
  return too_much_work_
             ? "integrator ida needs more steps of its own than are allowed in one step: reset the well or restore a state"
             : Integrator::failure();
}

void IdaIntegrator::note()
{
  const IdaStatistics before = report_.ida;
  IdaStatistics now = ida_->statistics();
  now.add(earlier_);
  report_.ida = now;
  counters_.steps += now.steps - before.steps;
  counters_.newton_iterations += now.newton_iterations - before.newton_iterations;
  counters_.convergence_failures +=
      now.error_test_failures + now.newton_failures - before.error_test_failures - before.newton_failures;
  work_.work.solves += now.newton_iterations - before.newton_iterations;
  const ConstraintDrift drift = rig_->drift(y_.data());
  report_.drift = std::max(report_.drift, drift.position);
  report_.rate_drift = std::max(report_.rate_drift, drift.velocity);
}

}  // namespace drill_rig_sim
