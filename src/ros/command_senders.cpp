// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/command_senders.h"

#include <iterator>

namespace drill_rig_sim
{
void CommandSenders::note(const std::string& topic, const std::string& node, const ros::SteadyTime& now)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  std::map<std::string, ros::SteadyTime>& nodes = heard_[topic];
  nodes[node] = now;
  for (auto entry = nodes.begin(); entry != nodes.end();)
    entry = (now - entry->second).toSec() > recent ? nodes.erase(entry) : std::next(entry);
}

std::string CommandSenders::trouble(const ros::SteadyTime& now) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  std::string text;
  for (const auto& [topic, nodes] : heard_)
  {
    std::string names;
    int count = 0;
    for (const auto& [node, heard] : nodes)
    {
      if ((now - heard).toSec() > recent) continue;
      if (count > 0) names += ", ";
      names += node;
      ++count;
    }
    if (count < 2) continue;
    if (!text.empty()) text += "; ";
    text.append(std::to_string(count)).append(" nodes publish ").append(topic).append(": ").append(names);
  }
  return text;
}

}  // namespace drill_rig_sim
