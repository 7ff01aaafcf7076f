// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_CREW_WORK_H
#define DRILL_RIG_SIM_SRC_SIM_CREW_WORK_H

#include "drill_rig_sim/crew/crew.h"
#include "rig_actions.h"

namespace drill_rig_sim
{
/// The rig's crew at work: connections by itself (crew/crew.h), and the block while a connection is under way.
/// Owns `crew` of the rig's state.
class CrewWork
{
public:
  /// Both have to outlive this.
  CrewWork(SimulatedRig& rig, RigActions& actions) noexcept : rig_(rig), actions_(actions), crew_(rig.state.crew) {}

  bool is_busy() const noexcept { return crew_.doing != CrewTask::none; }
  /// It makes connections, whatever `connections` says.
  void call(bool on) noexcept { crew_.called = on; }
  /// Its set points for the frame of `duration` [s] that follows. Begins connections: then it allocates.
  void attend(double duration) noexcept;
  /// That frame passes.
  void wait(double duration) noexcept { crew_.waited += duration; }

private:
  void begin_connection() noexcept;
  bool has_to_add() const noexcept;
  bool has_to_take_away() const noexcept;
  bool has_done(double frame, WinchSetpoint& winch) noexcept;
  bool has_quieted() noexcept;
  bool has_broken_out() noexcept;
  bool has_restarted() const noexcept;
  bool zeroes_at(double height) const noexcept;
  void go_on(double height) noexcept;
  void do_task(CrewTask task) noexcept;
  WinchSetpoint to_slack(double frame) const noexcept;

  SimulatedRig& rig_;
  RigActions& actions_;
  CrewState& crew_;
};

}  // namespace drill_rig_sim

#endif
