// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_FRAME_QUEUE_H
#define DRILL_RIG_SIM_SRC_SIM_FRAME_QUEUE_H

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>

#include "drill_rig_sim/accuracy/outputs.h"
#include "drill_rig_sim/crew/commands.h"
#include "drill_rig_sim/crew/crew.h"
#include "drill_rig_sim/crew/interlocks.h"
#include "drill_rig_sim/instruments/downlink.h"
#include "drill_rig_sim/math/semaphore.h"
#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// A frame that a simulator's companions compute as well: the set points that its crew, watchdog and interlocks have made of the
/// commands.
struct FrameOrder
{
  double duration = 0.0;  // [s]
  Setpoints setpoints;
  CommandState commands;
  Setpoints passed;  // by the dead times
  DownlinkReceiver downlink;
  InterlockState interlocks;
  CrewState crew;
  double connection_elapsed = 0.0;  // [s]
  // results, of the first companion:
  Outputs outputs{};  // NaN where it failed
  CompanionStatistics companion;
};

/// Frames for the companions, computed in their order: at once in the calling thread, or by a thread of the queue.
/// One thread calls all functions. Nothing but start_thread() allocates.
class FrameQueue
{
public:
  static constexpr std::uint64_t capacity = 256;

  /// @param compute  computes a frame, does not throw
  explicit FrameQueue(std::function<void(FrameOrder&)> compute) : compute_(std::move(compute)) {}
  ~FrameQueue() { stop_thread(); }
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;

  /// From here on frames are computed by another thread. Throws std::system_error where the system has none left.
  void start_thread();
  /// Waits for all frames, then ends the thread.
  void stop_thread() noexcept;

  /// No place for another frame before a result was taken.
  bool full() const noexcept { return posted_ - taken_ == capacity; }
  /// To be filled in before post().
  FrameOrder& next() noexcept { return orders_[posted_ % capacity]; }
  void post() noexcept;
  /// The oldest frame whose result was not taken, where it is computed; else null.
  const FrameOrder* result() const noexcept
  {
    return taken_ < done_.load(std::memory_order_acquire) ? &orders_[taken_ % capacity] : nullptr;
  }
  /// Takes that result.
  void take() noexcept;
  /// Until the oldest frame whose result was not taken is computed; at once where there is none.
  void wait_for_one() noexcept { wait_for(taken_ < posted_ ? taken_ + 1 : posted_); }
  /// Until all frames are computed.
  void wait_for_all() noexcept { wait_for(posted_); }

private:
  void wait_for(std::uint64_t frames) noexcept;
  void work() noexcept;

  std::function<void(FrameOrder&)> compute_;
  std::array<FrameOrder, capacity> orders_;  // ring
  std::uint64_t posted_ = 0, taken_ = 0;     // frames, since the start
  std::atomic<std::uint64_t> done_{0};
  Semaphore some_posted_, some_done_;
  std::atomic<bool> quit_{false};
  std::thread thread_;
};

}  // namespace drill_rig_sim

#endif
