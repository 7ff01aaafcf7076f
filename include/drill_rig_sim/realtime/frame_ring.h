// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REALTIME_FRAME_RING_H
#define DRILL_RIG_SIM_REALTIME_FRAME_RING_H

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "drill_rig_sim/math/semaphore.h"
#include "drill_rig_sim/realtime/frame_output.h"

namespace drill_rig_sim
{
/// Frames on their way from the simulation thread to the publishing thread, in order. A ring and not a single latest one, because
/// every frame is to be published. Deep, so that no frame is lost while the publishers wait for a processor; few of the frames
/// show arrays, so there are fewer sets of those, which keep their memory from turn to turn.
class FrameRing
{
public:
  explicit FrameRing(std::size_t size = 1024, std::size_t sets = 32)
      : slots_(size), sets_(sets), empty_(static_cast<unsigned>(size)), free_sets_(static_cast<unsigned>(sets))
  {
  }

  /// Waits until no frame has a set of arrays any more and gives each set to `prepare`. For the writer's side.
  template <class Prepare>
  void with_every_set(Prepare prepare)
  {
    for (std::size_t i = 0; i < sets_.size(); ++i) free_sets_.wait();
    for (FrameArrays& set : sets_) prepare(set);
    for (std::size_t i = 0; i < sets_.size(); ++i) free_sets_.post();
  }

  /// The writer's side: a slot to fill, then hand_over(). try_claim() returns null where all are full, claim() waits.
  FrameOutput* try_claim() noexcept { return empty_.try_wait() ? &slots_[write_] : nullptr; }
  FrameOutput* claim() noexcept
  {
    empty_.wait();
    return &slots_[write_];
  }
  /// Lends the slot just claimed a set of arrays. False where all are lent; with `wait` until one is free.
  bool lend_arrays(FrameOutput& slot, bool wait) noexcept
  {
    if (wait)
      free_sets_.wait();
    else if (!free_sets_.try_wait())
      return false;
    std::swap<FrameArrays>(slot, sets_[write_set_]);
    write_set_ = (write_set_ + 1) % sets_.size();
    slot.has_arrays = true;
    return true;
  }
  void hand_over() noexcept
  {
    write_ = (write_ + 1) % slots_.size();
    ++handed_over_;
    full_.post();
  }
  /// Frames handed over so far; on the writer's side.
  std::uint64_t handed_over() const noexcept { return handed_over_; }

  /// The reader's side: waits for the next frame; null after close() once all are read.
  FrameOutput* next() noexcept
  {
    full_.wait();
    return read_ == end_ ? nullptr : &slots_[read_];
  }
  void release() noexcept
  {
    return_arrays(slots_[read_]);
    read_ = (read_ + 1) % slots_.size();
    empty_.post();
  }

  /// The writer is done.
  void close() noexcept
  {
    claim();
    end_ = write_;
    full_.post();
  }

private:
  // Frames are released in the order they were claimed in, so the sets come back in the order they were lent in.
  void return_arrays(FrameOutput& slot) noexcept
  {
    if (!slot.has_arrays) return;
    std::swap<FrameArrays>(slot, sets_[read_set_]);
    read_set_ = (read_set_ + 1) % sets_.size();
    slot.has_arrays = false;
    free_sets_.post();
  }

  std::vector<FrameOutput> slots_;
  std::vector<FrameArrays> sets_;
  std::size_t write_ = 0, read_ = 0;
  std::size_t write_set_ = 0, read_set_ = 0;
  std::uint64_t handed_over_ = 0;
  std::atomic<std::size_t> end_{SIZE_MAX};
  Semaphore empty_, full_, free_sets_;
};

}  // namespace drill_rig_sim

#endif
