#include "drill_averages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
double Averages::count() const noexcept
{
  return samples_ > 0 ? static_cast<double>(samples_) : std::numeric_limits<double>::quiet_NaN();
}

void Averages::add(const Truth& m) noexcept
{
  if (samples_ == 0) first_time_ = m.time;
  ++samples_;
  sum_.hook_load += m.hook_load;
  sum_.torque += m.torque;
  sum_.wob += m.wob;
  sum_.bit_torque += m.bit_torque;
  sum_.bit_speed += m.bit_speed;
  sum_.rop += m.rop;
  sum_.hole_depth += m.hole_depth;
  position_ += m.bit_position;
  const double sine = std::sin(m.bit_inclination);
  direction_ += Eigen::Vector3d(sine * std::sin(m.bit_azimuth), sine * std::cos(m.bit_azimuth), -std::cos(m.bit_inclination));
}

void Averages::add(const Averages& other) noexcept
{
  if (other.samples_ == 0) return;
  first_time_ = samples_ == 0 ? other.first_time_ : std::min(first_time_, other.first_time_);
  samples_ += other.samples_;
  sum_.hook_load += other.sum_.hook_load;
  sum_.torque += other.sum_.torque;
  sum_.wob += other.sum_.wob;
  sum_.bit_torque += other.sum_.bit_torque;
  sum_.bit_speed += other.sum_.bit_speed;
  sum_.rop += other.sum_.rop;
  sum_.hole_depth += other.sum_.hole_depth;
  position_ += other.position_;
  direction_ += other.direction_;
}

double Averages::inclination() const noexcept
{
  if (samples_ == 0) return std::numeric_limits<double>::quiet_NaN();
  return std::atan2(std::hypot(direction_.x(), direction_.y()), -direction_.z());
}

double Averages::azimuth() const noexcept
{
  if (samples_ == 0) return std::numeric_limits<double>::quiet_NaN();
  const double angle = std::atan2(direction_.x(), direction_.y());
  return angle < 0.0 ? angle + 2.0 * pi : angle;
}

void DrillingRecord::add(const Truth& m)
{
  if (!m.on_bottom) return;
  if (slices_.empty() || m.time >= slices_.back().first_time() + slice_length) slices_.emplace_back();
  slices_.back().add(m);
}

Averages DrillingRecord::all() const
{
  Averages sum;
  for (const Averages& slice : slices_) sum.add(slice);
  return sum;
}

Averages DrillingRecord::last_quarter() const
{
  Averages sum;
  const std::size_t quarter = (slices_.size() + 3) / 4;
  for (std::size_t i = slices_.size() - quarter; i < slices_.size(); ++i) sum.add(slices_[i]);
  return sum;
}

}  // namespace drill_rig_sim
