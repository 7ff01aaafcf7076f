// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_SEMAPHORE_H
#define DRILL_RIG_SIM_MATH_SEMAPHORE_H

#include <semaphore.h>
#include <time.h>

#include <cerrno>
#include <cstdint>

namespace drill_rig_sim
{
/// Nanoseconds of the steady clock.
inline std::int64_t steady_now() noexcept
{
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return std::int64_t{1000000000} * t.tv_sec + t.tv_nsec;
}

/// A counting semaphore: post() never blocks, so the simulation thread may use it to wake others.
class Semaphore
{
public:
  explicit Semaphore(unsigned count = 0) noexcept { sem_init(&handle_, 0, count); }
  ~Semaphore() { sem_destroy(&handle_); }
  Semaphore(const Semaphore&) = delete;
  Semaphore& operator=(const Semaphore&) = delete;

  void post() noexcept { sem_post(&handle_); }
  /// True and one post less where there was one; never waits.
  bool try_wait() noexcept { return sem_trywait(&handle_) == 0; }
  void wait() noexcept
  {
    while (sem_wait(&handle_) != 0 && errno == EINTR)
    {
    }
  }
  /// Waits until posted or until the steady clock reaches `deadline` [ns]. False at the deadline.
  bool wait_until(std::int64_t deadline) noexcept
  {
    timespec t;
    t.tv_sec = static_cast<time_t>(deadline / 1000000000);
    t.tv_nsec = static_cast<long>(deadline % 1000000000);
    int result;
    do result = sem_clockwait(&handle_, CLOCK_MONOTONIC, &t);
    while (result != 0 && errno == EINTR);
    return result == 0;
  }

private:
  sem_t handle_;
};

}  // namespace drill_rig_sim

#endif
