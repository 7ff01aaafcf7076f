#include "drill_rig_sim/ros/mailbox.h"

namespace drill_rig_sim
{
template <class Command>
ros::Subscriber Mailbox::subscribe(ros::NodeHandle& node, const std::string& topic)
{
  return node.subscribe<Command>(
      topic, 1, [this](const boost::shared_ptr<const Command>& m) { receive(*m); }, {}, ros::TransportHints().tcpNoDelay());
}

Mailbox::Mailbox(ros::NodeHandle& node)
    : subscribers_{subscribe<WinchCommand>(node, "winch/command"), subscribe<TopDriveCommand>(node, "top_drive/command"),
                   subscribe<MudPumpCommand>(node, "mud_pump/command"), subscribe<SteeringCommand>(node, "steering/command")}
{
}

void Mailbox::clear() noexcept
{
  winch_.read();
  top_drive_.read();
  pump_.read();
  steering_.read();
}

}  // namespace drill_rig_sim
