// SPDX-License-Identifier: BSD-3-Clause
// The semaphore: counts, wakes another thread, and gives up at an absolute deadline of the steady clock.
#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "drill_rig_sim/math/semaphore.h"

namespace drill_rig_sim::test_math_semaphore
{
TEST(Semaphore, countsItsPosts)
{
  Semaphore s(2);
  EXPECT_TRUE(s.try_wait());
  EXPECT_TRUE(s.try_wait());
  EXPECT_FALSE(s.try_wait());
  s.post();
  EXPECT_TRUE(s.try_wait());
  EXPECT_FALSE(s.try_wait());
}

TEST(Semaphore, itsClockIsTheSteadyOne)
{
  const auto steady = [] { return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count(); };
  const std::int64_t before = steady(), now = steady_now(), after = steady();
  EXPECT_LE(before, now);
  EXPECT_LE(now, after);
}

TEST(Semaphore, waitUntilGivesUpAtItsDeadlineAndNotBefore)
{
  Semaphore s;
  const std::int64_t deadline = steady_now() + 30'000'000;
  EXPECT_FALSE(s.wait_until(deadline));
  EXPECT_GE(steady_now(), deadline);
  EXPECT_FALSE(s.wait_until(steady_now() - 1'000'000'000)) << "a deadline that has passed does not wait";
}

TEST(Semaphore, waitUntilTakesAPostBeforeItsDeadline)
{
  Semaphore s(1);
  EXPECT_TRUE(s.wait_until(steady_now() + 3'600'000'000'000));
  EXPECT_FALSE(s.try_wait()) << "the post is used up";
}

TEST(Semaphore, wakesAnotherThread)
{
  Semaphore asked, answered;
  int value = 0;
  std::thread other(
      [&]
      {
        asked.wait();
        ++value;
        answered.post();
      });
  value = 41;
  asked.post();
  answered.wait();
  EXPECT_EQ(42, value);
  other.join();
}

// A signal whose handler does not ask for it ends no wait: only a post does, or the deadline.
TEST(Semaphore, signalsDoNotWake)
{
  struct sigaction quiet = {}, before = {};
  quiet.sa_handler = [](int) {};
  ASSERT_EQ(0, sigaction(SIGUSR1, &quiet, &before));
  Semaphore s, ready;
  std::atomic<int> woken{0};
  std::thread other(
      [&]
      {
        ready.post();
        s.wait();
        ++woken;
        ready.post();
        EXPECT_TRUE(s.wait_until(steady_now() + 60'000'000'000));
        ++woken;
      });
  const auto disturb = [&]
  {
    for (int k = 0; k < 20; ++k)
    {
      pthread_kill(other.native_handle(), SIGUSR1);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  };
  for (int wait = 0; wait < 2; ++wait)
  {
    ready.wait();
    disturb();
    EXPECT_EQ(wait, woken.load());
    s.post();
  }
  other.join();
  EXPECT_EQ(2, woken.load());
  sigaction(SIGUSR1, &before, nullptr);
}

}  // namespace drill_rig_sim::test_math_semaphore
