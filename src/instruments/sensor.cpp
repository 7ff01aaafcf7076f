// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/instruments/sensor.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double most_samples = 6000.0;  // of a delay line: 60 s at the node's 100 Hz

/// splitmix64 (Steele, Lea and Flood 2014)
std::uint64_t next(std::uint64_t& state) noexcept
{
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}
}  // namespace

double rounded(double value, double resolution) noexcept
{
  constexpr double most_steps = 4503599627370496.0;  // 2^52: beyond, a step is finer than the value's own last bit
  const double steps = value / resolution;
  return resolution > 0.0 && std::abs(steps) < most_steps ? resolution * std::round(steps) : value;
}

NoiseSource NoiseSource::of(std::uint64_t seed, std::uint64_t index) noexcept
{
  // hashed twice: seeds and indices that lie close together, as they do, must not give each other's streams
  std::uint64_t mixed = seed;
  mixed = next(mixed) ^ index;
  return {next(mixed)};
}

double NoiseSource::uniform() noexcept
{
  return (static_cast<double>(next(state) >> 11) + 0.5) / 9007199254740992.0;
}

double NoiseSource::normal() noexcept
{
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  return radius * std::cos(2.0 * pi * uniform());
}

Sensor::Sensor(const SensorSpec& spec, double interval, NoiseSource noise)
    : spec_(spec), spacing_(std::max(interval, spec.delay / most_samples)), noise_(noise)
{
  line_.resize(static_cast<std::size_t>(spec.delay / spacing_) + 2);
}

double Sensor::read(double truth, double time) noexcept
{
  remember(truth, time);
  const double seen = delayed(truth, time);
  const double passed = started_ ? time - last_time_ : 0.0;
  // exact for a signal that is held between samples
  filtered_ = started_ ? seen + (filtered_ - seen) * std::exp(-passed / std::max(spec_.filter_time, 1e-12)) : seen;
  drop_out(passed);
  fault.drifted += fault.drift * passed;
  if (sample_is_due(time))
  {
    const double reading = sample(time);
    if (!started_ || !(is_lost() || fault.frozen)) shown_ = reading;
  }
  started_ = true;
  last_time_ = time;
  return shown_;
}

/// Whether it is lost after `passed` [s].
void Sensor::drop_out(double passed) noexcept
{
  if (spec_.dropout_interval <= 0.0) return;
  const double lose = 1.0 / spec_.dropout_interval, find = 1.0 / spec_.dropout_duration;
  const double turns = -std::expm1(-(lose + find) * passed) / (lose + find);
  if (noise_.uniform() < turns * (lost_ ? find : lose)) lost_ = !lost_;
}

bool Sensor::sample_is_due(double time) noexcept
{
  if (spec_.rate <= 0.0) return true;
  if (!started_) next_sample_ = time;
  const double late = time - next_sample_ + time_rounding;
  if (late < 0.0) return false;
  next_sample_ += (1.0 + std::floor(late * spec_.rate)) / spec_.rate;
  return true;
}

double Sensor::sample(double time) noexcept
{
  if (spec_.drift > 0.0 && started_) wandered_ += spec_.drift * std::sqrt(time - last_sample_) * noise_.normal();
  const double outlier = outlier_after(started_ ? time - last_sample_ : 0.0);
  last_sample_ = time;
  const double noise = std::hypot(spec_.noise, fault.noise);
  const double shown =
      filtered_ + spec_.bias + wandered_ + fault.bias + fault.drifted + (noise > 0.0 ? noise * noise_.normal() : 0.0) + outlier;
  return rounded(shown, spec_.resolution);
}

/// By which a sample is off that comes `passed` [s] after the one before.
double Sensor::outlier_after(double passed) noexcept
{
  if (spec_.outlier_interval <= 0.0) return 0.0;
  const double drawn = noise_.uniform(), likely = -std::expm1(-passed / spec_.outlier_interval);
  if (drawn >= likely) return 0.0;
  return drawn < 0.5 * likely ? spec_.outlier_size : -spec_.outlier_size;
}

void Sensor::remember(double truth, double time) noexcept
{
  if (held_ > 0 && time < line_[(next_ + line_.size() - 1) % line_.size()].time + spacing_ - time_rounding) return;
  line_[next_] = {time, truth};
  next_ = (next_ + 1) % line_.size();
  held_ = std::min(held_ + 1, line_.size());
}

/// The newest sample that is old enough; until one is, the oldest there is.
double Sensor::delayed(double truth, double time) const noexcept
{
  if (spec_.delay <= 0.0) return truth;
  double value = truth;
  for (std::size_t back = 1; back <= held_; ++back)
  {
    const Sample& sample = line_[(next_ + line_.size() - back) % line_.size()];
    value = sample.value;
    if (sample.time <= time - spec_.delay + time_rounding) break;
  }
  return value;
}

}  // namespace drill_rig_sim
