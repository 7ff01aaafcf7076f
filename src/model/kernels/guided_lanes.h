// What the batch kernels of guided nodes have in common: batches, and rows of what they work on. Included inside the namespace of such a source, behind
// math/lanes.h, once for each set of instructions; no include guard, therefore.

/// A batch: nodes or elements from `i` on, `count` of them.
struct Rest
{
  int i, count;
  Rest next() const { return {i + 1, count}; }
};

/// One without lanes that nobody asks for: the compiler knows where all its rows are.
struct Whole
{
  int i;
  static constexpr int count = kLanes;
  Whole next() const { return {i + 1}; }
};

/// Calls visit(batch) for those of a run.
template <class Visit>
HWY_INLINE void each_batch(Runs::Run run, const Visit& visit)
{
  int i = run.first;
  for (; i + kLanes <= run.last; i += kLanes) visit(Whole{i});
  if (i < run.last) visit(Rest{i, run.last - i});
}

/// Rows that begin with this member of a vector's elements.
template <class Element, class Batch>
HWY_INLINE Rows rows_of(const std::vector<Element>& from, const double& member_of_first, Batch b)
{
  const char* first = reinterpret_cast<const char*>(&member_of_first) + b.i * static_cast<std::ptrdiff_t>(sizeof(Element));
  return rows(reinterpret_cast<const double*>(first), sizeof(Element), b.count);
}

template <class Element, class Batch>
HWY_INLINE Rows rows_to(std::vector<Element>& to, double& member_of_first, Batch b, double* spare)
{
  char* first = reinterpret_cast<char*>(&member_of_first) + b.i * static_cast<std::ptrdiff_t>(sizeof(Element));
  return rows(reinterpret_cast<double*>(first), sizeof(Element), b.count, spare);
}

template <class Batch>
HWY_INLINE Rows rows_to(double* first, int numbers, Batch b, double* spare)
{
  return rows(first + numbers * b.i, numbers * static_cast<std::ptrdiff_t>(sizeof(double)), b.count, spare);
}

template <class Batch>
HWY_INLINE Rows guides_of(const Stage& stage, Batch b)
{
  return rows_of(stage.guides, stage.guides[0].tangent.x(), b);
}

/// Where a guide's numbers are, counted from its tangent.
constexpr int above_at = 3, weight_at = 9, mass_at = 12, friction_at = 16, law_at = 23, turn_at = 29;
static_assert(sizeof(ContactLaw) == 3 * sizeof(double) && sizeof(Guide) == 36 * sizeof(double), "a guide's numbers");

HWY_INLINE V3 tangent_of(const Rows& guide)
{
  const V4 t = load4(guide, 0);
  return {t.a, t.b, t.c};
}

/// Two numbers a row.
HWY_INLINE void store2(V a, V b, const Rows& to)
{
  HWY_ALIGN double first[kLanes], second[kLanes];
  hn::Store(a, Tag(), first);
  hn::Store(b, Tag(), second);
  for (int k = 0; k < kLanes; ++k)
  {
    to.row[k][0] = first[k];
    to.row[k][1] = second[k];
  }
}

/// Of `count` numbers in a row.
template <class Batch>
HWY_INLINE void put_down(V v, double* to, Batch b)
{
  if (b.count == kLanes) return hn::StoreU(v, Tag(), to + b.i);
  HWY_ALIGN double numbers[kLanes];
  hn::Store(v, Tag(), numbers);
  for (int k = 0; k < b.count; ++k) to[b.i + k] = numbers[k];
}
