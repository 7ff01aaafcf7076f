#ifndef DRILL_RIG_SIM_MODEL_FORCES_FORCE_H
#define DRILL_RIG_SIM_MODEL_FORCES_FORCE_H

#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/model/energy_sample.h"
#include "drill_rig_sim/model/stage_context.h"

namespace drill_rig_sim
{
/// A force: one law with all that belongs to it, in a file of its own. A list of them makes a problem (lists.h): dynamics and statics are
/// two lists, the reference's string and contacts two more.
struct Force
{
  const char* name;
  Cost cost;  ///< what the profiler books its time on

  /// Adds what resists the motion to the residual and, unless null, its exact derivative to the tangent; writes its part of
  /// work.result.
  void (*add)(const StageContext& at, double* residual, BlockTridiagonal* tangent) noexcept;
  /// Adds what it holds at this instant; null: nothing.
  void (*store)(const StageContext& at, StoredEnergy& energy) noexcept;
  /// Adds its forces, by kind, and the rates that its power needs; null: its power is in another force's sample.
  void (*sample)(const StageContext& at, EnergySample& sample) noexcept;
};

/// Six numbers of node `i`.
inline Eigen::Map<Vector6d> at_node(double* values, int i) noexcept
{
  return Eigen::Map<Vector6d>(values + 6 * i);
}

inline Eigen::Map<Vector6d> at_node(EnergySample& sample, NodeForce kind, int i) noexcept
{
  return at_node(sample.force[static_cast<std::size_t>(kind)].data(), i);
}

}  // namespace drill_rig_sim

#endif
