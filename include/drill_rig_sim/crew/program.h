// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_PROGRAM_H
#define DRILL_RIG_SIM_CREW_PROGRAM_H

#include <cstddef>
#include <vector>

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
class RigControls;

/// A set point on its way from one value to another, in a straight line over simulated time.
struct Ramp
{
  double from = 0.0, to = 0.0;      ///< [unit of the set point]
  double at = 0.0, duration = 0.0;  ///< when it begins, and for how long [s]
  bool running = false;

  /// Its value at simulated time `now` [s]: `from` before it begins, `to` itself once it is over.
  double value(double now) const noexcept;
  bool over(double now) const noexcept;

  template <class V>
  void visit(V& v)
  {
    v("from", from);
    v("to", to);
    v("at", at);
    v("duration", duration);
    v("running", running);
  }
};

/// When the last set point of a program is reached [s]; 0 for an empty one.
double program_end(const std::vector<ProgramStep>& steps) noexcept;

/// Plays a scene's program: gives the simulator each line's set points when its time has come, and those on a ramp before every
/// frame, as they are at its beginning. A ramp begins at the set point in force at the line's time; where another mode or a brake
/// holds the drive, at what the drive does then, and where the winch's brake holds the block, at 0. It ends early where a later
/// line sets the same set point, the other mode or the brake.
class ProgramPlayer
{
public:
  explicit ProgramPlayer(std::vector<ProgramStep> steps);
  /// Applies every line with `at` <= the simulator's time that has not been applied yet. Call before each frame. A line that
  /// cannot be (a stuck point below the bit, slips under a moving block) fails the simulator's next frame.
  void apply(RigControls& rig) noexcept;
  /// No line is left and no set point on its way.
  bool finished() const noexcept;
  void rewind() noexcept;

  /// Which line comes next and what is on its way; the lines are the scene's.
  template <class V>
  void visit(V& v)
  {
    v("next", next_);
    v("block_velocity", block_velocity_);
    v("top_drive_speed", top_drive_speed_);
    v("top_drive_torque", top_drive_torque_);
    v("flow", flow_);
  }

private:
  void begin(const ProgramStep& step, RigControls& rig) noexcept;
  void begin_winch(const ProgramStep& step, RigControls& rig) noexcept;
  void begin_top_drive(const ProgramStep& step, RigControls& rig) noexcept;
  void follow(double now, RigControls& rig) noexcept;

  std::vector<ProgramStep> steps_;
  std::size_t next_ = 0;
  Ramp block_velocity_, top_drive_speed_, top_drive_torque_, flow_;
};

}  // namespace drill_rig_sim

#endif
