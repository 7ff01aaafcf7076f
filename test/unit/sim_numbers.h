// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_SIM_NUMBERS_H
#define DRILL_RIG_SIM_TEST_SIM_NUMBERS_H

#include <cmath>
#include <cstring>
#include <vector>

#include "drill_rig_sim/math/visit.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/simulator_state.h"

/// Every number that a simulator shows or remembers, for comparisons bit by bit.
namespace drill_rig_sim
{
struct NumberCollector
{
  std::vector<double> out;
  template <class N>
  void operator()(const std::string&, N& number)
  {
    out.push_back(static_cast<double>(number));
  }
  void size(const std::string&, std::size_t& count) { out.push_back(static_cast<double>(count)); }
};

/// Every number of a value that lists its fields (math/visit.h).
template <class T>
std::vector<double> numbers_of(const T& value)
{
  NumberCollector collector;
  visit_numbers(const_cast<T&>(value), collector);
  return collector.out;
}

/// The same into `out`, overwritten.
template <class T>
void numbers_of(const T& value, std::vector<double>& out)
{
  out = numbers_of(value);
}

inline bool all_finite(const std::vector<double>& numbers)
{
  for (double x : numbers)
    if (!std::isfinite(x)) return false;
  return true;
}

inline bool bit_identical(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace drill_rig_sim

#endif
