// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_SIGNALS_H
#define DRILL_RIG_SIM_ROS_SIGNALS_H

namespace drill_rig_sim
{
/// SIGINT and SIGTERM end the node: roscpp shuts down, which takes it off the master, and what waits for that goes on. Where the
/// process has not ended by itself 6 s later, because a large rig is being built or one frame takes long, it ends with status 0
/// all the same: nothing is left to be written. Call once, after ros::init() with NoSigintHandler.
void end_on_signals();

/// While one lives, a signal to end waits. What roscpp registers on the master while it shuts down may stay
/// there.
class SignalHold
{
public:
  SignalHold() noexcept;
  SignalHold(const SignalHold&) = delete;
  SignalHold& operator=(const SignalHold&) = delete;
  ~SignalHold() { release(); }
  /// Ends it; a signal that has come meanwhile ends the node now.
  void release() noexcept;

private:
  bool holds_ = true;
};

}  // namespace drill_rig_sim

#endif
