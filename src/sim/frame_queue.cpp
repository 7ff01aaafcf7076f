// SPDX-License-Identifier: BSD-3-Clause
#include "frame_queue.h"

#include <pthread.h>

namespace drill_rig_sim
{
void FrameQueue::start_thread()
{
  if (thread_.joinable()) return;
  quit_ = false;
  thread_ = std::thread([this] { work(); });
  pthread_setname_np(thread_.native_handle(), "companion");
}

void FrameQueue::stop_thread() noexcept
{
  if (!thread_.joinable()) return;
  wait_for_all();
  quit_ = true;
  some_posted_.post();
  thread_.join();
}

void FrameQueue::post() noexcept
{
  ++posted_;
  if (thread_.joinable())
  {
    some_posted_.post();
    return;
  }
  compute_(orders_[(posted_ - 1) % capacity]);
  done_.store(posted_, std::memory_order_release);
}

void FrameQueue::take() noexcept
{
  ++taken_;
  some_done_.try_wait();  // so that posts without a waiter do not add up
}

void FrameQueue::wait_for(std::uint64_t frames) noexcept
{
  while (done_.load(std::memory_order_acquire) < frames) some_done_.wait();
}

void FrameQueue::work() noexcept
{
  for (;;)
  {
    some_posted_.wait();
    if (quit_) return;
    const std::uint64_t frame = done_.load(std::memory_order_relaxed);
    compute_(orders_[frame % capacity]);
    done_.store(frame + 1, std::memory_order_release);
    some_done_.post();
  }
}

}  // namespace drill_rig_sim
