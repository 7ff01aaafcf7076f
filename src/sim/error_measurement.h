// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_ERROR_MEASUREMENT_H
#define DRILL_RIG_SIM_SRC_SIM_ERROR_MEASUREMENT_H

#include "companions.h"

namespace drill_rig_sim
{
/// The run's error, as far as its first companion measures it (numerics.companion, accuracy/measured_error.h).
/// Owns `measured` of the rig's state, and the errors and the companion in its statistics. Nothing but restore() allocates.
class ErrorMeasurement
{
public:
  /// Both have to outlive this.
  ErrorMeasurement(SimulatedRig& rig, Companions& companions) noexcept;

  /// From the first frame on; error over the companion's difference [-].
  void begin(double error_over_difference) noexcept;
  /// It goes along, and is compared.
  bool is_under_way() const noexcept { return has_companion() && !companions_.has_ended(); }
  const MeasuredError& measured() const noexcept { return measured_; }
  /// Until companions have room for another frame.
  void make_room() noexcept;
  /// After a frame of the run, `duration` [s]: compares what is due, and warns where the error is above the tolerance. Waits for
  /// the companion where it is late, but for a pace that gives it up instead.
  void judge(double duration) noexcept;
  /// Waits for all frames that were ordered.
  void collect_all() noexcept;
  /// Companions and their measured error as of a state of the rig, which itself is restored already.
  void restore(const SimulatorState& saved);

private:
  bool has_companion() const noexcept;
  void collect() noexcept;
  void compare_frames() noexcept;
  void end(const char* reason) noexcept;

  SimulatedRig& rig_;
  Companions& companions_;
  MeasuredError& measured_;
  SimulatorStatistics& statistics_;
};

}  // namespace drill_rig_sim

#endif
