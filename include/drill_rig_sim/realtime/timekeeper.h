// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REALTIME_TIMEKEEPER_H
#define DRILL_RIG_SIM_REALTIME_TIMEKEEPER_H

#include <atomic>
#include <cstdint>

namespace drill_rig_sim
{
enum class ClockMode
{
  realtime,
  lockstep,
  free_run
};

/// Whose time the stamps are.
enum class TimeSource
{
  own,        ///< the rig's own, from 0; it publishes the clock
  other_rig,  ///< the clock that another rig publishes
  wall        ///< the wall's time at the start, and on from there
};

/// Sole owner of time: when the next frame may begin, and what stamp it gets.
///
/// Stamps are start + ticks * period, in whole nanoseconds; they only grow, through resets too, so tf2 listeners live on. The
/// start is 0 with an own clock (so the first stamp is one period, never 0) or another rig's, and the wall's time otherwise.
///
/// In real time, frame n is due at an absolute deadline of the steady clock. A late frame starts at once and its deadline stays,
/// so the delay is caught up, as long as it is below 0.1 s; what is beyond is dropped and counted: simulated time then falls
/// behind.
///
/// Everything but hear_clock() belongs to the simulation thread, or to a between-frames callback between its frames.
class Timekeeper
{
public:
  static constexpr std::int64_t not_yet = INT64_MAX;            ///< no frame before the thread is woken
  static constexpr std::int64_t most_backlog = 100'000'000;     ///< [ns]
  static constexpr std::int64_t longest_jump = 10'000'000'000;  ///< of another rig's clock that is followed frame by frame [ns]
  static constexpr std::int64_t most_ahead = 1'000'000'000;     ///< of another rig's clock, which is then waited for [ns]

  /// `period`: of a frame, simulated [ns], > 0. `wall_start`: the wall's time now [ns], for stamps of the wall.
  Timekeeper(TimeSource source, ClockMode mode, std::int64_t period, std::int64_t wall_start) noexcept;

  /// True where the rig follows the clock of another one.
  bool follows() const noexcept { return source_ == TimeSource::other_rig; }
  bool has_own_clock() const noexcept { return source_ == TimeSource::own; }
  bool in_lockstep() const noexcept { return mode_ == ClockMode::lockstep; }
  bool is_realtime() const noexcept { return mode_ != ClockMode::lockstep && !follows() && speed_ > 0.0; }

  /// Simulated seconds per wall second; 0 = as fast as possible.
  double speed() const noexcept { return speed_; }
  /// `now`: steady time [ns], at which the next frame is due.
  void set_speed(double speed, std::int64_t now) noexcept;

  /// Steady time [ns] at which the next frame is due: 0 = now, not_yet = wait to be woken.
  std::int64_t next_frame_at() const noexcept;
  /// Accounts for the frame that begins at steady time `now`; returns how far behind its time that is [wall ns], 0 where it has
  /// none.
  std::int64_t frame_begins(std::int64_t now) noexcept;
  /// Time there is for a frame [wall ns]; that of a frame as simulated where it has none.
  std::int64_t wall_period() const noexcept
  {
    return is_realtime() ? static_cast<std::int64_t>(static_cast<double>(period_) / speed_) : period_;
  }
  /// The next frame is due now: after a pause, or at the start.
  void restart(std::int64_t now) noexcept { deadline_ = now; }
  /// Where another rig's clock is more than longest_jump ahead (the first one received, or one that runs faster than this rig
  /// can) or more than most_ahead behind (a rig that began again; resets of this one put it ahead by a frame each): goes there at
  /// once. What a rig that had followed leaves out counts as dropped. Returns whether the stamp went back.
  bool adopt_clock() noexcept;
  /// Moves the stamp on by one frame.
  void tick() noexcept
  {
    stamp_ += period_;
    ++ticks_;
  }
  std::int64_t stamp() const noexcept { return stamp_; }  ///< [ns]
  /// Simulated time that has passed, frame by frame: without the jumps to another rig's clock [s].
  double ticked_seconds() const noexcept { return 1e-9 * static_cast<double>(period_) * static_cast<double>(ticks_); }

  /// From any one thread: another rig's clock [ns].
  void hear_clock(std::int64_t clock) noexcept { heard_ = clock; }

  std::uint64_t overruns() const noexcept { return overruns_; }  ///< frames begun more than a tenth of a period late
  double dropped_seconds() const noexcept
  {
    return 1e-9 * static_cast<double>(dropped_);
  }  ///< backlog dropped [wall s; of the followed clock s]

private:
  TimeSource source_;
  ClockMode mode_;
  std::int64_t period_;
  double speed_;
  std::int64_t stamp_;
  std::uint64_t ticks_ = 0;
  std::int64_t deadline_ = 0;
  std::uint64_t overruns_ = 0;
  std::int64_t dropped_ = 0;
  bool followed_ = false;  // a clock has been received
  std::atomic<std::int64_t> heard_{0};
};

}  // namespace drill_rig_sim

#endif
