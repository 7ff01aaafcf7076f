// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_SIMULATED_RIG_H
#define DRILL_RIG_SIM_SRC_SIM_SIMULATED_RIG_H

#include <cstdint>

#include "command_intake.h"
#include "drill_rig_sim/solve/start.h"
#include "measurement.h"
#include "motion.h"
#include "pipe_handling.h"

namespace drill_rig_sim
{
struct FrameOrder;

/// One model of the rig: the run's own, or a companion. Its state, and the parts that work on it; each part owns fields of the
/// state, as its header says, and changes no other.
struct SimulatedRig
{
  /// At rest. Throws std::runtime_error with one line where there is no static equilibrium. `seed`: of the gauges' noise.
  SimulatedRig(const Scene& scene, std::uint64_t seed) : SimulatedRig(scene, seed, build_at_rest(scene)) {}
  SimulatedRig(const SimulatedRig&) = delete;
  SimulatedRig& operator=(const SimulatedRig&) = delete;

  /// The physics of a frame under `setpoints`, and what there is to be measured after it. False: `failure` says why.
  bool compute_frame(double duration, const Setpoints& setpoints) noexcept;
  /// A companion's frame; none once it has failed.
  void follow(const FrameOrder& order) noexcept;
  /// Makes up the string of a connection that is over. Allocates.
  void end_connection();
  /// False, and nothing changed: its string is not what it says. Allocates.
  bool restore(const SimulatorState& saved);
  /// Only the first reason counts; static storage.
  void fail(const char* reason) noexcept
  {
    if (!*failure) failure = reason;
  }
  /// Of a companion, for the run's statistics.
  CompanionStatistics as_companion() const noexcept
  {
    return {statistics.level, statistics.nodes, statistics.coordinates, statistics.costs.seconds()};
  }

  const Scene scene;
  SimulatorState state;
  SimulatorStatistics statistics;
  Motion motion;
  CommandIntake commands;
  PipeHandling pipe;
  Measurement measurement;
  const char* failure = "";  // empty while it runs
  bool has_begun = false;    // it is no longer at the scene's start

private:
  SimulatedRig(const Scene& scene, std::uint64_t seed, RigAtRest&& rig);
  void string_changed();
  void count_start() noexcept;
  void count_frame() noexcept;
};

}  // namespace drill_rig_sim

#endif
