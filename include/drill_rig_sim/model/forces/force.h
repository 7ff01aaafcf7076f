// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_FORCE_H
#define DRILL_RIG_SIM_MODEL_FORCES_FORCE_H

#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/model/energy_sample.h"
#include "drill_rig_sim/model/stage_context.h"

namespace drill_rig_sim
{
/// Six numbers of node `i`.
inline Eigen::Map<Vector6d> at_node(double* values, int i) noexcept
{
  return Eigen::Map<Vector6d>(values + 6 * i);
}

inline Eigen::Map<Vector6d> at_node(EnergySample& sample, NodeForce kind, int i) noexcept
{
  return at_node(sample.force[static_cast<std::size_t>(kind)].data(), i);
}

/// Where forces are added up: the residual, six numbers a node, and unless it is not asked for the tangent. Each node takes six
/// numbers, whatever its level: what acts on a guided node is then brought down to its two coordinates (forces/guided_string.h).
class ForceRows
{
public:
  ForceRows(Workspace& work, double* residual, BlockTridiagonal* tangent) noexcept
      : work_(work), residual_(residual), tangent_(tangent)
  {
  }

  /// What resists the motion of node i, to be added to: force and moment, world axes [N, N m].
  Eigen::Map<Vector6d> force(int i) const noexcept
  {
    open(i);
    return at_node(residual_, i);
  }
  bool with_tangent() const noexcept { return tangent_ != nullptr; }
  /// Its derivative by the node's increment; only with_tangent().
  BlockTridiagonal::Block slope(int i) const noexcept
  {
    open(i);
    return tangent_->diagonal(i);
  }
  /// The first force on a guided node finds zeros there; those who use the next two call this for it.
  void open(int i) const noexcept
  {
    unsigned char& open = work_.rows_open[static_cast<std::size_t>(i)];
    if (open) return;
    open = 1;
    at_node(residual_, i).setZero();
    if (tangent_) tangent_->diagonal(i).setZero();
  }
  /// All rows, for laws that write many free nodes at a time.
  double* residual() const noexcept { return residual_; }
  BlockTridiagonal* tangent() const noexcept { return tangent_; }

private:
  Workspace& work_;
  double* residual_;
  BlockTridiagonal* tangent_;
};

/// Which sum of those who integrate the bodies themselves (the reference) a force is in.
enum class Sum
{
  none,
  string,   ///< elements, and mud on the nodes
  contact,  ///< wall, rock and what else touches
};

/// A force: one law with all that belongs to it, in a file of its own and a line of the list of all (lists.h). It acts alike on
/// free and guided nodes: it reads their motion by StageContext::node() and adds to ForceRows.
struct Force
{
  using Add = void (*)(const StageContext& at, const ForceRows& to) noexcept;

  const char* name;
  Cost cost;  ///< the profiler's account of it
  Sum sum;

  /// Adds what resists the motion to the residual and, with_tangent(), its exact derivative; writes its part of work.result.
  Add add;
  /// The same at rest or in steady sliding; null: it is no part of statics.
  Add add_static;
  /// add() where only work.result is asked for (update()); null: it has none.
  Add find_results;
  /// Adds what it holds at this instant; null: nothing.
  void (*store)(const StageContext& at, StoredEnergy& energy) noexcept;
  /// Adds its forces, by kind, and the rates that its power needs; null: its power is in another force's sample.
  void (*sample)(const StageContext& at, EnergySample& sample) noexcept;
};

}  // namespace drill_rig_sim

#endif
