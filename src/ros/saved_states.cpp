// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/saved_states.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "drill_rig_sim/math/visit.h"
#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/sim/snapshot_file.h"

namespace drill_rig_sim
{
namespace
{
/// Adds up what a value's numbers take.
struct ByteCounter
{
  std::size_t bytes = 0;
  template <class N>
  void operator()(const std::string&, N&) noexcept
  {
    bytes += sizeof(N);
  }
  void size(const std::string&, std::size_t&) noexcept { bytes += sizeof(std::size_t); }
};

constexpr std::size_t names_shown = 20;
}  // namespace

std::size_t memory_of(const SimulatorState& state)
{
  ByteCounter counter;
  visit_numbers(const_cast<SimulatorState&>(state), counter);  // it only looks
  return counter.bytes;
}

namespace
{
/// What a file holds.
struct FileContent
{
  SimulatorState state;
  ScenePlayer player;
  bool playing;
  CommandStamps commands;

  template <class V>
  void visit(V& v)
  {
    v("state", state);
    v("player", player);
    v("playing", playing);
    v("commands", commands);
  }
};
}  // namespace

void write_saved(const std::string& file, const Saved& saved)
{
  const FileContent content{*saved.state, *saved.player, saved.playing, saved.commands};
  write_snapshot(file, saved.state->scene, {saved.kernel, to_bytes(content), fields_hash(content), saved.start});
}

Saved read_saved(const std::string& file, const Saved& present)
{
  FileContent content{*present.state, *present.player, present.playing, present.commands};
  const Snapshot snapshot = read_snapshot(file, present.state->scene, fields_hash(content), present.start);
  if (!from_bytes(snapshot.bytes, content)) throw std::runtime_error(file + ": is damaged");
  const auto set = [&present](std::int64_t& stamp) { stamp = stamp != 0 ? present.stamp : 0; };
  set(content.commands.last);
  for (std::int64_t& stamp : content.commands.accepted) set(stamp);
  return {std::make_shared<SimulatorState>(std::move(content.state)),
          content.player,
          content.playing,
          content.commands,
          snapshot.kernel,
          present.stamp,
          0,
          present.start};
}

void SavedStates::keep(const std::string& name, Saved saved)
{
  if (name.empty() || name.size() > longest_name)
    throw std::runtime_error("name has " + std::to_string(name.size()) + " bytes; allowed is a text of 1 to " +
                             std::to_string(longest_name));
  if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }))
    throw std::runtime_error("name has control characters; allowed is one line of text");
  if (saved_.size() >= most_states && saved_.count(name) == 0)
    throw std::runtime_error("there are " + std::to_string(saved_.size()) + " states; allowed are " +
                             std::to_string(most_states) + ": delete_state frees one");
  saved.bytes = memory_of(*saved.state);
  std::size_t memory = saved.bytes;
  for (const auto& [other, kept] : saved_)
    if (other != name) memory += kept.bytes;
  if (memory > most_memory)
    throw std::runtime_error("the states saved would take " + std::to_string(memory >> 20) + " MiB; allowed is " +
                             std::to_string(most_memory >> 20) + " MiB: delete_state frees one of " +
                             std::to_string(saved_.size()));
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
  throw std::runtime_error("there is no state " + name.substr(0, longest_name) +
                           " of this rig; saved are: " + (names.empty() ? "none" : names));
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
    response.bytes.push_back(saved.bytes);
  }
  response.limit = most_memory;
}

}  // namespace drill_rig_sim
