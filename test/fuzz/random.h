// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_FUZZ_RANDOM_H
#define DRILL_RIG_SIM_TEST_FUZZ_RANDOM_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

namespace drill_rig_sim
{
namespace fuzz
{
/// A small generator (splitmix64) that draws the same on every machine: an input and what it leads to can be repeated.
class Random
{
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next()
  {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// 0 .. n - 1
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  bool one_in(std::size_t n) { return below(n) == 0; }
  /// low .. high
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53); }
  double sign() { return one_in(2) ? -1.0 : 1.0; }

  /// A number that a healthy caller sends, up to +-scale, or, one time in four, one that is never right.
  double wild(double scale)
  {
    if (!one_in(4)) return between(-scale, scale);
    switch (below(9))
    {
      case 0:
        return std::numeric_limits<double>::quiet_NaN();
      case 1:
        return sign() * std::numeric_limits<double>::infinity();
      case 2:
        return sign() * std::numeric_limits<double>::max();
      case 3:
        return sign() * std::numeric_limits<double>::denorm_min();
      case 4:
        return sign() * 0.0;
      case 5:
        return sign() * scale;
      case 6:
        return sign() * scale * std::pow(10.0, between(0.0, 300.0));
      case 7:
        return sign() * scale * std::pow(10.0, -between(0.0, 300.0));
      default:
        return sign() * std::nextafter(scale, 2.0 * scale);
    }
  }

private:
  std::uint64_t state_;
};

/// Inputs in text may begin with a line `# NUMBER`, a comment to their reader: the seed of what is done with them. 0 without it.
inline std::uint64_t seed_of(const std::string& text)
{
  return text.rfind("# ", 0) == 0 ? std::strtoull(text.c_str() + 2, nullptr, 10) : 0;
}

}  // namespace fuzz
}  // namespace drill_rig_sim

#endif
