// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_MEASUREMENT_H
#define DRILL_RIG_SIM_SRC_SIM_MEASUREMENT_H

#include <cmath>
#include <cstdint>

#include "command_intake.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/string_watch.h"
#include "motion.h"

namespace drill_rig_sim
{
/// From the state to the truth, and through the rig's gauges to the readings; the zero of weight and pressure; the watch on the
/// model's limits. Owns `truth`, `instruments`, `readings`, `zero_mean`, the tare and `accuracy` of the simulator's state, and
/// the loads and the accuracy in the statistics.
class Measurement
{
public:
  /// Measures and reads the rig as it starts. All of these have to outlive this. `seed`: of the gauges' noise.
  Measurement(const Scene& scene, const Motion& motion, const CommandIntake& commands, std::uint64_t seed, SimulatorState& state,
              SimulatorStatistics& statistics);

  /// After the motion of a frame of `duration` [s].
  void measure(double duration) noexcept;
  /// The readings of what was measured.
  void read() noexcept;
  /// Readings or truth, as numerics.judge says: the values whose error is measured.
  Outputs judged() const noexcept;
  /// Slips and crew between two frames, in truth and readings.
  void show_pipe_handling() noexcept;
  /// Zeroes surface WOB and differential pressure, true ones and readings.
  void tare() noexcept;
  /// The same zeroes at their means over the last `duration` [s]; what the gauges were zeroed at.
  Zero tare_over(double duration) noexcept;
  /// How long the gauges can be averaged over for that [s].
  double zero_held() const noexcept { return instruments_.zero_held(); }
  SensorFault& fault_of(Gauge gauge) noexcept { return instruments_.fault_of(gauge); }
  /// Shows the measured error as what limits accuracy, where the model's limits do not: they come first.
  void warn_of_error(const AccuracyReport& report) noexcept;
  /// The motion's model is another one. Allocates.
  void string_changed();
  /// After the simulator's state was restored.
  void resume() noexcept
  {
    statistics_.accuracy = accuracy_.report;
    looked_at_ = NAN;
  }

private:
  void note_ring() noexcept;
  void take_zero(double hook_load) noexcept;
  void measure_all() noexcept;
  void measure_rig() noexcept;
  void measure_block() noexcept;
  void measure_bit() noexcept;
  void measure_string() noexcept;
  void look_at_loads() noexcept;
  void measure_string_built() noexcept;
  double motor_pressure() const noexcept;
  SensorView sensor_view() const noexcept;
  SubView sub_view() const noexcept;

  const Scene& scene_;
  const Motion& motion_;
  const CommandIntake& commands_;
  const SimulatorState& state_;  // only read
  Truth& truth_;
  Instruments& instruments_;
  Readings& readings_;
  ZeroMean& zero_mean_;
  bool& tared_;
  double& tare_hook_load_;  // true one [N]
  double& tare_pressure_;   // true one over the motor [Pa]
  AccuracyMemory& accuracy_;
  SimulatorStatistics& statistics_;
  StringWatch watch_;
  double looked_at_ = NAN;  // time of the state whose loads these are [s]
};

}  // namespace drill_rig_sim

#endif
