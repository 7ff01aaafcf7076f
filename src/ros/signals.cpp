// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/signals.h"

#include <ros/ros.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "drill_rig_sim/math/semaphore.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::chrono::seconds grace(6);  // a loaded master takes seconds to forget some thirty names

// Leaked on purpose: the thread that waits on it lives as long as the process.
Semaphore& asked_to_end()
{
  static Semaphore* const semaphore = new Semaphore;
  return *semaphore;
}

std::atomic<int> holds{0};
std::atomic<bool> has_come{false};

// All of it is safe in a signal handler: flags are set, a semaphore posted.
void handle(int)
{
  has_come = true;
  if (holds == 0) ros::requestShutdown();
  asked_to_end().post();
}
}  // namespace

void end_on_signals()
{
  Semaphore& asked = asked_to_end();
  std::thread(
      [&asked]
      {
        asked.wait();
        std::this_thread::sleep_for(grace);
        std::_Exit(0);
      })
      .detach();
  struct sigaction action = {};
  action.sa_handler = handle;
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

SignalHold::SignalHold() noexcept
{
  ++holds;
}

void SignalHold::release() noexcept
{
  if (!holds_) return;
  holds_ = false;
  if (--holds == 0 && has_come) ros::requestShutdown();
}

}  // namespace drill_rig_sim
