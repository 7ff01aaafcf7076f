// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_OWN_WORK_H
#define DRILL_RIG_SIM_SRC_RVIZ_OWN_WORK_H

#include <ctime>

namespace drill_rig_sim
{
/// What a plug-in's own code takes of a processor, rendering excluded: processor time of its thread, over wall time, of some
/// seconds.
struct OwnShare
{
  double processor = 0.0;  ///< of one core [-]
  double frames = 0.0;     ///< pictures a second
};
class OwnCost
{
public:
  void count_frame() noexcept { ++frames_; }
  void add(double seconds) noexcept { spent_ += seconds; }
  /// Whether five seconds have passed since share() was asked.
  bool due() const noexcept { return now(CLOCK_MONOTONIC) - since_ > 5.0; }
  /// Since it was asked last; 0 the first time.
  OwnShare share() noexcept
  {
    const double end = now(CLOCK_MONOTONIC), passed = end - since_;
    const OwnShare result = since_ > 0.0 ? OwnShare{spent_ / passed, frames_ / passed} : OwnShare();
    since_ = end;
    spent_ = 0.0;
    frames_ = 0;
    return result;
  }
  /// [s]
  static double now(clockid_t clock) noexcept
  {
    timespec t{};
    clock_gettime(clock, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }

private:
  double spent_ = 0.0, since_ = 0.0;
  int frames_ = 0;
};

/// Counts what its scope takes.
class OwnWork
{
public:
  explicit OwnWork(OwnCost& cost) : cost_(cost), from_(OwnCost::now(CLOCK_THREAD_CPUTIME_ID)) {}
  ~OwnWork() { cost_.add(OwnCost::now(CLOCK_THREAD_CPUTIME_ID) - from_); }
  OwnWork(const OwnWork&) = delete;
  OwnWork& operator=(const OwnWork&) = delete;

private:
  OwnCost& cost_;
  double from_;
};

}  // namespace drill_rig_sim

#endif
