// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_KERNELS_GUIDED_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_GUIDED_KERNEL_H

#include "drill_rig_sim/model/stage_context.h"

/// The inner loops over guided nodes, several at a time. They do what evaluate.cpp, guides.cpp and forces/guided_string.cpp do
/// node by node, to rounding.
namespace drill_rig_sim
{
constexpr double pressed = 50.0;  ///< a load that presses a guided node nearly to the wall [N]

/// `q` by the smallest turn that points its x axis along `tangent`.
Eigen::Quaterniond turned_to(const Eigen::Vector3d& tangent, const Eigen::Quaterniond& q) noexcept;

/// What the ends of a run of guided nodes lack: the elements beyond them are not guided.
void close_run(Stage& stage, Runs::Run nodes) noexcept;

/// Where forces go: 6 numbers of the residual a node, of node 0, and the small blocks of the tangent (BlockTridiagonal), null:
/// not wanted.
struct GuidedRows
{
  double* residual;
  double *diagonal, *upper, *lower;
};

/// A kernel's, at the two ends of a step. Runs of Stage::guided_nodes or inner_nodes.
struct GuidedStepKernel
{
  /// find_guides() of a run of nodes and the elements between them, but for what is only in the scene.
  void (*find)(const Model& model, const State& state, Stage& stage, Runs::Run nodes) noexcept;
  /// commit_guided() of inner nodes. `follows`: the share of its way that the string goes towards the side it is pressed to.
  void (*commit)(const Stage& stage, const Workspace& work, double follows, Runs::Run nodes, State& state) noexcept;
};

/// A kernel's, at a stage. Runs of Stage::guided_nodes, guided_elements or inner_nodes.
struct GuidedKernel
{
  /// Motion of guided nodes at the increments u: into Workspace::guided.
  void (*move)(const StageContext& at, const double* u, Runs::Run nodes) noexcept;
  /// Tension and torque of guided elements: into Workspace::guided.
  void (*find_tensions)(const StageContext& at, Runs::Run elements) noexcept;
  /// Forces at inner nodes: rows of residual and tangent, overwritten, and what Workspace has of them.
  void (*add)(const StageContext& at, Runs::Run inner_nodes, const GuidedRows& to) noexcept;
  /// Rows of six places to two coordinates and back (solve_increment()).
  void (*reduce)(const Stage& stage, Runs::Run nodes, double* b) noexcept;
  void (*expand)(const Stage& stage, Runs::Run nodes, double* b) noexcept;
  /// expand_motion() of inner nodes.
  void (*expand_motions)(const Stage& stage, Workspace& work, Runs::Run nodes) noexcept;
  /// find_string_forces() of guided elements.
  void (*find_forces)(const Stage& stage, Workspace& work, Runs::Run elements) noexcept;
};

/// Null: there is none, and one by one is the way.
const GuidedKernel* guided_kernel(Kernel kernel) noexcept;
const GuidedStepKernel* guided_step_kernel(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
