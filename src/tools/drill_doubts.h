// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_DOUBTS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_DOUBTS_H

#include <vector>

#include "drill_rig_sim/sim/accuracy.h"
#include "drill_times.h"

namespace drill_rig_sim
{
/// Why a run's numbers may be wrong: of each kind of warning when it was set, and its largest value.
class Doubts
{
public:
  struct Entry
  {
    Times times;
    AccuracyReport report;  ///< the largest
  };

  /// With each frame. `time`: simulated [s].
  void add(double time, const AccuracyReport& now)
  {
    const double before = time_;
    time_ = time;
    if (now.doubt == AccuracyDoubt::none) return;
    for (Entry& entry : entries_)
      if (entry.report.doubt == now.doubt)
      {
        entry.times.add(time, before);
        if (now.measure > entry.report.measure) entry.report = now;
        return;
      }
    entries_.push_back({Times(time), now});
  }

  /// In the order in which they came.
  const std::vector<Entry>& entries() const noexcept { return entries_; }

private:
  std::vector<Entry> entries_;
  double time_ = 0.0;  // of the latest frame [s]
};

}  // namespace drill_rig_sim

#endif
