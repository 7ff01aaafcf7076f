#ifndef DRILL_RIG_SIM_REALTIME_FRAME_RING_H
#define DRILL_RIG_SIM_REALTIME_FRAME_RING_H

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "drill_rig_sim/realtime/semaphore.h"
#include "drill_rig_sim/realtime/frame_output.h"

namespace drill_rig_sim
{
/// Frames on their way from the simulation thread to the publishing thread, in order. A ring and not a single latest
/// one, because every frame is to be published. The slots' arrays keep their memory from turn to turn.
class FrameRing
{
public:
  explicit FrameRing(std::size_t size = 64) : slots_(size), empty_(static_cast<unsigned>(size)) {}

  /// Waits until all are empty and gives each to `prepare`. For the writer's side.
  template <class Prepare>
  void with_every_slot(Prepare prepare)
  {
    for (std::size_t i = 0; i < slots_.size(); ++i) empty_.wait();
    for (FrameOutput& slot : slots_) prepare(slot);
    for (std::size_t i = 0; i < slots_.size(); ++i) empty_.post();
  }

  /// The writer's side: a slot to fill, then hand_over(). try_claim() returns null where all are full, claim() waits.
  FrameOutput* try_claim() noexcept { return empty_.try_wait() ? &slots_[write_] : nullptr; }
  FrameOutput* claim() noexcept
  {
    empty_.wait();
    return &slots_[write_];
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
  std::vector<FrameOutput> slots_;
  std::size_t write_ = 0, read_ = 0;
  std::uint64_t handed_over_ = 0;
  std::atomic<std::size_t> end_{SIZE_MAX};
  Semaphore empty_, full_;
};

}  // namespace drill_rig_sim

#endif
