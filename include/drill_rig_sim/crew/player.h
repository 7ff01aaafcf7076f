// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_PLAYER_H
#define DRILL_RIG_SIM_CREW_PLAYER_H

#include "drill_rig_sim/crew/operations.h"
#include "drill_rig_sim/crew/program.h"

namespace drill_rig_sim
{
/// Plays all that a scene says to do: the lines of its program at their times, and its operations one after the other. Where both
/// set the same, the operation under way is the later one.
class ScenePlayer
{
public:
  /// Nothing to play.
  ScenePlayer() : ScenePlayer(Scene()) {}
  explicit ScenePlayer(const Scene& scene) : program_(scene.program), operations_(scene) {}

  /// Call before each frame.
  void apply(RigControls& rig) noexcept
  {
    program_.apply(rig);
    operations_.apply(rig);
  }
  bool finished() const noexcept { return program_.finished() && operations_.finished(); }
  void rewind() noexcept
  {
    program_.rewind();
    operations_.rewind();
  }
  const OperationsPlayer& operations() const noexcept { return operations_; }

  template <class V>
  void visit(V& v)
  {
    v("program", program_);
    v("operations", operations_);
  }

private:
  ProgramPlayer program_;
  OperationsPlayer operations_;
};

}  // namespace drill_rig_sim

#endif
