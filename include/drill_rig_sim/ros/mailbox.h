#ifndef DRILL_RIG_SIM_ROS_MAILBOX_H
#define DRILL_RIG_SIM_ROS_MAILBOX_H

#include <ros/ros.h>

#include <atomic>
#include <cstdint>

#include "drill_rig_sim/MudPumpCommand.h"
#include "drill_rig_sim/SteeringCommand.h"
#include "drill_rig_sim/TopDriveCommand.h"
#include "drill_rig_sim/WinchCommand.h"
#include "drill_rig_sim/realtime/triple_buffer.h"
#include "drill_rig_sim/sim/commands.h"

namespace drill_rig_sim
{
/// Receives the command topics and keeps the latest of each kind for the simulation thread.
class Mailbox
{
public:
  explicit Mailbox(ros::NodeHandle& node);

  /// For the simulation thread: the latest set point not taken yet, or null.
  const WinchSetpoint* winch() noexcept { return winch_.read(); }
  const TopDriveSetpoint* top_drive() noexcept { return top_drive_.read(); }
  const PumpSetpoint* pump() noexcept { return pump_.read(); }

  /// Forgets what has not been taken yet; on the reader's side.
  void clear() noexcept;

  /// Steering commands received; none can be obeyed yet.
  std::uint64_t steering_refused() const noexcept { return steering_refused_; }

private:
  TripleBuffer<WinchSetpoint> winch_;
  TripleBuffer<TopDriveSetpoint> top_drive_;
  TripleBuffer<PumpSetpoint> pump_;
  std::atomic<std::uint64_t> steering_refused_{0};
  ros::Subscriber subscribers_[4];
};

}  // namespace drill_rig_sim

#endif
