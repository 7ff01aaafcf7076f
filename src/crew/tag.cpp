// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/tag.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
void Tag::begin(const Readings& now, const TagTask& task) noexcept
{
  *this = Tag();
  task_ = task;
  mean_.set_period(task.mean_time);
  lifts_left_ = most_lifts;
  room_ = std::max(least_room, SteadyLoad::turns_round + (task.mean_time + steady_time) * task.speed);
  followed_at_ = now.time;
  lower(now);
  if (task.may_lift && now.hole_depth - now.bit_depth < room_) lift(now);
}

void Tag::lift(const Readings& now) noexcept
{
  phase_ = Phase::lifts;
  lift_to_ = now.block_height + room_ - (now.hole_depth - now.bit_depth);
}

void Tag::lower(const Readings& now) noexcept
{
  phase_ = Phase::lowers;
  lowers_since_ = now.time;
  has_zero_ = renews_ = false;
  load_.begin(now.hook_load, now.block_height);
}

double Tag::velocity(const Readings& now, bool refused, double rise, bool waits) noexcept
{
  if (phase_ == Phase::lifts && (now.block_height + rise >= lift_to_ || now.stop_reached)) phase_ = Phase::hangs;
  if (phase_ == Phase::hangs && !waits) lower(now);
  if (phase_ == Phase::lowers) follow_load(now, refused, waits);
  followed_at_ = now.time;
  return phase_ == Phase::hangs ? 0.0 : phase_ == Phase::lifts ? task_.speed : -task_.speed;
}

void Tag::follow_load(const Readings& now, bool refused, bool waits) noexcept
{
  mean_.take(now.hook_load, now.time);
  const double load = mean_.mean(), within = std::max(steady * task_.weight, resolution * std::abs(load));
  load_.take(load, now.block_height, now.time - followed_at_, within);
  if (!load_.has_turned())
  {
    turned_at_ = now.time;
    mean_.restart();
  }
  if (now.time < turned_at_ + task_.mean_time) load_.restart(load);  // the mean is not over whole periods yet
  const bool has_settled = now.time >= lowers_since_ + task_.settles - time_rounding;
  renews_ = task_.may_lift && load_.is_steady();
  has_zero_ = has_zero_ || (!waits && has_settled && (renews_ || !task_.may_lift));
  if (now.bit_depth < now.hole_depth && !(refused && has_settled)) return;
  phase_ = Phase::weighs;
  if (has_zero_ || !task_.may_lift || (!waits && lifts_left_ == 0)) return;
  if (!waits)
  {
    --lifts_left_;
    room_ *= 2.0;
  }
  lift(now);
}

}  // namespace drill_rig_sim
