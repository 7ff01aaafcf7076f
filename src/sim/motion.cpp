// SPDX-License-Identifier: BSD-3-Clause
// From frame to frame: steps of one length, or steps as their errors allow (numerics.step 0), in strides of several frames.
#include "motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "between.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/interpolate.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/integrator_table.h"
#include "drill_rig_sim/solve/step_control.h"

namespace drill_rig_sim
{
Motion::Motion(const Scene& scene, std::shared_ptr<const Model> model, SimulatorState& state)
    : numerics_(scene.numerics),
      mechanics_(state.mechanics),
      forces_(state.forces),
      levels_(state.levels),
      stride_(state.stride),
      model_(std::move(model)),
      integrator_(make_integrator(numerics_.integrator, model_, mechanics_)),
      level_watch_(*model_),
      variable_(numerics_.has_variable_steps()),
      stride_end_(mechanics_),
      end_forces_(forces_),
      between_(mechanics_),
      forces_between_(forces_)
{
  levels_.free_length = std::min(free_length(scene), model_->mesh().nodes.back().from_bit);
  of_tools_ = nodes_of_tools();
}

double Motion::hole_depth() const noexcept
{
  const double start = mechanics_.well.hole_depth();
  return stride_.length > 0.0 ? start + stride_.played / stride_.length * (stride_end_.well.hole_depth() - start) : start;
}

double Motion::free_length_of(const Model& longer) const noexcept
{
  return level() == Level::beam3d ? longer.mesh().nodes.back().from_bit : levels_.free_length;
}

bool Motion::advance(double duration, const Setpoints& setpoints) noexcept
{
  if (lost_) return false;
  if (variable_) return advance_in_strides(duration, setpoints);
  level_watch_.look(*model_, forces_, duration, mechanics_, levels_);
  const int steps = std::max(1, static_cast<int>(std::lround(duration * numerics_.refinement / numerics_.step)));
  return take_steps(duration / steps, steps, setpoints);
}

/// Whole, from the state on.
bool Motion::take_steps(double step, int steps, const Setpoints& setpoints) noexcept
{
  for (int k = 0; k < steps; ++k)
  {
    if (!variable_) advance_mud(*model_, setpoints.pump.flow, step, mechanics_);
    if (!integrator_->advance(mechanics_, step, setpoints)) return false;
  }
  forces_ = integrator_->find_forces(mechanics_);
  return true;
}

bool Motion::advance_in_strides(double duration, const Setpoints& setpoints) noexcept
{
  const bool commanded = !(setpoints == stride_.setpoints);
  const bool fits = std::abs(std::remainder(stride_.length - stride_.played, duration)) < time_rounding;
  if ((commanded || !fits) && !settle()) return false;
  stride_.steady = commanded ? 0 : stride_.steady + 1;
  stride_.setpoints = setpoints;
  if (stride_.length == 0.0)
  {
    level_watch_.look(*model_, forces_, duration, mechanics_, levels_);
    if (!begin_stride(duration)) return take_steps(duration, 1, setpoints);
  }
  else
    levels_.unseen += duration;
  stride_.played += duration;
  if (stride_.played < stride_.length - time_rounding)
  {
    show_stride();
    return true;
  }
  mechanics_ = stride_end_;
  forces_ = end_forces_;
  stride_.length = stride_.played = 0.0;
  return true;
}

/// False: there is no step as long as two frames.
bool Motion::begin_stride(double duration) noexcept
{
  const double longest = std::min(mechanics_.step.wanted, longest_step - may_be_longer * duration);
  const double frames = std::min(std::floor(longest / duration + may_be_longer), static_cast<double>(stride_.steady));
  if (frames < 2.0) return false;
  if (balance_) *balance_before_ = *balance_;
  stride_.length = frames * duration;
  if (solve_stride()) return true;
  stride_.length = 0.0;
  if (balance_) *balance_ = *balance_before_;
  return false;
}

/// The stride's end, which depends only on its start, length and set points. False: it is too long for one step, and the start
/// wants a shorter one.
bool Motion::solve_stride() noexcept
{
  stride_end_ = mechanics_;
  if (!integrator_->take_one_step(stride_end_, stride_.length, stride_.setpoints))
  {
    mechanics_.step.wanted = stride_end_.step.wanted;
    return false;
  }
  end_forces_ = integrator_->find_forces(stride_end_);
  between_ = stride_end_;
  return true;
}

/// Of the state what every frame looks at: most frames need no more.
void Motion::show_stride() noexcept
{
  const double share = stride_.played / stride_.length;
  interpolate_rig(mechanics_, stride_end_, share, between_);
  interpolate_nodes(mechanics_, stride_end_, share, 0, of_tools_, between_);
  const std::size_t top = between_.nodes.size() - 1;
  interpolate_nodes(mechanics_, stride_end_, share, top, top + 1, between_);
  if (const int held = between_.slips.node; held >= 0)
  {
    const auto first = static_cast<std::size_t>(held);
    interpolate_nodes(mechanics_, stride_end_, share, first, first + 1, between_);
  }
  between_.time = now();
  interpolate_rig(forces_, end_forces_, share, forces_between_);
  whole_ = false;
}

/// The rest of it.
void Motion::show_whole() const noexcept
{
  if (stride_.length == 0.0 || whole_) return;
  const double share = stride_.played / stride_.length;
  interpolate_nodes(mechanics_, stride_end_, share, of_tools_, between_.nodes.size() - 1, between_);
  interpolate_loads(forces_, end_forces_, share, forces_between_);
  whole_ = true;
}

/// From the bit up to the measuring and steering tools.
std::size_t Motion::nodes_of_tools() const noexcept
{
  const Mesh& mesh = model_->mesh();
  const int highest =
      std::max({find_between(mesh, std::max(mesh.sensor_from_bit, 0.0)).lower + 1, mesh.steering_node(), mesh.bend_node, 0});
  return std::min(static_cast<std::size_t>(highest) + 1, mesh.nodes.size() - 1);
}

bool Motion::settle() noexcept
{
  if (stride_.length == 0.0) return true;
  const double played = stride_.played;
  stride_.length = stride_.played = 0.0;
  if (balance_) *balance_ = *balance_before_;
  lost_ = !take_steps(played, 1, stride_.setpoints);
  return !lost_;
}

bool Motion::set_free_length(double from_bit) noexcept
{
  if (!(from_bit >= 0.0) || from_bit > levels_.free_length) return false;
  if (numerics_.level == Level::rigid || has_no_levels(numerics_.integrator)) return false;
  settle();
  levels_.free_length = from_bit;
  levels_.moved = true;
  return true;
}

void Motion::go_on_with(std::shared_ptr<const Model> model, State state, RigForces forces, double free_length)
{
  mechanics_ = std::move(state);
  forces_ = std::move(forces);
  levels_.free_length = free_length;
  take_model(std::move(model));
}

void Motion::take_model(std::shared_ptr<const Model> model)
{
  std::unique_ptr<Integrator> next = make_integrator(numerics_.integrator, model, mechanics_);
  next->count_on_from(*integrator_);
  integrator_ = std::move(next);
  model_ = std::move(model);
  level_watch_ = LevelWatch(*model_);
  of_tools_ = nodes_of_tools();
  stride_end_ = between_ = mechanics_;
  end_forces_ = forces_between_ = forces_;
  if (!balance_) return;
  const std::unique_ptr<EnergyBalance> before = std::move(balance_);
  balance_ = std::make_unique<EnergyBalance>(model_);
  balance_->go_on_from(*before);
  balance_before_ = std::make_unique<EnergyBalance>(*balance_);
  integrator_->keep_balance(balance_.get());
}

void Motion::resume() noexcept
{
  integrator_->restart();
  lost_ = false;
  if (variable_ && stride_.length > 0.0)
  {
    if (solve_stride())
      show_stride();
    else
      settle();
  }
  if (!balance_) return;
  balance_->restart();
  *balance_before_ = *balance_;  // of the stride under way, whose start is not known
}

void Motion::balance_energy(bool on)
{
  integrator_->keep_balance(nullptr);
  balance_.reset();
  if (!on) return;
  balance_ = std::make_unique<EnergyBalance>(model_);
  balance_before_ = std::make_unique<EnergyBalance>(model_);
  integrator_->keep_balance(balance_.get());
}

const EnergyAccounts& Motion::energy() const noexcept
{
  static const EnergyAccounts none;
  return balance_ ? balance_->accounts() : none;
}

}  // namespace drill_rig_sim
