#ifndef DRILL_RIG_SIM_ROS_TIMEKEEPER_H
#define DRILL_RIG_SIM_ROS_TIMEKEEPER_H

#include <atomic>
#include <cstdint>

#include "drill_rig_sim/ros/parameters.h"

namespace drill_rig_sim
{
/// Sole owner of time: when the next frame may begin, and what stamp it gets.
///
/// Stamps are start + ticks * period, in whole nanoseconds; they only grow, through resets too, so tf2 listeners live on. The
/// start is 0 where the node publishes /clock (so the first stamp is one period, never 0) or follows another rig's clock, and the
/// wall's time otherwise.
///
/// In real time, frame n is due at an absolute deadline of the steady clock. A late frame starts at once and its deadline stays,
/// so the delay is caught up, as long as it is below 0.1 s; what is beyond is dropped and counted: simulated time then falls
/// behind.
///
/// Everything but hear_clock() belongs to the simulation thread, or to a between-frames callback between its frames.
class Timekeeper
{
public:
  static constexpr std::int64_t not_yet = INT64_MAX;       ///< no frame before somebody wakes the thread
  static constexpr std::int64_t most_backlog = 100000000;  ///< [ns]

  explicit Timekeeper(const Parameters& parameters);

  /// True where the node follows the clock of another rig.
  bool follows() const noexcept { return source_ == Source::other_rig; }
  bool has_own_clock() const noexcept { return source_ == Source::own; }
  bool in_lockstep() const noexcept { return mode_ == ClockMode::lockstep; }
  bool is_realtime() const noexcept { return mode_ != ClockMode::lockstep && !follows() && speed_ > 0.0; }

  /// Simulated seconds per wall second; 0 = as fast as it goes.
  double speed() const noexcept { return speed_; }
  void set_speed(double speed) noexcept;

  /// Steady time [ns] at which the next frame is due: 0 = now, not_yet = wait to be woken.
  std::int64_t next_frame_at() const noexcept;
  /// Accounts for the frame that begins at steady time `now`.
  void frame_begins(std::int64_t now) noexcept;
  /// The next frame is due now: after a pause, or at the start.
  void restart(std::int64_t now) noexcept;
  /// Where another rig's clock is more than 10 s away (the first one heard, or a master that began again): goes there at once.
  void adopt_clock() noexcept;
  /// Moves the stamp on by one frame.
  void tick() noexcept { stamp_ += period_; }
  std::int64_t stamp() const noexcept { return stamp_; }  ///< [ns]

  /// From any one thread: another rig's clock [ns].
  void hear_clock(std::int64_t clock) noexcept { heard_ = clock; }

  std::uint64_t overruns() const noexcept { return overruns_; }        ///< frames begun more than a tenth of a period late
  double dropped_seconds() const noexcept { return dropped_ * 1e-9; }  ///< backlog dropped [wall s]

private:
  enum class Source
  {
    own,
    other_rig,
    wall
  };

  Source source_;
  ClockMode mode_;
  std::int64_t period_;
  double speed_;
  std::int64_t stamp_ = 0;
  std::int64_t deadline_ = 0;
  std::uint64_t overruns_ = 0;
  std::int64_t dropped_ = 0;
  std::atomic<std::int64_t> heard_{0};
};

/// Says when something at a fixed rate is due.
class Cadence
{
public:
  explicit Cadence(double rate) noexcept : period_(static_cast<std::int64_t>(1e9 / rate)) {}
  /// True once per period of the clock that `now` [ns] comes from; never early by more than a microsecond, no drift.
  bool due(std::int64_t now) noexcept;
  /// The next time asked is due.
  void restart() noexcept { next_ = never; }

private:
  std::int64_t period_;
  static constexpr std::int64_t never = INT64_MIN;
  std::int64_t next_ = never;
};

}  // namespace drill_rig_sim

#endif
