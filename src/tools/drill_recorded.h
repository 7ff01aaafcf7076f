// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_RECORDED_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_RECORDED_H

#include <functional>
#include <string>

#include "drill_rig_sim/ros/run_bag.h"
#include "drill_rig_sim/sim/run.h"

namespace drill_rig_sim
{
/// Whether a file's name is a bag's.
bool is_bag(const std::string& file);

/// A run of a bag once more: its scene's program up to the first command, from then on the set points in force as they were
/// recorded.
class RecordedPlayer
{
public:
  /// Throws UsageError where the bag does not say what was commanded from the start on. `file`: for messages.
  RecordedPlayer(std::string file, const RecordedRun& run, const Scene& scene);

  /// Simulated time that is recorded [s].
  double duration() const noexcept { return run_.rows.back().time; }
  /// Plays `duration` [s]. `after_frame` is called after each frame that was computed. Throws UsageError where what is simulated
  /// is not what was recorded.
  RunEnd play(Simulator& simulator, double duration, const std::function<void(const Truth&)>& after_frame);
  /// Of the frames: those of `drill run`, or as short as the recorded ones [s].
  double frame() const noexcept { return frame_; }

private:
  void command(Simulator& simulator, const Setpoints& setpoints);
  void require_recorded(const Truth& truth, const RecordedRun::Row& row, double tolerance) const;

  std::string file_;
  const RecordedRun& run_;
  ScenePlayer program_;
  double frame_;
  Setpoints commanded_;  // last
  bool commands_ = false;
};

}  // namespace drill_rig_sim

#endif
