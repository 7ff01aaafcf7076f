// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/bottom_approach.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/crew/operations.h"

namespace drill_rig_sim
{
namespace
{
constexpr double at_bottom = 0.002;  // a bit that is less above bottom by the readings is there [m]
}  // namespace

void BottomApproach::begin(const Readings& now, const HookedString& string, double weight, double speed, bool zeroes,
                           bool heaves) noexcept
{
  *this = BottomApproach();
  begun = true;
  zeroes_ = zeroes;
  wanted_ = weight;
  most_ = speed;
  slow_ = std::min({speed, fastest, weight / (string.stiffness * WeightFeed::feed_time)});
  gentle_ = inertia * weight / string.mass;
  bottom_ = now.hole_depth;
  room_ = std::max(0.5 * slow_ * slow_time, 2.0 * SteadyLoad::turns_round);
  over_ = !zeroes && bottom_ - now.bit_depth < at_bottom;
  begin_to_lower(now);
  settled_ = heaves;
  lifts_left_ = zeroes && !heaves ? most_lifts : 0;
  if (lifts_left_ > 0 && bottom_ - now.bit_depth < room_) lift(now);
}

void BottomApproach::begin_to_lower(const Readings& now) noexcept
{
  lifts_ = settled_ = false;
  load_.begin(now.hook_load, now.block_height);
  speed_ = mean_weight_ = 0.0;
}

void BottomApproach::lift(const Readings& now) noexcept
{
  lifts_ = true;
  --lifts_left_;
  lift_to_ = now.block_height + room_ - (bottom_ - now.bit_depth);
  room_ *= 2.0;  // of the next time
}

bool BottomApproach::goes_on(const Readings& now, double duration) noexcept
{
  if (over_) return false;
  if (lifts_) return true;
  if (now.bit_depth > bottom_ + slow_ * beyond_time) over_ = true;
  load_.take(now.hook_load, now.block_height, duration, steady * wanted_);
  settled_ = settled_ || load_.is_steady();
  const double weight = now.mean_surface_wob;
  mean_weight_ += std::min(1.0, duration / felt_time) * ((settled_ ? weight : 0.0) - mean_weight_);
  const bool is_felt = mean_weight_ >= felt * wanted_ || (weight >= 0.5 * wanted_ && (settled_ || (zeroes_ && is_near(now))));
  if (!over_ && !is_felt) return true;
  speed_ = 0.0;
  return false;
}

/// Whether the bit has come to the slow part.
bool BottomApproach::is_near(const Readings& now) const noexcept
{
  return bottom_ - now.bit_depth <= slow_ * slow_time;
}

double BottomApproach::velocity(const Readings& now, double duration) noexcept
{
  if (!lifts_ && !settled_ && now.bit_depth >= bottom_)
  {
    if (lifts_left_ > 0)
      lift(now);
    else
      settled_ = true;  // bottom is near by the depth
  }
  if (lifts_ && now.block_height < lift_to_ && !now.stop_reached) return std::min(most_, fastest);
  if (lifts_) begin_to_lower(now);
  const double left = std::max(0.0, bottom_ - now.bit_depth - slow_ * slow_time);
  const double allowed = std::min(most_, std::sqrt(slow_ * slow_ + 2.0 * gentle_ * left));
  speed_ = std::min(allowed, speed_ + gentle_ * duration);
  return -speed_;
}

}  // namespace drill_rig_sim
