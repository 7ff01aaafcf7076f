#include "drill_rig_sim/ros/saved_states.h"

#include <stdexcept>
#include <utility>

#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t per_well_node = 512;       // a node, its segment and its box
constexpr std::size_t well_picture = 16385 * 32;  // the last metres' raw path, when full
constexpr std::size_t sensor_lines = 65536;       // delay lines of the surface sensors

constexpr std::size_t names_shown = 20;
}  // namespace

std::size_t memory_of(const SimulatorState& state) noexcept
{
  const SystemForces& f = state.forces;
  const std::size_t numbers = f.tension.size() + f.torque.size() + f.bending_moment.size() + f.contact.size() + 3 * f.wall.size();
  return sizeof(SimulatorState) + state.mechanics.nodes.size() * sizeof(NodeState) + numbers * sizeof(double) +
         static_cast<std::size_t>(state.mechanics.well.node_count()) * per_well_node + well_picture + sensor_lines;
}

void SavedStates::keep(const std::string& name, Saved saved)
{
  if (name.empty() || name.size() > longest_name)
    throw std::runtime_error("name has " + std::to_string(name.size()) + " bytes; allowed is a text of 1 to " +
                             std::to_string(longest_name));
  std::size_t memory = memory_of(*saved.state);
  for (const auto& [other, kept] : saved_)
    if (other != name) memory += memory_of(*kept.state);
  if (memory > most_memory)
    throw std::runtime_error("the states saved would take " + std::to_string(memory >> 20) + " MiB; allowed is " +
                             std::to_string(most_memory >> 20) + " MiB: delete_state frees one of " + std::to_string(saved_.size()));
  saved_.insert_or_assign(name, std::move(saved));
}

std::map<std::string, Saved>::const_iterator SavedStates::at(const std::string& name) const
{
  const auto found = saved_.find(name);
  if (found != saved_.end()) return found;
  std::string names;
  std::size_t shown = 0;
  for (auto entry = saved_.begin(); entry != saved_.end() && shown < names_shown; ++entry, ++shown)
    names += (shown == 0 ? "" : ", ") + entry->first;
  if (shown < saved_.size()) names += " and " + std::to_string(saved_.size() - shown) + " more";
  throw std::runtime_error("there is no state " + name.substr(0, longest_name) + " of this rig; saved are: " +
                           (names.empty() ? "none" : names));
}

const Saved& SavedStates::find(const std::string& name) const
{
  return at(name)->second;
}

void SavedStates::remove(const std::string& name)
{
  saved_.erase(at(name));
}

void SavedStates::list(ListStates::Response& response) const
{
  for (const auto& [name, saved] : saved_)
  {
    response.names.push_back(name);
    response.stamps.push_back(to_time(saved.stamp));
    response.bytes.push_back(memory_of(*saved.state));
  }
  response.limit = most_memory;
}

}  // namespace drill_rig_sim
