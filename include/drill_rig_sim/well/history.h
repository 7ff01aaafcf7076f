// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_HISTORY_H
#define DRILL_RIG_SIM_WELL_HISTORY_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace drill_rig_sim
{
/// A sequence that only grows, kept in memory reserved once; of more than `capacity` entries the last ones stay (a ring).
/// Each entry carries a hash of everything pushed up to it, so that two copies of a history know how far they agree:
/// assignment copies only what differs. Bringing a copy up to date, or going back to a snapshot, costs what was pushed in
/// between and not the length of the history, and it does not allocate.
template <class T>
class History
{
public:
  /// `capacity` is a power of two.
  explicit History(std::size_t capacity) : capacity_(capacity) { slots_.reserve(capacity); }

  History(const History& other) : capacity_(other.capacity_), count_(other.count_)
  {
    slots_.reserve(capacity_);
    slots_.insert(slots_.end(), other.slots_.begin(), other.slots_.end());
  }

  /// Does not allocate if both have the same capacity.
  History& operator=(const History& other)
  {
    if (this == &other) return *this;
    if (capacity_ != other.capacity_) return *this = std::move(History(other));
    const std::size_t agreed = agreement(other);
    if (agreed == 0)
    {
      slots_ = other.slots_;
    }
    else
    {
      copy(other, other.first(), std::min(first(), other.count_));  // still held there, overwritten here since
      copy(other, std::max(agreed, other.first()), other.count_);
    }
    count_ = other.count_;
    return *this;
  }

  History(History&&) noexcept = default;
  History& operator=(History&&) noexcept = default;
  ~History() = default;

  std::size_t capacity() const noexcept { return capacity_; }
  /// Entries ever pushed.
  std::size_t count() const noexcept { return count_; }
  /// Index of the oldest entry still held; entries first() .. count() - 1 can be read.
  std::size_t first() const noexcept { return count_ > capacity_ ? count_ - capacity_ : 0; }
  const T& operator[](std::size_t i) const noexcept { return slots_[i & (capacity_ - 1)].value; }
  const T& back() const noexcept { return (*this)[count_ - 1]; }
  /// Hash of the whole sequence.
  std::uint64_t hash() const noexcept { return count_ == 0 ? 0 : hash_at(count_ - 1); }

  /// Appends. `a`, `b`, `c` identify the entry; the hash is built from them.
  void push(const T& value, double a, double b, double c) noexcept
  {
    store(count_, {value, mixed(mixed(mixed(hash() + 0x9e3779b97f4a7c15ull, a), b), c)});
    ++count_;
  }

  /// The entries still held (the capacity is no part of the value).
  template <class V>
  void visit(V& v)
  {
    v("count", count_);
    // slots beyond these hold a future that was taken back
    const std::size_t held = std::min(count_, capacity_);
    if (slots_.size() < held) slots_.resize(held);  // v is a reader
    v.list("slots", slots_.data(), held);
  }

private:
  struct Slot
  {
    T value;
    std::uint64_t hash;

    template <class V>
    void visit(V& v)
    {
      v("value", value);
      v("hash", hash);
    }
  };

  // One round of the splitmix64 finaliser per number.
  static std::uint64_t mixed(std::uint64_t hash, double number) noexcept
  {
    std::uint64_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    hash ^= bits;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ull;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebull;
    return hash ^ (hash >> 31);
  }

  std::uint64_t hash_at(std::size_t i) const noexcept { return slots_[i & (capacity_ - 1)].hash; }

  // Slots fill in order, so the vector grows by one at a time within its reserve.
  void store(std::size_t i, const Slot& slot) noexcept
  {
    const std::size_t place = i & (capacity_ - 1);
    if (place < slots_.size())
      slots_[place] = slot;
    else
      slots_.push_back(slot);
  }

  void copy(const History& other, std::size_t from, std::size_t to) noexcept
  {
    for (std::size_t i = from; i < to; ++i) store(i, other.slots_[i & (capacity_ - 1)]);
  }

  // The number of entries from the start that are surely the same: all of the shorter one, or none.
  std::size_t agreement(const History& other) const noexcept
  {
    const std::size_t common = std::min(count_, other.count_);
    if (common == 0 || common - 1 < first() || common - 1 < other.first()) return 0;
    return hash_at(common - 1) == other.hash_at(common - 1) ? common : 0;
  }

  std::size_t capacity_;
  std::size_t count_ = 0;
  std::vector<Slot> slots_;
};

}  // namespace drill_rig_sim

#endif
