// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_SAVED_STATES_H
#define DRILL_RIG_SIM_ROS_SAVED_STATES_H

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "drill_rig_sim/ListStates.h"
#include "drill_rig_sim/crew/player.h"
#include "drill_rig_sim/math/kernel.h"
#include "drill_rig_sim/realtime/frame_output.h"
#include "drill_rig_sim/scene/scene_hash.h"
#include "drill_rig_sim/sim/simulator_state.h"

namespace drill_rig_sim
{
/// A snapshot of the rig with what the node adds to it.
struct Saved
{
  std::shared_ptr<const SimulatorState> state;
  std::optional<ScenePlayer> player;
  bool playing = false;
  CommandStamps commands;
  Kernel kernel = Kernel::scalar;  ///< that the rig ran by
  std::int64_t stamp = 0;          ///< when it was taken [ns]
  std::size_t bytes = 0;           ///< memory_of(), once it is kept
  SceneStart start = {};           ///< of the rig
};

/// Writes a snapshot with its player's place into a file (sim/snapshot_file.h). Throws std::runtime_error with one line.
void write_saved(const std::string& file, const Saved& saved);
/// Reads it back for the rig that `present` is a snapshot of; throws std::runtime_error with one line for any other file. The
/// stamps of its commands, of another clock, become that of `present`: they are given anew.
Saved read_saved(const std::string& file, const Saved& present);

/// The snapshots of a rig by name, within a limit of memory. Refusals are std::runtime_error with one line.
class SavedStates
{
public:
  static constexpr std::size_t most_memory = std::size_t{256} << 20;  ///< of all together [B]
  static constexpr std::size_t most_states = 1000;                    ///< each reserves room for a whole well beside its values
  static constexpr std::size_t longest_name = 200;                    ///< [B]

  /// Keeps it in place of an earlier one of this name. Refuses an empty or long name and one with control characters, one more
  /// than most_states, and where the memory does not suffice.
  void keep(const std::string& name, Saved saved);
  /// Refuses a name that is not there. Valid until the next change.
  const Saved& find(const std::string& name) const;
  /// Refuses a name that is not there.
  void remove(const std::string& name);
  void clear() noexcept { saved_.clear(); }
  std::size_t count() const noexcept { return saved_.size(); }
  void list(ListStates::Response& response) const;

private:
  std::map<std::string, Saved>::const_iterator at(const std::string& name) const;
  std::map<std::string, Saved> saved_;
};

/// What a snapshot's values take [B]; room that its arrays hold in reserve is not counted.
std::size_t memory_of(const SimulatorState& state);

}  // namespace drill_rig_sim

#endif
