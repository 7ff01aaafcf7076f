// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REALTIME_THREADS_H
#define DRILL_RIG_SIM_REALTIME_THREADS_H

#include <string>

namespace drill_rig_sim
{
/// What the operating system is asked for, for the threads that must keep time. Off by default: it takes permission, and a
/// simulation thread of a scene that is slower than real time leaves nothing of its core to others.
struct RealtimeSpec
{
  int fifo_priority = 0;  ///< SCHED_FIFO of the simulation thread, 1 to 98; the publishing thread has one less; 0: as all threads
  bool lock_memory = false;  ///< no page of the process is ever swapped out
  int core = -1;             ///< that the simulation thread stays on, and the process's other threads keep off; -1: any

  bool any() const noexcept { return fifo_priority > 0 || lock_memory || core >= 0; }
};

/// Tries what is asked for on a thread of its own, and locks the memory, which stays locked. Empty: it was permitted; else one
/// line that says which setting is not, why, and what would help.
std::string try_realtime(const RealtimeSpec& spec);

/// Processor cores that the process may run on, 1 or more.
int available_cores() noexcept;

/// Names the calling thread (up to 15 letters), as top -H and gdb show it.
void name_thread(const char* name) noexcept;

/// Takes `core` from all threads that the process has, and so from those that they will start: the simulation thread is started
/// after it. A thread with no other core keeps it; -1: nothing.
void leave_core(int core);

/// Lets the calling thread be woken when its time has come, not up to 50 us later, as Linux does to wake several at once. FIFO
/// has no such slack.
void wake_on_time() noexcept;

/// Gives the calling thread SCHED_FIFO at `priority` (0: nothing) and keeps it on `core` (-1: nothing). False: not permitted.
bool prioritise_thread(int priority, int core) noexcept;

}  // namespace drill_rig_sim

#endif
