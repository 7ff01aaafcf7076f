// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/solve/step_control.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/string/wave_impedance.h"

namespace drill_rig_sim
{
namespace
{
constexpr double steps_by_tolerance = 4.0 / 3.0;  // what is allowed, step^2, goes with the tolerance to the power of 3/2
constexpr double largest_share = 0.05;            // of the tolerance
constexpr double largest_place_error = 1e-2;      // over the tolerance [m]
constexpr double least_force = 1e3, least_torque = 100.0, least_speed = 0.1;  // what instruments resolve [N, N m, rad/s]
constexpr double share_of_level = 0.1;
constexpr double seen = 0.1;                          // share of what an instrument resolves below which no error matters
constexpr double along_may = 0.75;                    // what motions along the string are allowed over the rule
constexpr double peak_of_weight = 6.0;                // what a wrong weight on bit counts over one along the string
constexpr double peak_along = 2.8, peak_about = 3.3;  // of a wave's front over its root mean square along the string
constexpr double turning_speed = 5.0;                 // a bit that has never been as fast does not turn [rad/s]
constexpr double unneeded = 10.0;                     // what motions are allowed whose outputs are not needed
constexpr double most_damping = 5.0;                  // over the tolerance, of a bent motor's waves [1/s]
constexpr double steps_a_blade = 100.0;
constexpr double smooth_tolerance = 0.063;  // where fronts and smooth waves are allowed the same
constexpr double most_stretch = 10.0;
constexpr double settled_flow = 2e-3;   // of the nominal flow
constexpr double with_the_flow = 0.25;  // step over tolerance [s]

/// Of the tolerance, for waves that live so long [s] in a string that can swing by `slowest` [rad/s].
double share_of_tolerance(double slowest, double life) noexcept
{
  return std::min(largest_share, 1.0 / (slowest * life));
}

double scale(const ValueRange& range, double level, double least) noexcept
{
  return std::max({range.span(), share_of_level * std::abs(level), least});
}

double allowed_over(unsigned needs, unsigned those) noexcept
{
  return needs & those ? 1.0 : unneeded;
}
}  // namespace

StepControl::StepControl(const Model& model)
    : tolerance_(model.scene().numerics.tolerance / std::pow(model.scene().numerics.refinement, steps_by_tolerance)),
      resolved_(std::max(1.0, seen / tolerance_)),
      life_(model)
{
  if (model.motor() && model.motor()->bend != 0.0) shaking_ = 3.0;
  if (model.motor()) flow_that_settles_ = settled_flow * model.mud().circuit.nominal_flow;
  if (model.regenerative()) blades_ = model.bit().torque.blades;
  const Mesh& mesh = model.mesh();
  double time_along = 0.0, time_about = 0.0;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
  {
    const MeshNode& node = mesh.nodes[i];
    const BeamSection& section = mesh.elements[std::min(i, mesh.elements.size() - 1)].section;
    along_.push_back(std::sqrt(section.axial * node.mass / node.length));
    about_.push_back(torsional_impedance(section, node));
    share_.push_back(node.length / mesh.total_length);
    time_along += node.mass / along_.back();
    time_about += node.spin_inertia / about_.back();
  }
  slowest_ = {0.5 * pi / time_along, 0.5 * pi / time_about};  // a quarter of their waves is as long as the string
  const unsigned needs = model.scene().needs;
  const double rule = std::sqrt(tolerance_ / smooth_tolerance) * tolerance_;
  allowed_.along = along_may * rule * allowed_over(needs, ~(need_torque | need_bit_speed));
  allowed_.about = rule * allowed_over(needs, ~(need_hook_load | need_wob | need_pressure));
}

StepControl::Waves StepControl::allowed(const State& state) const noexcept
{
  const WaveLives life = life_.now(state);
  return {allowed_.along * share_of_tolerance(slowest_.along, life.along),
          allowed_.about * share_of_tolerance(slowest_.about, life.about)};
}

/// Times the step [s].
StepControl::Waves StepControl::output_error(const State& start, const Workspace& work, const double* error) const noexcept
{
  const StepMemory& memory = start.step;
  const RigForces& forces = work.result.forces;
  const double force = scale(memory.hook_load, forces.hook_load, resolved_ * least_force);
  const double torque = scale(memory.torque, forces.meter_torque, resolved_ * least_torque);
  const double bit_speed = scale(memory.bit_speed, forces.bit_speed, resolved_ * least_speed),
               turning = std::max(bit_speed, turning_speed);
  const auto parts_of = [&](std::size_t i)
  {
    const Eigen::Vector3d axis = x_axis(start.nodes[i].orientation);
    const Eigen::Map<const Vector6d> e(error + 6 * i);
    return std::pair<double, double>{std::abs(e.head<3>().dot(axis)), std::abs(e.tail<3>().dot(axis))};
  };
  Waves squares;
  for (std::size_t i = 0; i < along_.size(); ++i)
  {
    const auto [path, turn] = parts_of(i);
    const double of_along = along_[i] * path / force, of_about = std::max(about_[i] / torque, 1.0 / turning) * turn;
    squares.along += share_[i] * of_along * of_along;
    squares.about += share_[i] * of_about * of_about;
  }
  Waves out{peak_along * std::sqrt(squares.along), peak_about * std::sqrt(squares.about)};
  const auto [path, turn] = parts_of(0);
  if (forces.wob > 0.0)
    out.along = std::max(out.along, peak_of_weight * along_[0] * path / scale(memory.wob, forces.wob, resolved_ * least_force));
  out.about = std::max(out.about, turn / bit_speed);
  return out;
}

double StepControl::stretch(const State& start, const Workspace& work, const double* error, double step) const noexcept
{
  double place = 0.0;
  for (std::size_t k = 0; k < 6 * along_.size(); k += 6)
    for (std::size_t c = k; c < k + 3; ++c) place = std::max(place, std::abs(error[c]));
  const Waves wrong = output_error(start, work, error), may = allowed(start);
  const double of_outputs = std::max(wrong.along / may.along, wrong.about / may.about) / step;
  const double of_places = place / (largest_place_error * tolerance_);
  const double least = std::pow(most_stretch, -3);
  return std::min(1.0 / std::sqrt(std::max(of_outputs, least)), 1.0 / std::cbrt(std::max(of_places, least)));
}

double StepControl::longest(const State& state) const noexcept
{
  const double turning = std::abs(state.nodes[0].rate.spin), of_bit = std::abs(state.nodes[0].rate.spin + state.bit.motor_speed);
  double step = longest_step;
  if (shaking_ * turning > 0.0)
    step = std::min(step, std::cbrt(4.0 * most_damping * tolerance_ / std::pow(shaking_ * turning, 4)));
  if (flow_that_settles_ > 0.0 && std::abs(state.hydraulics.pump_flow - state.flow) > flow_that_settles_)
    step = std::min(step, with_the_flow * tolerance_);
  if (blades_ * of_bit > 0.0) step = std::min(step, 2.0 * pi / (steps_a_blade * blades_ * of_bit));
  return std::max(step, shortest_step);
}

void StepControl::note(const RigForces& forces, StepMemory& memory) noexcept
{
  if (!memory.begun)
  {
    memory.hook_load = {forces.hook_load, forces.hook_load};
    memory.torque = {forces.meter_torque, forces.meter_torque};
    memory.wob = {forces.wob, forces.wob};
    memory.bit_speed = {forces.bit_speed, forces.bit_speed};
    memory.begun = true;
  }
  memory.hook_load.add(forces.hook_load);
  memory.torque.add(forces.meter_torque);
  memory.wob.add(forces.wob);
  memory.bit_speed.add(forces.bit_speed);
}

}  // namespace drill_rig_sim
