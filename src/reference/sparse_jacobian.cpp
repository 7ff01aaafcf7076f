// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/reference/sparse_jacobian.h"

#include <algorithm>
#include <numeric>

namespace drill_rig_sim
{
bool SparseJacobian::finish()
{
  const bool changed = entries_ != known_entries_;
  if (changed)
  {
    known_entries_ = entries_;
    std::vector<std::size_t> order(entries_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) { return entries_[a] < entries_[b]; });
    slots_.resize(entries_.size());
    rows_.clear();
    starts_.assign(static_cast<std::size_t>(size_) + 1, 0);
    std::uint64_t last = ~std::uint64_t{0};
    for (const std::size_t k : order)
    {
      if (entries_[k] != last)
      {
        last = entries_[k];
        rows_.push_back(static_cast<std::int64_t>(last & 0xffffffffU));
        ++starts_[static_cast<std::size_t>(last >> 32) + 1];
      }
      slots_[k] = rows_.size() - 1;
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  }
  values_.assign(rows_.size(), 0.0);
  for (std::size_t k = 0; k < slots_.size(); ++k) values_[slots_[k]] += values_in_[k];
  return changed;
}

void SparseJacobian::multiply(const double* x, double* y) const
{
  std::fill(y, y + size_, 0.0);
  for (std::size_t j = 0; j < static_cast<std::size_t>(size_); ++j)
    for (std::int64_t k = starts_[j]; k < starts_[j + 1]; ++k)
      y[rows_[static_cast<std::size_t>(k)]] += values_[static_cast<std::size_t>(k)] * x[j];
}

}  // namespace drill_rig_sim
