// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/solve/energy_balance.h"

#include <algorithm>
#include <utility>

#include "drill_rig_sim/model/energy.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/forces/inertia.h"
#include "drill_rig_sim/solve/methods/method.h"

namespace drill_rig_sim
{
namespace
{
double mean(double a, double b) noexcept
{
  return 0.5 * (a + b);
}

const std::vector<double>& force_of(const EnergySample& sample, NodeForce kind) noexcept
{
  return sample.force[static_cast<std::size_t>(kind)];
}
}  // namespace

EnergyBalance::EnergyBalance(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      stage_(*model_),
      work_(*model_),
      no_increment_(6 * model_->nodes(), 0.0),
      pressure_(model_->mesh().elements.size(), 0.0)
{
  loads_before_.resize(pressure_.size());
  loads_ = loads_before_;
  // so that samples need no memory later
  for (EnergySample* sample : {&before_, &after_})
  {
    for (std::vector<double>& force : sample->force) force = no_increment_;
    sample->rate = sample->increment = no_increment_;
  }
  part_.increment = no_increment_;
}

void EnergyBalance::restart() noexcept
{
  accounts_ = EnergyAccounts();
  opened_ = goes_on_ = false;
}

void EnergyBalance::go_on_from(const EnergyBalance& before) noexcept
{
  accounts_ = before.accounts_;
  opened_ = false;
  goes_on_ = before.opened_ || before.goes_on_;
}

void EnergyBalance::begin_step(const State& state, const Setpoints& setpoints) noexcept
{
  drill_rig_sim::begin_step(*model_, state, 0.0, setpoints, stage_);
  prepare_start(state, stage_);
  stage_.drive.rate_0 = state.drive.speed;
  if (opened_)
    start_ = stored_energy(*model_, state, stage_, no_increment_.data(), work_);
  else
    open(state);
  find_reshaped(state);
  find_loads(state);
  if (!opened_)
  {
    loads_before_ = loads_;
    begin_accounts();
  }
  opened_ = true;
  part_.shaft_turn.setZero();
  part_.time = part_.line_paid_out = part_.floor_moved = part_.rotor_increment = part_.rock_advance = 0.0;
  std::fill(part_.increment.begin(), part_.increment.end(), 0.0);
}

void EnergyBalance::begin_accounts() noexcept
{
  const StoredEnergy& last = accounts_.last;
  if (goes_on_)
    accounts_.handled += start_.kinetic_all() + start_.elastic_all() - last.kinetic_all() - last.elastic_all();
  else
    accounts_.first = start_;
  accounts_.last = start_;
  goes_on_ = false;
}

/// What the beams lost between the steps for another reason than the pump's pressure: guided pipe changes the side on which it
/// lies, and kinds of nodes change. Their energy at the pressures of the step before distinguishes it from what the pressure
/// does.
void EnergyBalance::find_reshaped(const State& state) noexcept
{
  reshaped_ = 0.0;
  if (!stage_.any_guided || !opened_) return;
  const auto by_pressure = [&](std::size_t e) { return stage_.free_stretch[e] - state.spans[e].free_stretch; };
  for (std::size_t e = 0; e < pressure_.size(); ++e)
  {
    const double more = pressure_[e] - by_pressure(e);
    stage_.free_stretch[e] += more;
    stage_.guides.stretch[e] -= more * model_->mesh().elements[e].section.length;
  }
  reshaped_ = accounts_.last.beams - stored_energy(*model_, state, stage_, no_increment_.data(), work_).beams;
}

void EnergyBalance::find_loads(const State& state) noexcept
{
  for (std::size_t e = 0; e < loads_.size(); ++e)
  {
    const double weight = model_->element_weight(static_cast<int>(e), state.nodes[e].position.z(),
                                                 state.nodes[e + 1].position.z(), state.hydraulics.bore_top);
    loads_[e] = {weight, stage_.load[e] + weight * Eigen::Vector3d::UnitZ()};
  }
}

/// Forces and accelerations where nothing has been booked yet: the accelerations are those that the forces make.
void EnergyBalance::open(const State& state) noexcept
{
  std::vector<double>& residual = before_.force[static_cast<std::size_t>(NodeForce::unsolved)];
  evaluate(*model_, state, stage_, no_increment_.data(), work_, residual.data(), nullptr);
  expand_motions(stage_, work_);
  accelerate(*model_, stage_, residual.data(), work_);
  for (std::size_t i = 0; i < stage_.acceleration.size(); ++i) stage_.acceleration[i] = work_.nodes[i].acceleration;
  sample_energy(*model_, state, stage_, no_increment_.data(), work_, before_);
  start_ = before_.stored;
}

void EnergyBalance::end_step(const State& start, const Stage& stage, const double* u) noexcept
{
  sample_energy(*model_, start, stage, u, work_, after_);
  count_from_last_part();
  book_jump();
  book_inputs();
  book_dissipation();
  book_numerical();
  accounts_.last = after_.stored;
  for (std::size_t e = 0; e < pressure_.size(); ++e) pressure_[e] = stage.free_stretch[e] - start.spans[e].free_stretch;
  accounts_.largest_kinetic = std::max(accounts_.largest_kinetic, after_.stored.kinetic_all());
  accounts_.time += after_.step;
  start_ = after_.stored;
  loads_before_ = loads_;
  std::swap(before_, after_);
}

/// The sample counts from the start of the step; the accounts want what has come since the last part.
void EnergyBalance::count_from_last_part() noexcept
{
  const auto since = [](auto& sample, auto& part)
  {
    const auto all = sample;
    sample -= part;
    part = all;
  };
  since(after_.step, part_.time);
  since(after_.line_paid_out, part_.line_paid_out);
  since(after_.floor_moved, part_.floor_moved);
  since(after_.rotor_increment, part_.rotor_increment);
  since(after_.rock_advance, part_.rock_advance);
  since(after_.shaft.turn, part_.shaft_turn);
  for (std::size_t k = 0; k < part_.increment.size(); ++k) since(after_.increment[k], part_.increment[k]);
}

/// What the stored energies lost between the end of the last step and the start of this one.
void EnergyBalance::book_jump() noexcept
{
  const StoredEnergy &end = accounts_.last, &start = start_;
  const double contact = end.wall + end.bottom - start.wall - start.bottom + reshaped_,
               stuck = end.stuck_point - start.stuck_point;
  const double translation = end.kinetic - start.kinetic;
  const double stretched = end.beams - start.beams - reshaped_;  // by the pump's pressure, which changes between steps
  // between steps hole and mud motor move on, and with them the limits of friction: bristles beyond them slip
  const double slip = end.bristles - start.bristles, bit_slip = end.bit_bristle - start.bit_bristle;
  accounts_.wall_friction += slip;
  accounts_.rock_torque += bit_slip;
  accounts_.correction += contact;
  accounts_.stuck_point_released += stuck;
  accounts_.added_mass += translation;
  accounts_.pump -= stretched;
  accounts_.of_rebasing += end.kinetic_all() + end.elastic_all() - start.kinetic_all() - start.elastic_all() - contact - stuck -
                           translation - stretched - slip - bit_slip;
}

/// Mean force times mean rate times time.
double EnergyBalance::work_in_time(NodeForce kind) const noexcept
{
  const std::vector<double>&f = force_of(before_, kind), &g = force_of(after_, kind);
  double sum = 0.0;
  for (std::size_t k = 0; k < f.size(); ++k) sum += (f[k] + g[k]) * (before_.rate[k] + after_.rate[k]);
  return 0.25 * after_.step * sum;
}

/// The same of forces that are constant in a step and change with the set points between two.
double EnergyBalance::work_of_step(NodeForce kind) const noexcept
{
  const std::vector<double>& f = force_of(after_, kind);
  double sum = 0.0;
  for (std::size_t k = 0; k < f.size(); ++k) sum += f[k] * (before_.rate[k] + after_.rate[k]);
  return 0.5 * after_.step * sum;
}

/// Mean force times increment.
double EnergyBalance::work_along(NodeForce kind) const noexcept
{
  const std::vector<double>&f = force_of(before_, kind), &g = force_of(after_, kind);
  double sum = 0.0;
  for (std::size_t k = 0; k < f.size(); ++k) sum += (f[k] + g[k]) * after_.increment[k];
  return 0.5 * sum;
}

/// Mean moment times what the shaft turns beyond the collar.
double EnergyBalance::work_at_pivot(Eigen::Vector3d ShaftSample::*moment) const noexcept
{
  return 0.5 * (before_.shaft.*moment + after_.shaft.*moment).dot(after_.shaft.turn);
}

/// The method holds weight and lift for a step, at its end they change: their mean counts, as that of all other forces does.
void EnergyBalance::book_loads() noexcept
{
  double lifted = 0.0, lifted_now = 0.0, lighter = 0.0;
  for (std::size_t e = 0; e < loads_.size(); ++e)
  {
    const Eigen::Map<const Eigen::Vector3d> lower(&after_.increment[6 * e]), upper(&after_.increment[6 * e + 6]);
    const Eigen::Vector3d moved = 0.5 * (lower + upper);
    lifted += 0.5 * (loads_before_[e].lift + loads_[e].lift).dot(moved);
    lifted_now += loads_[e].lift.dot(moved);
    lighter += 0.5 * (loads_[e].weight - loads_before_[e].weight) * moved.z();
  }
  accounts_.pump += lifted;
  accounts_.gravity += start_.weight - after_.stored.weight - lifted_now + lighter;
}

void EnergyBalance::book_inputs() noexcept
{
  const double h = after_.step;
  accounts_.winch -= h * mean(before_.line_price, after_.line_price) * mean(before_.pay_out, after_.pay_out);
  accounts_.drive += h * mean(before_.drive_torque, after_.drive_torque) * mean(before_.rotor_speed, after_.rotor_speed);
  const std::size_t lift = after_.rate.size() - 4;  // of the block, z of the last node
  const double floor_speed = mean(before_.floor_speed, after_.floor_speed);
  const double block_speed = mean(before_.rate[lift], after_.rate[lift]) - floor_speed,
               winch_speed = mean(before_.winch_speed, after_.winch_speed);
  const double damper = h * mean(before_.line_damping, after_.line_damping),
               resistance = h * mean(before_.block_resistance, after_.block_resistance);
  accounts_.heave +=
      (h * mean(before_.hook_force + before_.slips_force, after_.hook_force + after_.slips_force) + damper + resistance) *
      floor_speed;
  accounts_.winch += damper * winch_speed;
  accounts_.block -= resistance * block_speed + damper * (block_speed - winch_speed) + after_.stored.block - start_.block;
  accounts_.gearbox -= h * mean(before_.gear_friction, after_.gear_friction) * mean(before_.rotor_speed, after_.rotor_speed) +
                       after_.stored.gear - start_.gear;
  book_loads();
  accounts_.steering += work_at_pivot(&ShaftSample::moment) - work_of_step(NodeForce::pads);
  const double torque = mean(before_.bit_torque + before_.gauge_torque, after_.bit_torque + after_.gauge_torque);
  const double pump = h * std::max(0.0, torque) * after_.motor_flow_speed;
  accounts_.pump += pump - work_in_time(NodeForce::oscillator);
  accounts_.motor_slip += pump - h * torque * after_.motor_speed;
}

void EnergyBalance::book_dissipation() noexcept
{
  const double h = after_.step;
  accounts_.structural += work_in_time(NodeForce::structural) + work_at_pivot(&ShaftSample::damping);
  accounts_.mud += work_in_time(NodeForce::mud);
  accounts_.squeeze_film += work_in_time(NodeForce::squeeze_film);
  accounts_.wall_damping += work_in_time(NodeForce::wall_damping);
  accounts_.ledge += work_in_time(NodeForce::ledge);
  // the bit's gauge turns with the motor
  accounts_.wall_friction += work_in_time(NodeForce::friction) +
                             h * mean(before_.gauge_torque, after_.gauge_torque) * after_.motor_speed + start_.bristles -
                             after_.stored.bristles;

  const Eigen::Map<const Eigen::Vector3d> v(before_.rate.data()), w(after_.rate.data());
  accounts_.bottom_damping += 0.25 * h * (before_.bottom_damping + after_.bottom_damping).dot(v + w) -
                              h * mean(before_.bottom_damped, after_.bottom_damped) * mean(before_.rock_speed, after_.rock_speed);
  accounts_.rock_thrust += h *
                           mean(before_.bottom_elastic + before_.bottom_damped, after_.bottom_elastic + after_.bottom_damped) *
                           mean(before_.rock_speed, after_.rock_speed);
  // the motor's speed is constant within a step
  const double bit_speed =
      mean(before_.bit_speed - before_.motor_speed, after_.bit_speed - after_.motor_speed) + after_.motor_speed;
  accounts_.rock_torque +=
      h * mean(before_.bit_torque, after_.bit_torque) * bit_speed + start_.bit_bristle - after_.stored.bit_bristle;
}

void EnergyBalance::book_numerical() noexcept
{
  const StoredEnergy &start = start_, &end = after_.stored;
  accounts_.of_inertia += work_along(NodeForce::inertia) +
                          mean(before_.rotor_inertia, after_.rotor_inertia) * after_.rotor_increment -
                          (end.kinetic_all() - start.kinetic_all());
  accounts_.of_beams += work_along(NodeForce::beams) + work_at_pivot(&ShaftSample::elastic) - (end.beams - start.beams);
  accounts_.of_residual -= work_along(NodeForce::unsolved);

  const Eigen::Map<const Eigen::Vector3d> bit_increment(after_.increment.data());
  accounts_.of_contact += work_along(NodeForce::wall) - (end.wall - start.wall) +
                          0.5 * (before_.bottom + after_.bottom).dot(bit_increment) -
                          mean(before_.bottom_elastic, after_.bottom_elastic) * after_.rock_advance - (end.bottom - start.bottom);
  accounts_.of_contact += work_along(NodeForce::stuck_point) +
                          mean(before_.slips_force, after_.slips_force) * after_.floor_moved -
                          (end.stuck_point - start.stuck_point);

  const double lift = after_.increment[after_.increment.size() - 4] - after_.floor_moved;  // of the block, z of the last node
  accounts_.of_line += -mean(before_.hook_force, after_.hook_force) * lift -
                       mean(before_.line_price, after_.line_price) * after_.line_paid_out - (end.line - start.line);
}

}  // namespace drill_rig_sim
