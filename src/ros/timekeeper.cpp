#include "drill_rig_sim/ros/timekeeper.h"

#include <ros/time.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/ros/semaphore.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::int64_t longest_jump = 10'000'000'000;  // of another rig's clock that is followed frame by frame [ns]
}

Timekeeper::Timekeeper(const Parameters& parameters)
    : source_(parameters.publish_clock  ? Source::own
              : parameters.use_sim_time ? Source::other_rig
                                        : Source::wall),
      mode_(parameters.clock),
      period_(parameters.frame_period()),
      speed_(parameters.clock == ClockMode::free_run ? 0.0 : 1.0)
{
  if (source_ == Source::wall) stamp_ = static_cast<std::int64_t>(ros::WallTime::now().toNSec());
}

void Timekeeper::set_speed(double speed) noexcept
{
  speed_ = speed;
  restart(steady_now());
}

std::int64_t Timekeeper::next_frame_at() const noexcept
{
  if (follows()) return heard_ >= stamp_ + period_ ? 0 : not_yet;
  return is_realtime() ? deadline_ : 0;
}

void Timekeeper::frame_begins(std::int64_t now) noexcept
{
  if (!is_realtime()) return;
  const std::int64_t late = now - deadline_;
  const auto wall_period = static_cast<std::int64_t>(static_cast<double>(period_) / speed_);
  if (late > wall_period / 10) ++overruns_;
  if (late > most_backlog)
  {
    dropped_ += late - most_backlog;
    deadline_ += late - most_backlog;
  }
  deadline_ += wall_period;
}

void Timekeeper::restart(std::int64_t now) noexcept
{
  deadline_ = now;
}

void Timekeeper::adopt_clock() noexcept
{
  if (!follows()) return;
  const std::int64_t ahead = heard_ - stamp_;
  if (ahead > longest_jump || ahead < -longest_jump) stamp_ = heard_ - period_;
}

bool Cadence::due(std::int64_t now) noexcept
{
  if (next_ == never) next_ = now;
  if (now + 1000 < next_) return false;
  next_ = std::max(next_ + period_, now - period_);  // after a gap: no burst
  return true;
}

}  // namespace drill_rig_sim
