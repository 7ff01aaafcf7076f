// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_INSTRUMENTS_INSTRUMENTS_H
#define DRILL_RIG_SIM_INSTRUMENTS_INSTRUMENTS_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "drill_rig_sim/instruments/dynamics_tool.h"
#include "drill_rig_sim/instruments/mwd.h"
#include "drill_rig_sim/instruments/period_mean.h"
#include "drill_rig_sim/instruments/sensor.h"
#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/instruments/zero_mean.h"
#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// The rate of a depth over a window that slides with time.
class RateMeter
{
public:
  static constexpr double window = 10.0;  ///< [s]

  /// Mean rate from the oldest sample within the window to `depth` [m] at `time` [s]; [m/s]. 0 for the first sample. Where calls
  /// are further apart than the window: from the last one.
  double rate(double depth, double time) noexcept;

  template <class V>
  void visit(V& v)
  {
    v("samples", samples_);
    v("newest", newest_);
    v("held", held_);
  }

private:
  static constexpr std::size_t size = 21;
  static constexpr double spacing = window / (size - 1);  // [s]
  struct Sample
  {
    double time = 0.0, depth = 0.0;

    template <class V>
    void visit(V& v)
    {
      v("time", time);
      v("depth", depth);
    }
  };
  std::array<Sample, size> samples_;  // ring
  std::size_t newest_ = 0, held_ = 0;
};

/// Pulsation of a triplex pump after its damper, relative: a sin(2 pi 3 s) of its strokes s, each of which turns the crank once
/// and moves three pistons. Higher harmonics and reflections in the lines are left out.
double pulsation_of(double amplitude, double strokes) noexcept;

/// The rig's gauges and what is worked out from them: from the truth to the readings, as signals.h (Readings) says.
class Instruments
{
public:
  Instruments() = default;
  /// The tally and the hole's depth are right at the start. `seed`: of the gauges' noise.
  Instruments(const Scene& scene, const Truth& at_start, std::uint64_t seed);
  /// Readings of a frame that ends as `truth` says, the MWD seeing `view`.
  void read(const Truth& truth, const SensorView& view, Readings& readings) noexcept;
  /// The string rings in the lines with this period [s] (ZeroMean).
  void rings_with(double period) noexcept { zero_mean_.rings_with(period); }
  /// Zeroes surface WOB at the hook load's mean (ZeroMean), differential pressure at what the gauge shows.
  void tare(Readings& readings) noexcept;
  /// Zeroes both at their means over the last `duration` [s] (ZeroWindow).
  Zero tare_over(double duration, Readings& readings) noexcept;
  /// How long hook load and pressure can be averaged over [s].
  double zero_held() const noexcept { return zero_mean_.window().held(); }
  /// What is wrong with the gauge that a reading comes from: hook_load's is the dead line's where the scene reads it there.
  SensorFault& fault_of(Gauge gauge) noexcept { return source_of(gauge).fault; }

  /// What they remember; their specifications are the scene's.
  template <class V>
  void visit(V& v)
  {
    v("gauges", gauges_);
    v("mwd", mwd_);
    v("dynamics", dynamics_);
    v("tally", tally_);
    v("hole_depth", hole_depth_);
    v("rop", rop_);
    v("hook_load_mean", hook_load_mean_);
    v("zero_mean", zero_mean_);
    v("tared", tared_);
    v("tare_hook_load", tare_hook_load_);
    v("tare_pressure", tare_pressure_);
  }

private:
  Sensor& source_of(Gauge gauge) noexcept
  {
    const bool dead_line = gauge == Gauge::hook_load && place_ == HookLoadPlace::dead_line;
    return gauges_[static_cast<std::size_t>(dead_line ? Gauge::dead_line_hook_load : gauge)];
  }
  void read_gauges(const Truth& truth, double pulsation, Readings& readings) noexcept;
  void set_zero(double hook_load, double pressure, Readings& readings) noexcept;
  void work_out_weights(Readings& readings) const noexcept;
  void work_out_depths(Readings& readings) noexcept;

  HookLoadPlace place_ = HookLoadPlace::dead_line;
  double block_weight_ = 0.0;               // with top drive [N]
  double pump_noise_ = 0.0;                 // of the stand-pipe pressure, as a share of it [-]
  std::array<Sensor, gauge_count> gauges_;  // by Gauge; the first at the block
  Mwd mwd_;
  DynamicsTool dynamics_;
  double tally_ = 0.0;       // of the pipe from the bit's face to the top-drive shaft [m]
  double hole_depth_ = 0.0;  // the bit's deepest so far [m]
  RateMeter rop_;
  PeriodMean hook_load_mean_;  // over a period of the waves: for mean_surface_wob
  ZeroMean zero_mean_;
  bool tared_ = false;
  double tare_hook_load_ = 0.0;  // [N]
  double tare_pressure_ = 0.0;   // [Pa]
};

}  // namespace drill_rig_sim

#endif
