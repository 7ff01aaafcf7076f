// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/instruments/dynamics_tool.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
void DynamicsTool::begin_period(double time) noexcept
{
  sums_ = DynamicsReading();
  sums_.least_speed = std::numeric_limits<double>::max();
  sums_.largest_speed = std::numeric_limits<double>::lowest();
  began_ = time;
}

void DynamicsTool::add(double passed, const SubView& view) noexcept
{
  const Eigen::Vector3d acceleration = (view.velocity - last_velocity_) / passed;
  const double along = acceleration.dot(view.axis);
  sums_.weight += passed * (view.weight_below - view.tension);
  sums_.torque += passed * view.torque;
  sums_.speed += passed * view.spin_speed;
  sums_.least_speed = std::min(sums_.least_speed, view.spin_speed);
  sums_.largest_speed = std::max(sums_.largest_speed, view.spin_speed);
  sums_.bending_moment = std::max(sums_.bending_moment, view.bending_moment);
  sums_.axial_acceleration = std::max(sums_.axial_acceleration, std::abs(along));
  sums_.lateral_acceleration = std::max(sums_.lateral_acceleration, (acceleration - along * view.axis).norm());
}

DynamicsReading DynamicsTool::reading(double time, double md) const noexcept
{
  DynamicsReading r = sums_;
  r.sequence = count_;
  r.time = time;
  r.md = md;
  r.duration = time - began_;
  for (double* mean : {&r.weight, &r.torque, &r.speed}) *mean /= r.duration;
  const double mean = std::abs(r.speed);
  r.stick_slip = mean >= turning ? (r.largest_speed - r.least_speed) / (2.0 * mean) : 0.0;
  return r;
}

void DynamicsTool::update(double time, double flow, const SubView& view) noexcept
{
  if (spec_.period <= 0.0) return;
  if (!started_) begin_period(time);
  if (started_ && time > last_time_) add(time - last_time_, view);
  started_ = true;
  last_time_ = time;
  last_velocity_ = view.velocity;
  const bool flowing = flow > least_flow_of_pulses;
  if (time >= began_ + spec_.period - time_rounding)
  {
    ++count_;
    if (flowing) queue_.push(reading(time, view.md), time);
    begin_period(time);
  }
  if (flowing) queue_.pop_before(time - spec_.latency + time_rounding, arrived_);
}

}  // namespace drill_rig_sim
