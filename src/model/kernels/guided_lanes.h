// SPDX-License-Identifier: BSD-3-Clause
// Batches of guided nodes. Included inside the namespace of a source of batch kernels, behind math/lanes.h, once for each set of
// instructions; no include guard, therefore.

/// A batch: nodes or elements from `i` on, `count` of them.
struct Rest
{
  int i, count;
};

/// One in which all lanes are used: the compiler knows where all its rows are.
struct Whole
{
  int i;
  static constexpr int count = kLanes;
};

/// Calls visit(batch) for those of a run.
template <class Visit>
HWY_INLINE void each_batch(Runs::Run run, const Visit& visit)
{
  int i = run.first;
  for (; i + kLanes <= run.last; i += kLanes) visit(Whole{i});
  if (i < run.last) visit(Rest{i, run.last - i});
}

/// Rows of a vector's elements.
template <class T, class Batch, class Get>
HWY_INLINE ConstRows rows_of(const std::vector<T>& from, Batch b, Get get)
{
  return rows_of(from.data() + b.i, b.count, get);
}

template <class T, class Batch, class Get>
HWY_INLINE Rows rows_to(std::vector<T>& to, Batch b, double* spare, Get get)
{
  return rows_to(to.data() + b.i, b.count, spare, get);
}

/// Into `count` numbers from the i-th on.
HWY_INLINE void put_down(V v, std::vector<double>& to, int i, int count)
{
  if (count == kLanes) return hn::StoreU(v, Tag(), to.data() + i);
  HWY_ALIGN double numbers[kLanes];
  hn::Store(v, Tag(), numbers);
  for (int k = 0; k < count; ++k) to[static_cast<std::size_t>(i + k)] = numbers[k];
}
