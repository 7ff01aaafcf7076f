// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_LINK_STATE_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_LINK_STATE_H

#include <string>

namespace drill_rig_sim::console
{
/// How the console and the simulator stand to each other.
enum class LinkState
{
  hidden,     // nothing is subscribed to
  no_master,  // of ROS
  absent,     // rig_state is not published, or nothing came for long
  expected,   // it is, nothing has come yet
  running,
  late,  // it should have said something
  paused,
  waiting,  // in lockstep, for a step
  failed
};

/// run_state of RigState, or what the diagnostics say of it.
enum class RunState
{
  unknown,
  running,
  paused,
  waiting,
  failed
};

/// What is known of the simulator. Ages in wall time [s], from when listening began where nothing has come.
struct Heard
{
  bool shown = false, master = false, publisher = false;
  double state_age = 0.0, diagnostics_age = 0.0;
  double speed = 1.0;  // that was asked for, simulated seconds per wall second; 0: as fast as possible
  RunState run_state = RunState::unknown;
};

constexpr double late_after = 1.0;              // of rig_state while it runs: 100 frames at the default rate [s]
constexpr double diagnostics_late_after = 3.5;  // come once a second, paused or not [s]
constexpr double gone_after = 6.0;              // nothing at all: a connection to who was killed stays [s]

/// A simulator that is slowed down sends frames more rarely and is late later; one that is paused sends none: its diagnostics
/// tell that it lives.
LinkState link_state(const Heard& heard);
/// Whether a command has a subscriber.
bool hears(LinkState state);
/// One word, capitals.
const char* name_of(LinkState state);
/// Of the diagnostics' value `state`; unknown where it is none of its words.
RunState run_state_of(const std::string& word);

}  // namespace drill_rig_sim::console

#endif
