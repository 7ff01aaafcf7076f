// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STABILITY_VERDICT_H
#define DRILL_RIG_SIM_STABILITY_VERDICT_H

#include <string>
#include <vector>

namespace drill_rig_sim
{
/// What became of a case.
enum class Verdict
{
  passes,
  passes_by_halving,    ///< right, but some steps had to be subdivided
  fails_diverged,       ///< numbers not finite, or motion beyond every bound
  fails_not_converged,  ///< a step that could not be solved even in parts: the simulator stopped and said so
  fails_creep,          ///< stuck pipe moved
  fails_wrong,          ///< ran to its end, far from the reference
  refused,              ///< bad input, refused with a line that says why
  too_slow,             ///< stopped by its allowance of work before its end
  not_available         ///< this version has no such thing
};

const char* words(Verdict verdict);
inline bool passed(Verdict v)
{
  return v == Verdict::passes || v == Verdict::passes_by_halving;
}

/// What README.md beside this promises of a case.
enum class Promise
{
  none,
  passes,
  diagnostic  ///< passes, or is refused, or stops with a message: no garbage
};

/// One row of the table.
struct Row
{
  std::string group;  ///< map, turns, sticking, ...
  std::string name;   ///< of the case; map: the axis
  std::string value;  ///< map: the axis' value; else empty
  std::string method;
  std::string element;
  Promise promise = Promise::none;
  Verdict verdict = Verdict::passes;
  double figure = 0.0;  ///< map: largest step that passes without halving [s], 0: none; else the case's own
  std::string unit;
  std::string text;  ///< what was seen
};

const char* words(Promise promise);
/// What is promised of the row came true. Outside the range the reference may be too slow for the case's time: that is no
/// garbage.
bool kept(const Row& row);

/// Prints rows as CSV at once, and remembers whether a promise was broken.
class Rows
{
public:
  static void print_header();
  void add(const Row& row);
  bool promises_kept() const { return broken_ == 0; }

private:
  int broken_ = 0;
};

}  // namespace drill_rig_sim

#endif
