#ifndef DRILL_RIG_SIM_ROS_RUN_BAG_H
#define DRILL_RIG_SIM_ROS_RUN_BAG_H

#include <memory>
#include <string>

#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// A run as a bag: the measurements that the node publishes, in the namespace `rig`, by the same topics and types. No master is
/// needed, and this header has no ROS in it: the offline runner includes it. Stamps are the simulated time; what is at 0 is not
/// written, for a stamp of 0 is none. Set points have the stamps of a program's, none. While a companion (numerics.companion) goes along, its
/// truth is there too: companion/truth/rig_state, companion/truth/bit.
class RunBag
{
public:
  /// Begins the file. Throws std::runtime_error with one line if it cannot, as every function here.
  explicit RunBag(const std::string& file);
  /// Ends it, without a word if that fails.
  ~RunBag();

  /// Call after each frame: telemetry that has arrived, and with `due` the measurements.
  void add(const Simulator& simulator, bool due);
  /// Writes the index, without which a bag cannot be read.
  void close();

private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace drill_rig_sim

#endif
