// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_RIG_ACTIONS_H
#define DRILL_RIG_SIM_SRC_SIM_RIG_ACTIONS_H

#include "companions.h"
#include "drill_rig_sim/scene/fault_spec.h"

namespace drill_rig_sim
{
/// What is done to a rig between two frames, and then to its companions. Reasons are one line, in static storage; null: it was
/// done.
class RigActions
{
public:
  /// Both have to outlive this.
  RigActions(SimulatedRig& rig, Companions& companions) noexcept : rig_(rig), companions_(companions) {}

  /// Under a joint's end.
  const char* set_slips(int joint) noexcept;
  const char* pull_slips() noexcept;
  /// So many joints, 0: a stand. Allocates.
  const char* make_connection(int joints, bool remove) noexcept;
  /// Makes up the string where a connection is over. Allocates.
  void finish_connection();
  /// False, and nothing changed: on bottom, or in the slips.
  bool tare() noexcept;
  /// The same over the last `duration` [s], and what the gauges were zeroed at. False too where that is longer than they can be
  /// averaged over.
  bool tare_over(double duration, Zero& zero) noexcept;
  const char* inject(const Fault& fault) noexcept;
  /// `gauge`: of a fault of gauges.
  void clear(FaultKind kind, Gauge gauge) noexcept;

private:
  template <class Does>
  void do_to_all(const Does& does) noexcept
  {
    does(rig_);
    companions_.lead(does);
  }

  SimulatedRig& rig_;
  Companions& companions_;
};

}  // namespace drill_rig_sim

#endif
