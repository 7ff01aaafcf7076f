// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/mailbox.h"

#include "drill_rig_sim/ros/signals.h"

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
  const SignalHold until_it_is_on_the_master;
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
  for (auto& stamp : come_) stamp = none;
}

bool Mailbox::answered(unsigned kinds, std::int64_t stamp) noexcept
{
  for (int k = 0; k < command_kinds; ++k)
    if ((kinds >> k & 1u) != 0 && come_[static_cast<std::size_t>(k)] < stamp) return false;
  for (auto& come : come_) come = none;
  return true;
}

}  // namespace drill_rig_sim
