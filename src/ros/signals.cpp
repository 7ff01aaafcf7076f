// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/signals.h"

#include <ros/ros.h>
#include <signal.h>

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

// Both calls are safe in a signal handler: a flag is set, a semaphore posted.
void handle(int)
{
  ros::requestShutdown();
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

}  // namespace drill_rig_sim
