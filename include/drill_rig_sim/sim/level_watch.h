// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_LEVEL_WATCH_H
#define DRILL_RIG_SIM_SIM_LEVEL_WATCH_H

#include <vector>

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
/// What the watch remembers from frame to frame.
struct LevelMemory
{
  double free_length = 0.0;  ///< nodes up to here above the bit's face are free, windows apart [m]
  bool moved = false;        ///< since the last frame
  double calm = 0.0;         ///< how long all pipe in windows could have been guided [s]
  double unseen = 0.0;       ///< frames since the last look, which were within a step [s]
  std::uint64_t opened = 0;  ///< windows since the start, and those that grew
  std::uint64_t closed = 0;

  template <class V>
  void visit(V& v)
  {
    v("free_length", free_length);
    v("moved", moved);
    v("calm", calm);
    v("unseen", unseen);
    v("opened", opened);
    v("closed", closed);
  }
};

/// Level of a string whose nodes are free up to `free_length` above the bit's face [m].
Level level_of(const Model& model, double free_length) noexcept;

/// Sets nodes free and guides them, between two frames: as the memory's free length wants, whenever that is moved.
/// Level hybrid besides: guided pipe is set free before it is compressed so far that it could buckle, wherever in the string that
/// is, and guided again when it is not. A window opens where an element next to a guided node carries 0.6 of its buckling load
/// (string_watch.h), over 30 m up and down from there; all windows close when for 10 s no element in them carried more than 0.4
/// of it.
class LevelWatch
{
public:
  explicit LevelWatch(const Model& model);

  /// Before a frame of `duration` [s]; `forces`: of the step before.
  void look(const Model& model, const RigForces& forces, double duration, State& state, LevelMemory& memory) noexcept;

private:
  void follow(const Model& model, double free_length) noexcept;
  bool open(const Model& model, const RigForces& forces, const State& state) noexcept;
  bool calm(const Model& model, const RigForces& forces, const State& state) const noexcept;

  double free_length_;
  std::vector<unsigned char> guided_;  // by that length
  std::vector<unsigned char> wanted_;
};

}  // namespace drill_rig_sim

#endif
