#include "drill_rig_sim/instruments/instruments.h"

#include <algorithm>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double shortest_frame = 1e-3;  // a kilohertz [s]
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

void RateMeter::shift_time(double shift) noexcept
{
  for (Sample& sample : samples_) sample.time += shift;
}

Instruments::Instruments(const Scene& scene, const Truth& at_start, std::uint64_t seed)
  : place_(scene.instruments.hook_load.place), block_weight_(standard_gravity * scene.rig.hoisting.block_mass), hook_load_mean_(scene.rig.heave.wave_period()), zero_mean_(scene.rig.heave.wave_period())
{
  const InstrumentsSpec& spec = scene.instruments;
  std::uint64_t index = 0;
  const double interval = scene.numerics.step > 0.0 ? scene.numerics.step : shortest_frame;
  const auto gauge = [&](const SensorSpec& s) { return Sensor(s, interval, NoiseSource::of(seed, index++)); };
  const std::array<const SensorSpec*, gauge_count> specs = {&spec.hook_load,           &spec.hook_load, &spec.torque,
                                                            &spec.stand_pipe_pressure, &spec.flow,      &spec.block_height};
  for (std::size_t k = 0; k < specs.size(); ++k) gauges_[k] = gauge(*specs[k]);
  mwd_ = Mwd(spec.mwd, spec.toolface, NoiseSource::of(seed, index++));
  dynamics_ = DynamicsTool(spec.dynamics);
  tally_ = at_start.bit_depth + at_start.block_height;
  hole_depth_ = at_start.hole_depth;
}

/// While the slips bear the string its depth is held, and the tally follows the block: with all pipe that comes in and goes out.
void Instruments::read(const Truth& truth, const SensorView& view, Readings& readings) noexcept
{
  if (view.in_slips) tally_ = readings.bit_depth;
  static_cast<RigSignals&>(readings) = truth;
  read_gauges(truth, readings);
  hook_load_mean_.take(readings.hook_load, readings.time);
  zero_mean_.take(readings.hook_load, readings);
  work_out_weights(readings);
  if (view.in_slips) tally_ += readings.block_height;
  work_out_depths(readings);
  readings.on_bottom = readings.motor_stalled = readings.over_stress = readings.over_torque = readings.buckled = false;
  mwd_.update(truth.time, truth.bit_flow, view, readings.mwd, readings.toolface);
  readings.inclination = mwd_.inclination();
  dynamics_.update(truth.time, truth.bit_flow, view.sub);
  readings.dynamics = dynamics_.arrived();
}

void Instruments::read_gauges(const Truth& truth, Readings& readings) noexcept
{
  const std::array<double, gauge_count> signals = {truth.hook_load,           truth.dead_line_hook_load, truth.torque,
                                                   truth.stand_pipe_pressure, truth.flow,                truth.block_height};
  std::array<double, gauge_count> shown;
  readings.lost_gauges = 0;
  for (std::size_t k = 0; k < signals.size(); ++k) shown[k] = gauges_[k].read(signals[k], truth.time);
  for (int k = 0; k < gauge_count; ++k) readings.lost_gauges |= source_of(static_cast<Gauge>(k)).is_lost() ? 1u << k : 0u;
  const auto of = [&shown](Gauge gauge) { return shown[static_cast<std::size_t>(gauge)]; };
  readings.dead_line_hook_load = of(Gauge::dead_line_hook_load);
  readings.hook_load = place_ == HookLoadPlace::block ? of(Gauge::hook_load) : readings.dead_line_hook_load;
  readings.torque = of(Gauge::torque);
  readings.stand_pipe_pressure = of(Gauge::stand_pipe_pressure);
  readings.flow = of(Gauge::flow);
  readings.block_height = of(Gauge::block_height);
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
  tared_ = true;
  tare_hook_load_ = zero_mean_.mean();
  tare_pressure_ = readings.stand_pipe_pressure;
  work_out_weights(readings);
}

void Instruments::shift_time(double shift) noexcept
{
  for (Sensor& gauge : gauges_) gauge.shift_time(shift);
  mwd_.shift_time(shift);
  dynamics_.shift_time(shift);
  rop_.shift_time(shift);
  hook_load_mean_.shift_time(shift);
  zero_mean_.shift_time(shift);
}

}  // namespace drill_rig_sim
