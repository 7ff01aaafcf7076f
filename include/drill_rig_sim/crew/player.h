// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_PLAYER_H
#define DRILL_RIG_SIM_CREW_PLAYER_H

#include "drill_rig_sim/crew/operations.h"
#include "drill_rig_sim/crew/program.h"
#include "drill_rig_sim/crew/rig_controls.h"

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
  /// A command from outside has taken over the rig, and nothing is played any more: a block that an operation moves is braked,
  /// unless the command was one `of_winch`.
  void hand_over(RigControls& rig, bool of_winch) const noexcept
  {
    const WinchSetpoint asked = rig.asked().winch;
    operations_.stop(rig);
    if (of_winch) rig.command(asked);
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
