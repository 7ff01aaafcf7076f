// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/instruments/mwd.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
double turned_to_circle(double azimuth) noexcept
{
  const double a = std::fmod(azimuth, 2.0 * pi);
  return a < 0.0 ? a + 2.0 * pi : a;
}
}  // namespace

Mwd::Mwd(const MwdSpec& survey, const ToolfaceSpec& toolface, NoiseSource noise)
    : survey_(survey), toolface_(toolface), noise_(noise)
{
}

double Mwd::measured_inclination(const SensorView& view) noexcept
{
  const double noise = survey_.noise > 0.0 ? survey_.noise * noise_.normal() : 0.0;
  return std::abs(rounded(inclination_of(view.axis) + noise, survey_.inclination_resolution));
}

MwdReading Mwd::measure(double time, const SensorView& view) noexcept
{
  MwdReading r;
  r.time = time;
  r.md = view.md;
  r.inclination = measured_inclination(view);
  r.azimuth = azimuth_of(view.axis);
  if (survey_.noise > 0.0) r.azimuth += survey_.noise * noise_.normal();
  r.azimuth = turned_to_circle(r.azimuth);
  return r;
}

void Mwd::rest(double time, const SensorView& view) noexcept
{
  if (survey_.period > 0.0 || survey_.quiet_time <= 0.0 || has_quiet_survey_) return;
  if (time < quiet_since_ + survey_.quiet_time - time_rounding) return;
  quiet_survey_ = measure(time, view);
  has_quiet_survey_ = true;
}

void Mwd::send_survey(double time, const SensorView& view) noexcept
{
  const bool of_the_quiet = survey_.period == 0.0 && survey_.quiet_time > 0.0;
  if (of_the_quiet && !has_quiet_survey_) return;
  MwdReading r = of_the_quiet ? quiet_survey_ : measure(time, view);
  has_quiet_survey_ = false;
  r.sequence = ++survey_count_;
  surveys_.push(r, time);
  next_survey_ = time + survey_.period;
}

void Mwd::send_toolface(double time, const SensorView& view) noexcept
{
  if (toolface_.max_speed > 0.0 && std::abs(view.spin_speed) > toolface_.max_speed) return;
  const ToolfaceReference reference = toolface_reference(view.axis, magnetic_);
  magnetic_ = reference.magnetic;
  ToolfaceReading r;
  r.sequence = ++toolface_count_;
  r.time = time;
  r.magnetic = reference.magnetic;
  const double deviation = std::isnan(toolface_.noise) ? survey_.noise : toolface_.noise;
  const double noisy = deviation > 0.0 ? deviation * noise_.normal() : 0.0;
  r.toolface = std::remainder(angle_about(view.axis, reference.direction, view.scribe) + survey_.scribe_offset + noisy, 2.0 * pi);
  if (toolface_.resolution > 0.0) r.toolface = std::remainder(rounded(r.toolface, toolface_.resolution), 2.0 * pi);
  toolfaces_.push(r, time);
  next_toolface_ = time + toolface_.period;
}

void Mwd::send_inclination(double time, const SensorView& view) noexcept
{
  inclinations_.push({++inclination_count_, time, view.md, measured_inclination(view)}, time);
  next_inclination_ = time + survey_.inclination_period;
}

void Mwd::update(double time, double flow, const SensorView& view, MwdReading& survey, ToolfaceReading& toolface) noexcept
{
  const bool flowing = flow > least_flow_of_pulses;
  const bool pumps_on = flowing && !flowing_;
  if (flowing_ && !flowing) quiet_since_ = time;
  flowing_ = flowing;
  if (!flowing) return rest(time, view);  // what is on its way waits: no pulse reaches the surface
  if (survey_.period > 0.0 ? time >= next_survey_ - time_rounding : pumps_on) send_survey(time, view);
  if (time >= next_toolface_ - time_rounding) send_toolface(time, view);
  if (survey_.inclination_period > 0.0 && time >= next_inclination_ - time_rounding) send_inclination(time, view);
  surveys_.pop_before(time - survey_.latency + time_rounding, survey);
  toolfaces_.pop_before(time - toolface_.latency + time_rounding, toolface);
  inclinations_.pop_before(time - survey_.latency + time_rounding, inclination_);
}

}  // namespace drill_rig_sim
