// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REALTIME_TRIPLE_BUFFER_H
#define DRILL_RIG_SIM_REALTIME_TRIPLE_BUFFER_H

#include <array>
#include <atomic>

namespace drill_rig_sim
{
/// Hands values from one thread to another, the latest wins; neither ever waits. One writer, one reader.
/// Of three slots one belongs to the writer, one to the reader, and the third is swapped between them.
template <class T>
class TripleBuffer
{
public:
  /// The writer's side.
  void write(const T& value) noexcept
  {
    slots_[writer_] = value;
    writer_ = middle_.exchange(writer_ | fresh, std::memory_order_acq_rel) & index;
  }

  /// The reader's side: the latest value not read yet, or null. Valid until the next call.
  const T* read() noexcept
  {
    if (!(middle_.load(std::memory_order_relaxed) & fresh)) return nullptr;
    reader_ = middle_.exchange(reader_, std::memory_order_acq_rel) & index;
    return &slots_[reader_];
  }

private:
  static constexpr unsigned index = 3, fresh = 4;
  std::array<T, 3> slots_{};
  unsigned writer_ = 0, reader_ = 1;
  std::atomic<unsigned> middle_{2};
};

}  // namespace drill_rig_sim

#endif
