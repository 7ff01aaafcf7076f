#include "drill_rig_sim/solve/stepper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/forces/inertia.h"

namespace drill_rig_sim
{
const std::vector<const Method*>& method_table()
{
  static const std::vector<const Method*> table = {&bdf2,   &implicit_euler,    &linearly_implicit_euler,
                                                   &trbdf2, &generalised_alpha, &explicit_differences};
  return table;
}

const Method& find_method(IntegratorKind kind) noexcept
{
  for (const Method* method : method_table())
    if (kind == method->kind) return *method;
  return *method_table().front();
}

Stepper::Stepper(std::shared_ptr<const Model> model, const Method& method)
  : HalvingIntegrator(std::move(model)),
    method_(method),
    newton_(model_->nodes()),
    u_(6 * model_->nodes()),
    guess_(u_),
    residual_(u_)
{
  limits_.tolerance = model_->scene().numerics.newton_tolerance;
}

StepResult Stepper::attempt(State& state, double step, const Setpoints& setpoints, int& budget, bool may_refine) noexcept
{
  if (method_.first_acceleration > 0 && state.memory.last_step <= 0.0) find_acceleration(state, setpoints);
  open_books(state, setpoints);
  begin_step(*model_, state, step, setpoints, stage_);
  predict(state, step, u_.data());
  std::copy(u_.begin(), u_.end(), guess_.begin());
  StepContext context{*model_, state, step, stage_, work_, newton_, limits_, budget, u_.data(), residual_.data()};
  const bool solved = method_.step(context);
  counters_.newton_iterations += context.iterations;
  budget -= context.iterations;
  if (!solved) return StepResult::not_converged;
  error_estimate_ = method_.local_error ? method_.local_error(context) : predictor_distance() / 6.0;
  if (method_.refines && may_refine && error_estimate_ > largest_local_error) return StepResult::error_test_failed;
  close_books(state, stage_, u_.data());
  remember_last_rate(work_, state);
  if (method_.remember) method_.remember(context, state.memory);
  state.memory.last_step = step;
  commit(stage_, work_, state);
  advance_discrete(*model_, stage_, work_, state);
  ++counters_.steps;
  return StepResult::solved;
}

void Stepper::find_acceleration(State& state, const Setpoints& setpoints) noexcept
{
  begin_step(*model_, state, 0.0, setpoints, stage_);
  prepare_start(state, stage_);
  std::fill(u_.begin(), u_.end(), 0.0);
  evaluate(*model_, state, stage_, u_.data(), work_, residual_.data(), nullptr);
  expand_motions(stage_, work_);
  accelerate(*model_, stage_, residual_.data(), work_);
  for (int k = 1; k <= method_.first_acceleration; ++k)
  {
    PastQuantity& past = state.memory.past[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
    {
      const Eigen::Vector3d &n = stage_.normal[i], turning = work_.nodes[i].acceleration.tail<3>();
      past.nodes[i] = {work_.nodes[i].acceleration.head<3>(), turning - n * n.dot(turning), n.dot(turning)};
    }
  }
}

double Stepper::predictor_distance() const noexcept
{
  double most = 0.0;
  for (std::size_t k = 0; k < u_.size(); k += 6)
    for (std::size_t c = k; c < k + 3; ++c) most = std::max(most, std::abs(u_[c] - guess_[c]));
  return most;
}

}  // namespace drill_rig_sim
