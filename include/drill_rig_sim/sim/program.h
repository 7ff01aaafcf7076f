#ifndef DRILL_RIG_SIM_SIM_PROGRAM_H
#define DRILL_RIG_SIM_SIM_PROGRAM_H

#include <cstddef>
#include <vector>

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
class Simulator;

/// Plays a scene's program: gives the simulator each line's set points when its time has come.
class ProgramPlayer
{
public:
  explicit ProgramPlayer(std::vector<ProgramStep> steps);
  /// Applies every line with `at` <= the simulator's time that has not been applied yet. Call before each frame.
  void apply(Simulator& simulator) noexcept;
  bool finished() const noexcept { return next_ == steps_.size(); }
  void rewind() noexcept { next_ = 0; }

  /// Which line comes next; the lines are the scene's.
  template <class V>
  void visit(V& v)
  {
    v("next", next_);
  }

private:
  std::vector<ProgramStep> steps_;
  std::size_t next_ = 0;
};

}  // namespace drill_rig_sim

#endif
