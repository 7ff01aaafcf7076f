#ifndef DRILL_RIG_SIM_ROS_MAILBOX_H
#define DRILL_RIG_SIM_ROS_MAILBOX_H

#include <ros/ros.h>

#include <atomic>
#include <cstdint>
#include <string>

#include "drill_rig_sim/MudPumpCommand.h"
#include "drill_rig_sim/SteeringCommand.h"
#include "drill_rig_sim/TopDriveCommand.h"
#include "drill_rig_sim/WinchCommand.h"
#include "drill_rig_sim/realtime/triple_buffer.h"
#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/sim/commands.h"

namespace drill_rig_sim
{
/// Receives the command topics and keeps the latest of each kind for the simulation thread.
class Mailbox
{
public:
  /// On the command topics of `node`.
  explicit Mailbox(ros::NodeHandle& node);
  /// On no topic: for whoever calls receive() himself.
  Mailbox() = default;

  /// From any one thread: a command has come.
  void receive(const WinchCommand& m) noexcept { winch_.write(to_setpoint(m)); }
  void receive(const TopDriveCommand& m) noexcept { top_drive_.write(to_setpoint(m)); }
  void receive(const MudPumpCommand& m) noexcept { pump_.write(to_setpoint(m)); }
  void receive(const SteeringCommand&) noexcept { ++steering_refused_; }

  /// For the simulation thread: the latest set point not taken yet, or null.
  const WinchSetpoint* winch() noexcept { return winch_.read(); }
  const TopDriveSetpoint* top_drive() noexcept { return top_drive_.read(); }
  const PumpSetpoint* pump() noexcept { return pump_.read(); }

  /// Forgets what has not been taken yet; on the reader's side.
  void clear() noexcept;

  /// Steering commands received; none can be obeyed yet.
  std::uint64_t steering_refused() const noexcept { return steering_refused_; }

private:
  template <class Command>
  ros::Subscriber subscribe(ros::NodeHandle& node, const std::string& topic);

  TripleBuffer<WinchSetpoint> winch_;
  TripleBuffer<TopDriveSetpoint> top_drive_;
  TripleBuffer<PumpSetpoint> pump_;
  std::atomic<std::uint64_t> steering_refused_{0};
  ros::Subscriber subscribers_[4];
};

}  // namespace drill_rig_sim

#endif
