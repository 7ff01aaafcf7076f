#include "drill_rig_sim/ros/mailbox.h"

namespace drill_rig_sim
{
template <class Command>
ros::Subscriber Mailbox::subscribe(ros::NodeHandle& node, const std::string& topic)
{
  using Event = ros::MessageEvent<const Command>;
  const std::string name = node.resolveName(topic);
  ros::SubscribeOptions options;
  options.template initByFullCallbackType<const Event&>(topic, 1,
                                                        [this, name](const Event& event)
                                                        {
                                                          senders_.note(name, event.getPublisherName(), ros::SteadyTime::now());
                                                          receive(*event.getConstMessage());
                                                        });
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  return node.subscribe(options);
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
