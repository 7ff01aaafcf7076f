// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_FINER_PAIR_H
#define DRILL_RIG_SIM_SIM_FINER_PAIR_H

#include "drill_rig_sim/accuracy/verification.h"
#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// How much shorter elements and steps of the finer model are, of the finest its square.
constexpr double usual_refinement = 2.0, least_refinement = 1.2, most_refinement = 8.0;

/// Two finer models beside a simulator, and how wrong they find it (accuracy/verification.h): what `drill verify` and the audits
/// of campaigns do.
class FinerPair
{
public:
  /// Adds both to `simulator`, before its first frame. Throws std::runtime_error with one line where `times` is out of range, and
  /// as Simulator::add_companion() does.
  FinerPair(Simulator& simulator, double times);

  /// Call after each frame of that simulator, of `duration` [s]. Throws std::runtime_error with one line where one of the two has
  /// ended.
  void add(const Simulator& simulator, double duration);
  const Verification& findings() const noexcept { return findings_; }
  double times() const noexcept { return times_; }
  /// Their numbers among the companions of the simulator.
  int finer() const noexcept { return finer_; }
  int finest() const noexcept { return finest_; }

private:
  double times_;
  int finer_, finest_;
  Verification findings_;
};

/// right, warned, missed or unknown, as JSON and Python have it.
const char* word_of(Verification::Verdict verdict) noexcept;

/// Names and values of what was found of an output, as JSON and Python have them: v(name, value).
template <class V>
void visit(const Verification& findings, Output output, V&& v)
{
  const Verification::Finding found = findings.finding(output);
  v("needed", findings.needed(output));
  v("verdict", word_of(findings.verdict(output)));
  v("mean", found.mean);
  v("finest_mean", found.finest_mean);
  v("scale", found.scale);
  v("worst", found.worst);
  v("worst_until", found.worst_until);
  v("known_to", found.own);
  v("known", found.known);
  v("wrong_from", found.wrong_from);
  v("parted_from", found.parted_from);
  v("mean_off", found.statistics.mean);
  v("deviation_off", found.statistics.deviation);
  v("extremes_off", found.statistics.extremes);
  v("period_off", found.statistics.period);
  v("off", found.off);
  v("measured", found.measured);
}

}  // namespace drill_rig_sim

#endif
