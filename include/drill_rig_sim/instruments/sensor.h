// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_INSTRUMENTS_SENSOR_H
#define DRILL_RIG_SIM_INSTRUMENTS_SENSOR_H

#include <cstdint>
#include <vector>

#include "drill_rig_sim/scene/instruments_spec.h"

namespace drill_rig_sim
{
/// A stream of random numbers whose whole state is one integer: a snapshot restores it exactly.
struct NoiseSource
{
  std::uint64_t state = 0;
  /// The stream of instrument `index` under `seed`: none is another's, none is another's shifted.
  static NoiseSource of(std::uint64_t seed, std::uint64_t index) noexcept;
  /// Uniform in (0, 1).
  double uniform() noexcept;
  /// Standard normal.
  double normal() noexcept;

  template <class V>
  void visit(V& v)
  {
    v("state", state);
  }
};

/// `value` to whole multiples of `resolution`; 0, or too small to change the value: as it is.
double rounded(double value, double resolution) noexcept;

/// What is wrong with a gauge beside its specification (sim/faults.h); all of it may be at once.
struct SensorFault
{
  bool frozen = false;   ///< it shows its last reading, without a sign
  bool dropped = false;  ///< as a drop-out that lasts
  double bias = 0.0;     ///< [unit of the signal]
  double noise = 0.0;    ///< standard deviation [unit of the signal]
  double drift = 0.0;    ///< [unit of the signal/s]
  double drifted = 0.0;  ///< by that, so far [unit of the signal]

  template <class V>
  void visit(V& v)
  {
    v("frozen", frozen);
    v("dropped", dropped);
    v("bias", bias);
    v("noise", noise);
    v("drift", drift);
    v("drifted", drifted);
  }
};

/// A surface sensor: what it measures is delayed and filtered to first order, sampled at its rate, offset, noisy, and shown in
/// steps of its resolution. With SensorSpec's defaults it shows the signal to the last bit.
///
/// - Filter: y' = (x - y)/T, exact for a signal x that is held between samples: y_n = x_n + (y_n-1 - x_n) e^(-h/T).
/// - Drift: the bias goes on by a random walk, b_n = b_n-1 + K sqrt(h) N(0, 1) from 0 at the start, so that after a time t its
/// standard
///   deviation is K sqrt(t): the rate random walk of IEEE Std 952-1997, annex C.
/// - Outliers: a Poisson process with the mean interval I. A sample that comes h after the one before is off by plus or minus the
/// outliers' size with the
///   probability 1 - e^(-h/I), by each sign as likely.
/// - Drop-outs: two states, good and lost, left at random at the rates a = 1/interval and b = 1/duration (Gilbert, Bell System
/// Technical
///   Journal 39 (1960), 1253-1265, in continuous time). From a frame to the next, h later, a good one is lost with the
///   probability a/(a + b) (1 - e^(-(a + b) h)), a lost one good with b/(a + b) (...): of all time b/(a + b) is good. A gauge
///   that is lost shows its last reading, as a rig's acquisition does that substitutes the last good value, and is_lost() reports
///   it, as the current of a loop does that has left 4 to 20 mA (NAMUR NE 43).
class Sensor
{
public:
  Sensor() = default;
  /// `interval` [s]: between samples, at the shortest; allocates the delay line. A long delay is held in steps of a 6000th of it.
  Sensor(const SensorSpec& spec, double interval, NoiseSource noise = {});
  /// Next reading of a signal that is `truth` at `time` [s].
  double read(double truth, double time) noexcept;
  /// In a drop-out: the last reading() is an old one.
  bool is_lost() const noexcept { return lost_ || fault.dropped; }

  /// What it remembers; its specification is the scene's.
  template <class V>
  void visit(V& v)
  {
    v("noise", noise_);
    v("line", line_);
    v("next", next_);
    v("held", held_);
    v("filtered", filtered_);
    v("last_time", last_time_);
    v("started", started_);
    v("next_sample", next_sample_);
    v("last_sample", last_sample_);
    v("wandered", wandered_);
    v("lost", lost_);
    v("shown", shown_);
    v("fault", fault);
  }

  SensorFault fault;

private:
  struct Sample
  {
    double time, value;

    template <class V>
    void visit(V& v)
    {
      v("time", time);
      v("value", value);
    }
  };
  void remember(double truth, double time) noexcept;
  double delayed(double truth, double time) const noexcept;
  void drop_out(double passed) noexcept;
  bool sample_is_due(double time) noexcept;
  double sample(double time) noexcept;
  double outlier_after(double passed) noexcept;

  SensorSpec spec_;
  double spacing_ = 0.0;  // between the delay line's samples, at the shortest [s]
  NoiseSource noise_;
  std::vector<Sample> line_;  // ring
  std::size_t next_ = 0, held_ = 0;
  double filtered_ = 0.0;
  double last_time_ = 0.0;
  bool started_ = false;
  double next_sample_ = 0.0, last_sample_ = 0.0;  // [s]
  double wandered_ = 0.0;                         // of the bias, by its drift
  bool lost_ = false;
  double shown_ = 0.0;
};

}  // namespace drill_rig_sim

#endif
