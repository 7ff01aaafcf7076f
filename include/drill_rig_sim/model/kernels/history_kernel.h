// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_KERNELS_HISTORY_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_HISTORY_KERNEL_H

#include <vector>

#include "drill_rig_sim/math/kernel.h"
#include "drill_rig_sim/model/guides.h"

/// What a step takes from those before it and leaves to the next, several nodes at a time.
namespace drill_rig_sim
{
struct NodeMotion;
struct NodeRate;

/// Factors of a sum of the rates at the start of the step, the last rates and the second quantity of the method's memory. All are
/// in the axes of the step (in_step_axes()).
struct RateFactors
{
  double now, last, second;
};

/// By kernel.
struct HistoryKernel
{
  /// Sums of the first two: 6 per node, overwritten.
  void (*extrapolate)(const State& state, double of_now, double of_last, double* u) noexcept;
  /// Stage::rate and acceleration.
  void (*find_rates)(const State& state, const RateFactors& in_rate, const RateFactors& in_acceleration, Stage& stage) noexcept;
  /// split() of increments, rates or accelerations of a run of nodes.
  void (*split)(const Workspace& work, Eigen::Matrix<double, 6, 1> NodeMotion::*vector, Runs::Run nodes,
                std::vector<NodeRate>& out) noexcept;
  /// Of the rates, into the state.
  void (*split_rates)(const Workspace& work, Runs::Run nodes, State& state) noexcept;
  /// The state's rates with their tilts carried() along.
  void (*carry)(const Workspace& work, const State& state, Runs::Run nodes, std::vector<NodeRate>& out) noexcept;
  /// split() and carry() of a run of guided nodes, whose motions need not be known in six coordinates.
  void (*split_guided)(const Stage& stage, const Column& along, const Column& about, Runs::Run nodes,
                       std::vector<NodeRate>& out) noexcept;
  void (*carry_guided)(const Stage& stage, const Workspace& work, const State& state, Runs::Run nodes,
                       std::vector<NodeRate>& out) noexcept;
};

/// Null: there is none, and node by node is the way.
const HistoryKernel* history_kernel(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
