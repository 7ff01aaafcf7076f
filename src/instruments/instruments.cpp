// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/instruments/instruments.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double shortest_frame = 1e-3;   // a kilohertz [s]
constexpr std::size_t stream_of_mwd = 6;  // of noise: another gauge must not change its readings
}  // namespace

double RateMeter::rate(double depth, double time) noexcept
{
  if (held_ == 0 || time >= samples_[newest_].time + spacing - time_rounding)
  {
    newest_ = (newest_ + 1) % size;
    samples_[newest_] = {time, depth};
    held_ = std::min(held_ + 1, size);
  }
  const auto back = [this](std::size_t k) -> const Sample& { return samples_[(newest_ + size - k) % size]; };
  std::size_t age = held_ - 1;
  while (age > 1 && time > back(age).time + window + time_rounding) --age;
  const Sample& oldest = back(age);
  return time > oldest.time ? (depth - oldest.depth) / (time - oldest.time) : 0.0;
}

Instruments::Instruments(const Scene& scene, const Truth& at_start, std::uint64_t seed)
    : place_(scene.instruments.hook_load.place),
      block_weight_(standard_gravity * scene.rig.hoisting.block_mass),
      pump_noise_(scene.instruments.stand_pipe_pressure.pump_noise),
      hook_load_mean_(scene.rig.heave.wave_period()),
      zero_mean_(scene.rig.heave.wave_period())
{
  const InstrumentsSpec& spec = scene.instruments;
  const double interval = scene.numerics.step > 0.0 ? scene.numerics.step : shortest_frame;
  const std::array<const SensorSpec*, gauge_count> specs = {
#define GAUGE(type, name, ...) &spec.name,
#define GAUGE_LIKE(...) &spec.hook_load,
#include "drill_rig_sim/scene/signal_list.h"
  };
  for (std::size_t k = 0; k < specs.size(); ++k)
    gauges_[k] = Sensor(*specs[k], interval, NoiseSource::of(seed, k < stream_of_mwd ? k : k + 1));
  mwd_ = Mwd(spec.mwd, spec.toolface, NoiseSource::of(seed, stream_of_mwd));
  dynamics_ = DynamicsTool(spec.dynamics);
  tally_ = at_start.bit_depth + at_start.block_height;
  hole_depth_ = at_start.hole_depth;
}

/// While the slips carry the string its depth is held, and the tally follows the block: with all pipe that comes in and goes out.
void Instruments::read(const Truth& truth, const SensorView& view, Readings& readings) noexcept
{
  if (view.in_slips) tally_ = readings.bit_depth;
  static_cast<RigSignals&>(readings) = truth;
  read_gauges(truth, pump_noise_ > 0.0 ? pulsation_of(pump_noise_, view.pump_strokes) : 0.0, readings);
  hook_load_mean_.take(readings.hook_load, readings.time);
  zero_mean_.take(readings.hook_load, readings, truth.on_bottom);
  work_out_weights(readings);
  if (view.in_slips) tally_ += readings.block_height;
  work_out_depths(readings);
  mwd_.update(truth.time, truth.bit_flow, view, readings.mwd, readings.toolface);
  readings.inclination = mwd_.inclination();
  dynamics_.update(truth.time, truth.bit_flow, view.sub);
  readings.dynamics = dynamics_.arrived();
}

double pulsation_of(double amplitude, double strokes) noexcept
{
  constexpr double pistons = 3.0;
  return amplitude * std::sin(2.0 * pi * pistons * std::fmod(strokes, 1.0));
}

void Instruments::read_gauges(const Truth& truth, double pulsation, Readings& readings) noexcept
{
  const auto at_gauge = [&](Gauge gauge, double value)
  { return gauge == Gauge::stand_pipe_pressure && pulsation != 0.0 ? value * (1.0 + pulsation) : value; };
  readings.lost_gauges = 0;
  std::size_t k = 0;
#define GAUGE(type, name, ...) readings.name = gauges_[k++].read(at_gauge(Gauge::name, truth.name), truth.time);
#define GAUGE_LIKE GAUGE
#include "drill_rig_sim/scene/signal_list.h"
  if (place_ == HookLoadPlace::dead_line) readings.hook_load = readings.dead_line_hook_load;
  for (int g = 0; g < gauge_count; ++g) readings.lost_gauges |= source_of(static_cast<Gauge>(g)).is_lost() ? 1u << g : 0u;
}

void Instruments::work_out_weights(Readings& readings) const noexcept
{
  readings.tared = tared_;
  readings.hook_load_string = readings.hook_load - block_weight_;
  const bool has_weight = tared_ && !readings.in_slips;
  readings.surface_wob = has_weight ? tare_hook_load_ - readings.hook_load : 0.0;
  readings.mean_surface_wob = has_weight ? tare_hook_load_ - hook_load_mean_.mean() : 0.0;
  readings.differential_pressure = tared_ ? readings.stand_pipe_pressure - tare_pressure_ : 0.0;
}

void Instruments::work_out_depths(Readings& readings) noexcept
{
  readings.bit_depth = tally_ - readings.block_height;
  readings.hole_depth = hole_depth_ = std::max(hole_depth_, readings.bit_depth);
  readings.rop = rop_.rate(readings.hole_depth, readings.time);
}

void Instruments::tare(Readings& readings) noexcept
{
  set_zero(zero_mean_.mean(), readings.stand_pipe_pressure, readings);
}

Zero Instruments::tare_over(double duration, Readings& readings) noexcept
{
  const Zero zero = zero_mean_.window().over(duration);
  set_zero(zero.hook_load, zero.stand_pipe_pressure, readings);
  return zero;
}

void Instruments::set_zero(double hook_load, double pressure, Readings& readings) noexcept
{
  tared_ = true;
  tare_hook_load_ = hook_load;
  tare_pressure_ = pressure;
  work_out_weights(readings);
}

}  // namespace drill_rig_sim
