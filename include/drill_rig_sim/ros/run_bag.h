// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_RUN_BAG_H
#define DRILL_RIG_SIM_ROS_RUN_BAG_H

#include <memory>
#include <string>
#include <vector>

#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// A run as a bag: the measurements that the node publishes, in the namespace `rig`, by the same topics and types. No master is
/// needed, and this header has no ROS in it: the offline runner includes it. Stamps are the simulated time; what is at 0 is not
/// written, for a stamp of 0 is none. Set points have the stamps of a program's, none.
class RunBag
{
public:
  /// Begins the file. Throws std::runtime_error with one line if it cannot, as every function here. `scene`: the run's, by which
  /// it can be played again. `with_companion`: the truth of the companion (numerics.companion) too, while it runs:
  /// companion/truth/rig_state, companion/truth/bit.
  RunBag(const std::string& file, const Scene& scene, bool with_companion = false);
  /// Ends it, without a word if that fails.
  ~RunBag();

  /// Call after each frame: telemetry that has arrived, once a second the accuracy, and with `due` the measurements.
  void add(const Simulator& simulator, bool due);
  /// Writes the index, without which a bag cannot be read.
  void close();

private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

/// What a bag holds of a run that can be played again, of RunBag or recorded of a node.
struct RecordedRun
{
  /// After a frame.
  struct Row
  {
    double time = 0.0;       ///< since the start of the rig [s]
    Setpoints setpoints;     ///< in force in that frame
    bool commanded = false;  ///< a command was accepted by then: from the first one on the scene's program is not played
    double hook_load = 0.0;  ///< as it is [N]
    double torque = 0.0;     ///< [N m]
  };
  std::string scene;  ///< a scene file; empty: the bag holds none
  std::vector<Row> rows;
};

/// Of a bag, the rig in the namespace `rig`, or the only one where that is empty, from its last start on. Throws
/// std::runtime_error with one line: file, what is wrong, what is needed.
RecordedRun read_recorded_run(const std::string& file, const std::string& rig);

}  // namespace drill_rig_sim

#endif
