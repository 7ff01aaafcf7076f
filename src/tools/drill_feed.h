// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_FEED_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_FEED_H

#include <algorithm>
#include <string>
#include <vector>

#include "drill_rig_sim/crew/operations.h"
#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/scene/scene.h"
#include "drill_units.h"

namespace drill_rig_sim
{
/// Of drill and slide: for how long their largest block speed kept the weight on bit below what was asked for. The rock gives
/// way faster than the block follows.
class FeedLimits
{
public:
  static constexpr double low = 0.8;      ///< of the weight that was asked for, below which it counts as limited [-]
  static constexpr double full = 0.95;    ///< of the largest speed, from which on the block counts as running at it [-]
  static constexpr double counts = 60.0;  ///< shorter times are not reported: weight is built up [s]
  static constexpr double of_all = 0.25;  ///< nor a smaller share of the time on bottom [-]

  struct Entry
  {
    std::size_t operation = 0;              ///< from 0
    double on_bottom = 0.0, limited = 0.0;  ///< time [s]
    double weight = 0.0;                    ///< integral of the weight over `limited` [N s]

    bool is_reported() const noexcept { return limited >= std::max(counts, of_all * on_bottom); }
    double mean_weight() const noexcept { return weight / limited; }
  };

  /// After each frame.
  void add(const std::vector<Operation>& operations, const OperationStatus& status, const Truth& truth, const Readings& now)
  {
    const double duration = now.time - before_;
    before_ = now.time;
    if (status.number == 0) return;
    const auto i = static_cast<std::size_t>(status.number - 1);
    const Operation& o = operations[i];
    if (!traits_of(o.kind).drills || !truth.on_bottom) return;
    if (entries_.empty() || entries_.back().operation != i) entries_.push_back({i});
    Entry& entry = entries_.back();
    entry.on_bottom += duration;
    if (now.mean_surface_wob >= low * o.weight || -now.block_velocity < full * o.speed) return;
    entry.limited += duration;
    entry.weight += duration * now.mean_surface_wob;
  }

  /// In the order of the operations.
  const std::vector<Entry>& entries() const noexcept { return entries_; }

private:
  double before_ = 0.0;
  std::vector<Entry> entries_;
};

/// A drill whose largest block speed is below what its rock gives way at the weight that was asked for.
struct SlowFeed
{
  std::size_t operation = 0;  ///< from 0
  double weight = 0.0;  ///< at which the rock gives way at that speed, ROP = K N^beta (W - F_0)^alpha (well/formation.h) [N]
};

/// Those that are known before a run: of drill, by the layer at true vertical depth `tvd` [m] and the rotary speed of the
/// operations before, where that weight is below FeedLimits::low and the operation lasts FeedLimits::counts or longer. None of a
/// string with a mud motor, nor of a bit that is not stribeck: their speed and depth of cut are not known beforehand.
std::vector<SlowFeed> slow_feeds(const Scene& scene, double tvd);

/// "operations: number 4, drill: its speed of 0.001 m/s limits the weight on bit to 0.8 kN for 70 s (weight: 10.0 kN); ...".
/// @param limits  limits or limited
/// @param duration  [s], 0: not known
std::string feed_limit_text(std::size_t operation, const Operation& o, const char* limits, double weight, double duration,
                            const Printed& printed);

}  // namespace drill_rig_sim

#endif
