#include "drill_rig_sim/sim/mwd.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kFlowing = 1e-4;  // [m3/s]

double turned_to_circle(double azimuth) noexcept
{
  const double a = std::fmod(azimuth, 2.0 * pi);
  return a < 0.0 ? a + 2.0 * pi : a;
}
}  // namespace

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

Mwd::Mwd(const MwdSpec& survey, const ToolfaceSpec& toolface, NoiseSource noise) : survey_(survey), toolface_(toolface), noise_(noise) {}

void Mwd::shift_time(double shift) noexcept
{
  for (MwdReading& r : surveys_.entry) r.time += shift;
  for (ToolfaceReading& r : toolfaces_.entry) r.time += shift;
  next_survey_ += shift;
  next_toolface_ += shift;
}

MwdReading Mwd::measure(double time, const SensorView& view) noexcept
{
  MwdReading r;
  r.time = time;
  r.md = view.md;
  r.inclination = inclination_of(view.axis);
  r.azimuth = azimuth_of(view.axis);
  if (survey_.noise > 0.0)
  {
    r.inclination += survey_.noise * noise_.normal();
    r.azimuth += survey_.noise * noise_.normal();
  }
  r.inclination = std::abs(rounded(r.inclination, survey_.inclination_resolution));
  r.azimuth = turned_to_circle(r.azimuth);
  return r;
}

void Mwd::update(double time, double flow, const SensorView& view, MwdReading& survey,
                 ToolfaceReading& toolface) noexcept
{
  const bool flowing = flow > kFlowing;
  const bool pumps_on = flowing && !flowing_;
  flowing_ = flowing;
  if (!flowing) return;  // nothing is measured, and what is on its way waits: no pulse reaches the surface
  if (survey_.period > 0.0 ? time >= next_survey_ - time_rounding : pumps_on)
  {
    MwdReading r = measure(time, view);
    r.sequence = ++survey_count_;
    surveys_.push(r);
    next_survey_ = time + survey_.period;
  }
  if (time >= next_toolface_ - time_rounding)
  {
    const ToolfaceReference reference = toolface_reference(view.axis, magnetic_);
    magnetic_ = reference.magnetic;
    ToolfaceReading r;
    r.sequence = ++toolface_count_;
    r.time = time;
    r.magnetic = reference.magnetic;
    const double noisy = survey_.noise > 0.0 ? survey_.noise * noise_.normal() : 0.0;
    r.toolface = std::remainder(angle_about(view.axis, reference.direction, view.scribe) + survey_.scribe_offset + noisy, 2.0 * pi);
    toolfaces_.push(r);
    next_toolface_ = time + toolface_.period;
  }
  surveys_.pop_before(time - survey_.latency + time_rounding, survey);
  toolfaces_.pop_before(time - toolface_.latency + time_rounding, toolface);
}

}  // namespace drill_rig_sim
