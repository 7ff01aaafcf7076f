#include "drill_rig_sim/sim/instruments.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kFlowing = 1e-4;  // [m3/s]

double rounded(double value, double resolution) noexcept
{
  return resolution > 0.0 ? resolution * std::round(value / resolution) : value;
}

double turned_to_circle(double azimuth) noexcept
{
  const double a = std::fmod(azimuth, 2.0 * pi);
  return a < 0.0 ? a + 2.0 * pi : a;
}
}  // namespace

double NoiseSource::uniform() noexcept
{
  // splitmix64 (Steele, Lea and Flood 2014)
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  z ^= z >> 31;
  return (static_cast<double>(z >> 11) + 0.5) / 9007199254740992.0;
}

double NoiseSource::normal() noexcept
{
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  return radius * std::cos(2.0 * pi * uniform());
}

Sensor::Sensor(const SensorSpec& spec, double interval) : spec_(spec)
{
  line_.resize(static_cast<std::size_t>(spec.delay / interval) + 2);
}

double Sensor::read(double truth, double time, NoiseSource& noise) noexcept
{
  line_[next_] = {time, truth};
  next_ = (next_ + 1) % line_.size();
  held_ = std::min(held_ + 1, line_.size());
  // the newest sample that is old enough; until one is, the oldest there is
  double delayed = truth;
  for (std::size_t back = 1; back <= held_; ++back)
  {
    const Sample& sample = line_[(next_ + line_.size() - back) % line_.size()];
    delayed = sample.value;
    if (sample.time <= time - spec_.delay + 1e-9) break;
  }
  const double elapsed = started_ ? time - last_time_ : 0.0;
  filtered_ = started_ ? delayed + (filtered_ - delayed) * std::exp(-elapsed / std::max(spec_.filter_time, 1e-12)) : delayed;
  started_ = true;
  last_time_ = time;
  return filtered_ + spec_.bias + (spec_.noise > 0.0 ? spec_.noise * noise.normal() : 0.0);
}

void Sensor::shift_time(double shift) noexcept
{
  for (Sample& sample : line_) sample.time += shift;
  last_time_ += shift;
}

template <class Reading>
void Mwd::Queue<Reading>::push(const Reading& r) noexcept
{
  if (count == entry.size()) return;  // telemetry is saturated: the reading is lost, as downhole
  entry[(first + count++) % entry.size()] = r;
}

template <class Reading>
bool Mwd::Queue<Reading>::pop_before(double time, Reading& r) noexcept
{
  if (count == 0 || entry[first].time > time) return false;
  r = entry[first];
  first = (first + 1) % entry.size();
  --count;
  return true;
}

Mwd::Mwd(const MwdSpec& survey, const ToolfaceSpec& toolface) : survey_(survey), toolface_(toolface) {}

void Mwd::shift_time(double shift) noexcept
{
  for (MwdReading& r : surveys_.entry) r.time += shift;
  for (ToolfaceReading& r : toolfaces_.entry) r.time += shift;
  next_survey_ += shift;
  next_toolface_ += shift;
}

MwdReading Mwd::measure(double time, const SensorView& view, NoiseSource& noise) const noexcept
{
  MwdReading r;
  r.time = time;
  r.md = view.md;
  r.inclination = inclination_of(view.axis);
  r.azimuth = azimuth_of(view.axis);
  if (survey_.noise > 0.0)
  {
    r.inclination += survey_.noise * noise.normal();
    r.azimuth += survey_.noise * noise.normal();
  }
  r.inclination = std::abs(rounded(r.inclination, survey_.inclination_resolution));
  r.azimuth = turned_to_circle(r.azimuth);
  return r;
}

void Mwd::update(double time, double flow, const SensorView& view, NoiseSource& noise, MwdReading& survey,
                 ToolfaceReading& toolface) noexcept
{
  const bool flowing = flow > kFlowing;
  const bool pumps_on = flowing && !flowing_;
  flowing_ = flowing;
  const bool by_period = survey_.period > 0.0 && flowing && time >= next_survey_;
  if (by_period || (survey_.period <= 0.0 && pumps_on))
  {
    MwdReading r = measure(time, view, noise);
    r.sequence = ++survey_count_;
    surveys_.push(r);
    next_survey_ = time + survey_.period;
  }
  if (flowing && time >= next_toolface_)
  {
    const ToolfaceReference reference = toolface_reference(view.axis, magnetic_);
    magnetic_ = reference.magnetic;
    ToolfaceReading r;
    r.sequence = ++toolface_count_;
    r.time = time;
    r.magnetic = reference.magnetic;
    const double noisy = survey_.noise > 0.0 ? survey_.noise * noise.normal() : 0.0;
    r.toolface = std::remainder(angle_about(view.axis, reference.direction, view.scribe) + survey_.scribe_offset + noisy, 2.0 * pi);
    toolfaces_.push(r);
    next_toolface_ = time + toolface_.period;
  }
  surveys_.pop_before(time - survey_.latency + 1e-9, survey);
  toolfaces_.pop_before(time - toolface_.latency + 1e-9, toolface);
}

}  // namespace drill_rig_sim
