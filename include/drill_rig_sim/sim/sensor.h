#ifndef DRILL_RIG_SIM_SIM_SENSOR_H
#define DRILL_RIG_SIM_SIM_SENSOR_H

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

/// `value` to whole multiples of `resolution`; 0, or too small to be told beside the value: as it is.
double rounded(double value, double resolution) noexcept;

/// A surface sensor: delayed, filtered to first order, offset, noisy, and shown in steps of its resolution. With SensorSpec's defaults it
/// shows the signal to the last bit.
class Sensor
{
public:
  Sensor() = default;
  /// `interval` [s]: between samples, at the shortest; allocates the delay line. A long delay is held in steps of a 6000th of it.
  Sensor(const SensorSpec& spec, double interval, NoiseSource noise = {});
  /// Next reading of a signal that is `truth` at `time` [s].
  double read(double truth, double time) noexcept;
  /// Moves all it remembers by `shift` [s].
  void shift_time(double shift) noexcept;

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
  }

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

  SensorSpec spec_;
  double spacing_ = 0.0;  // between the delay line's samples, at the shortest [s]
  NoiseSource noise_;
  std::vector<Sample> line_;  // ring
  std::size_t next_ = 0, held_ = 0;
  double filtered_ = 0.0;
  double last_time_ = 0.0;
  bool started_ = false;
};

}  // namespace drill_rig_sim

#endif
