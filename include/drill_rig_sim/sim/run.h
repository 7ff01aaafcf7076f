// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_RUN_H
#define DRILL_RIG_SIM_SIM_RUN_H

#include <functional>
#include <limits>

#include "drill_rig_sim/crew/player.h"
#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// Where a run ends: at whichever comes first.
struct RunGoal
{
  double duration = 0.0;                                   ///< simulated time that the run takes [s]
  double depth = std::numeric_limits<double>::infinity();  ///< measured depth of the hole [m]; infinite where only time counts
  /// Simulated time that the run waits for a millimetre of new hole once nothing is left to play, or for the operation under way
  /// to get nearer its end, connections apart [s]
  double patience = std::numeric_limits<double>::infinity();
  double goes_on =
      std::numeric_limits<double>::infinity();  ///< simulated time that the run goes on once nothing is left to play [s]
};

/// What ended a run.
enum class RunEnd
{
  duration,    ///< its time is over
  depth,       ///< the hole is as deep as the goal says
  standstill,  ///< the goal's patience is over
  trouble,     ///< an operation was given up (OperationStatus::trouble)
  played,      ///< nothing has been left to play for as long as the goal goes on
  failure      ///< a frame failed; Simulator::failure() says why
};

/// One frame of `duration` [s], a multiple of the scene's step: what the player has for it, what the crew does
/// (Simulator::attend()), then the physics. Without a player (null) the set points in force stay. The node's loop and run() both
/// play by this.
FrameStatus play_frame(Simulator& simulator, ScenePlayer* player, double duration) noexcept;

/// The multiple of `step` that is nearest to `length`, at least one step; all in seconds.
double frame_of_whole_steps(double length, double step) noexcept;

/// Plays frame by frame until the goal, on from the simulator's present time.
/// `frame_length` [s]: rounded to whole steps of the scene. `after_frame` is called after each frame that was computed, with the
/// truth then; it may be empty. What it throws ends the run and reaches the caller.
RunEnd run(Simulator& simulator, ScenePlayer& player, const RunGoal& goal, double frame_length,
           const std::function<void(const Truth&)>& after_frame = {});

}  // namespace drill_rig_sim

#endif
