// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/realtime/timekeeper.h"

namespace drill_rig_sim
{
Timekeeper::Timekeeper(TimeSource source, ClockMode mode, std::int64_t period, std::int64_t wall_start) noexcept
    : source_(source),
      mode_(mode),
      period_(period),
      speed_(mode == ClockMode::free_run ? 0.0 : 1.0),
      stamp_(source == TimeSource::wall ? wall_start : 0)
{
}

void Timekeeper::set_speed(double speed, std::int64_t now) noexcept
{
  speed_ = speed;
  restart(now);
}

std::int64_t Timekeeper::next_frame_at() const noexcept
{
  if (follows()) return heard_ >= stamp_ + period_ ? 0 : not_yet;
  return is_realtime() ? deadline_ : 0;
}

std::int64_t Timekeeper::frame_begins(std::int64_t now) noexcept
{
  if (!is_realtime()) return 0;
  const std::int64_t late = now - deadline_;
  if (late > wall_period() / 10) ++overruns_;
  if (late > most_backlog)
  {
    dropped_ += late - most_backlog;
    deadline_ += late - most_backlog;
  }
  deadline_ += wall_period();
  return late;
}

bool Timekeeper::adopt_clock() noexcept
{
  if (!follows() || heard_ == 0) return false;
  const std::int64_t ahead = heard_ - stamp_;
  const bool too_slow = ahead > longest_jump && followed_;
  if (too_slow) dropped_ += ahead - period_;
  const bool back = ahead < -most_ahead;
  if (ahead > longest_jump || back) stamp_ = heard_ - period_;
  followed_ = true;
  return back;
}

}  // namespace drill_rig_sim
