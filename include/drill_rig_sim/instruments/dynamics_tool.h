// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_INSTRUMENTS_DYNAMICS_TOOL_H
#define DRILL_RIG_SIM_INSTRUMENTS_DYNAMICS_TOOL_H

#include <Eigen/Core>
#include <cstdint>

#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/instruments/telemetry.h"
#include "drill_rig_sim/scene/instruments_spec.h"

namespace drill_rig_sim
{
/// What a sub sees of the string in which it sits.
struct SubView
{
  double md = 0.0;                                     ///< [m]
  double tension = 0.0;                                ///< effective, + tension [N]
  double weight_below = 0.0;                           ///< of what hangs below it in mud, along the string [N]
  double torque = 0.0;                                 ///< + drives what is below clockwise looking downhole [N m]
  double bending_moment = 0.0;                         ///< [N m]
  double spin_speed = 0.0;                             ///< [rad/s]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d axis = -Eigen::Vector3d::UnitZ();    ///< along the string, towards the bit
};

/// A tool that measures in each frame and sends what came of it by periods, late and not without flow, as the MWD does (mwd.h).
/// - weight = weight_below - tension, mean: what carries the string below it, its friction included; 0 for one that hangs;
/// - torque and speed mean, bending moment and speed at their extremes;
/// - stick-slip index (largest - least speed)/(2 mean): 1 where the pipe just stops, 0 for a mean below `turning`, as while
/// sliding;
/// - shocks: largest accelerations along and across the string, between frames: waves shorter than two frames are not in them.
class DynamicsTool
{
public:
  static constexpr double turning = 0.5;  ///< least mean speed of pipe that is turned, 5 rpm [rad/s]

  DynamicsTool() = default;
  explicit DynamicsTool(const DynamicsSpec& spec) : spec_(spec) {}
  /// A frame that ends at `time` [s].
  void update(double time, double flow, const SubView& view) noexcept;
  /// The last reading that has arrived.
  const DynamicsReading& arrived() const noexcept { return arrived_; }

  template <class V>
  void visit(V& v)
  {
    v("queue", queue_);
    v("arrived", arrived_);
    v("sums", sums_);
    v("began", began_);
    v("last_time", last_time_);
    v("last_velocity", last_velocity_);
    v("started", started_);
    v("count", count_);
  }

private:
  /// Of the frames of a period: mean values times time, and extremes.
  void begin_period(double time) noexcept;
  void add(double passed, const SubView& view) noexcept;
  DynamicsReading reading(double time, double md) const noexcept;

  DynamicsSpec spec_;
  TelemetryQueue<DynamicsReading> queue_;
  DynamicsReading arrived_, sums_;
  double began_ = 0.0, last_time_ = 0.0;
  Eigen::Vector3d last_velocity_ = Eigen::Vector3d::Zero();
  bool started_ = false;
  std::uint64_t count_ = 0;
};

}  // namespace drill_rig_sim

#endif
