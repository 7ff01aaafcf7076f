#include "drill_rig_sim/ros/mailbox.h"

#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
Mailbox::Mailbox(ros::NodeHandle& node)
{
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  subscribers_[0] = node.subscribe<WinchCommand>(
      "winch/command", 1, [this](const WinchCommand::ConstPtr& m) { winch_.write(to_setpoint(*m)); }, {}, hints);
  subscribers_[1] = node.subscribe<TopDriveCommand>(
      "top_drive/command", 1, [this](const TopDriveCommand::ConstPtr& m) { top_drive_.write(to_setpoint(*m)); }, {}, hints);
  subscribers_[2] = node.subscribe<MudPumpCommand>(
      "mud_pump/command", 1, [this](const MudPumpCommand::ConstPtr& m) { pump_.write(to_setpoint(*m)); }, {}, hints);
  subscribers_[3] = node.subscribe<SteeringCommand>(
      "steering/command", 1, [this](const SteeringCommand::ConstPtr&) { ++steering_refused_; }, {}, hints);
}

void Mailbox::clear() noexcept
{
  winch_.read();
  top_drive_.read();
  pump_.read();
}

}  // namespace drill_rig_sim
