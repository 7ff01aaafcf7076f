// SPDX-License-Identifier: BSD-3-Clause
#include "drill_averages.h"

#include <algorithm>
#include <limits>

#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
void add_to(std::deque<Averages>& slices, const Truth& m, double length)
{
  if (slices.empty() || m.time >= slices.back().first_time() + length) slices.emplace_back();
  slices.back().add(m);
}

Averages sum_of(const std::deque<Averages>& slices)
{
  Averages sum;
  for (const Averages& slice : slices) sum.add(slice);
  return sum;
}
}  // namespace

double Averages::count() const noexcept
{
  return samples_ > 0 ? static_cast<double>(samples_) : std::numeric_limits<double>::quiet_NaN();
}

void Averages::add(const Truth& m) noexcept
{
  if (samples_ == 0) first_time_ = m.time;
  last_time_ = m.time;
  ++samples_;
  sum_.hook_load += m.hook_load;
  sum_.torque += m.torque;
  sum_.wob += m.wob;
  sum_.bit_torque += m.bit_torque;
  sum_.bit_speed += m.bit_speed;
  sum_.rop += m.rop;
  sum_.hole_depth += m.hole_depth;
  position_ += m.bit_position;
  direction_ += tangent_from(m.bit_inclination, m.bit_azimuth);
}

void Averages::add(const Averages& other) noexcept
{
  if (other.samples_ == 0) return;
  first_time_ = samples_ == 0 ? other.first_time_ : std::min(first_time_, other.first_time_);
  last_time_ = samples_ == 0 ? other.last_time_ : std::max(last_time_, other.last_time_);
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
  return inclination_of(direction_ / count());
}

double Averages::azimuth() const noexcept
{
  return azimuth_of(direction_ / count());
}

void DrillingRecord::add(const Truth& m)
{
  if (m.on_bottom) add_to(slices_, m, slice_length);
}

Averages DrillingRecord::all() const
{
  return sum_of(slices_);
}

Averages DrillingRecord::last_quarter() const
{
  Averages sum;
  const std::size_t quarter = (slices_.size() + 3) / 4;
  for (std::size_t i = slices_.size() - quarter; i < slices_.size(); ++i) sum.add(slices_[i]);
  return sum;
}

void LatestRecord::add(const Truth& m)
{
  add_to(slices_, m, slice_length);
  if (slices_.size() > most_slices) slices_.pop_front();
}

Averages LatestRecord::all() const
{
  return sum_of(slices_);
}

}  // namespace drill_rig_sim
