// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/realtime/threads.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <thread>

namespace drill_rig_sim
{
namespace
{
/// 0, or errno.
int set_fifo(int priority) noexcept
{
  sched_param wanted{};
  wanted.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);
}

int set_core(int core) noexcept
{
  if (core >= CPU_SETSIZE) return EINVAL;
  cpu_set_t cores;
  CPU_ZERO(&cores);
  CPU_SET(core, &cores);
  return pthread_setaffinity_np(pthread_self(), sizeof cores, &cores);
}

std::string not_permitted(const char* setting, int error, const char* remedy)
{
  return std::string("realtime/") + setting + ": the system does not permit it (" + std::strerror(error) + "); " + remedy;
}
}  // namespace

std::string try_realtime(const RealtimeSpec& spec)
{
  int fifo = 0, core = 0;
  std::thread(
      [&]
      {
        if (spec.core >= 0) core = set_core(spec.core);
        if (spec.fifo_priority > 0) fifo = set_fifo(spec.fifo_priority);
      })
      .join();
  if (core != 0) return not_permitted("core", core, "allowed: a core that this process may run on, or -1");
  if (fifo != 0)
    return not_permitted("fifo_priority", fifo,
                         "needed: `ulimit -r` of as much (rtprio in /etc/security/limits.conf) or CAP_SYS_NICE; or 0");
  if (spec.lock_memory && mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    return not_permitted("lock_memory", errno,
                         "needed: `ulimit -l unlimited` (memlock in /etc/security/limits.conf) or CAP_IPC_LOCK; or false");
  return "";
}

int available_cores() noexcept
{
  cpu_set_t cores;
  return sched_getaffinity(0, sizeof cores, &cores) == 0 ? std::max(1, CPU_COUNT(&cores)) : 1;
}

void name_thread(const char* name) noexcept
{
  pthread_setname_np(pthread_self(), name);
}

void leave_core(int core)
{
  if (core < 0 || core >= CPU_SETSIZE) return;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task"))
  {
    const auto thread = static_cast<pid_t>(std::stol(task.path().filename()));
    cpu_set_t cores;
    if (sched_getaffinity(thread, sizeof cores, &cores) != 0) continue;  // it has ended
    CPU_CLR(core, &cores);
    sched_setaffinity(thread, sizeof cores, &cores);  // fails where no core is left: it keeps this one
  }
}

void wake_on_time() noexcept
{
  prctl(PR_SET_TIMERSLACK, 1);  // [ns]
}

bool prioritise_thread(int priority, int core) noexcept
{
  const bool on_core = core < 0 || set_core(core) == 0;
  return (priority <= 0 || set_fifo(priority) == 0) && on_core;
}

}  // namespace drill_rig_sim
