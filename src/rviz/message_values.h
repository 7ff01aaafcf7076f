// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RVIZ_MESSAGE_VALUES_H
#define DRILL_RIG_SIM_RVIZ_MESSAGE_VALUES_H

#include <deque>
#include <string>
#include <vector>

#include "drill_rig_sim/Accuracy.h"
#include "drill_rig_sim/BitTruth.h"
#include "drill_rig_sim/ControllerStatus.h"
#include "drill_rig_sim/DownholeDynamics.h"
#include "drill_rig_sim/MwdInclination.h"
#include "drill_rig_sim/MwdSurvey.h"
#include "drill_rig_sim/MwdToolface.h"
#include "drill_rig_sim/RigLimits.h"
#include "drill_rig_sim/RigState.h"
#include "console/flags.h"
#include "console/limits.h"
#include "console/link_state.h"
#include "console/quantities.h"
#include "console/string_weights.h"
#include "drill_rig_sim/RigTruth.h"

namespace drill_rig_sim::console
{
/// What the simulator's diagnostics say.
struct Diagnosis
{
  RunState run_state = RunState::unknown;
  double real_time_factor = missing, speed = 1.0;
  double pull_to_yield = missing;                 // further pull until the string yields [N]
  std::string time, physics, accuracy, commands;  // its summaries; empty: all is well
};

/// The latest of each topic; null before the first.
struct News
{
  RigStateConstPtr state;
  RigTruthConstPtr truth;
  BitTruthConstPtr bit;
  RigLimitsConstPtr limits;
  AccuracyConstPtr accuracy;
  ControllerStatusConstPtr controller;  // of a law; null also where the last law's node is gone
  MwdSurveyConstPtr survey;
  MwdInclinationConstPtr inclination;
  DownholeDynamicsConstPtr dynamics;
  std::deque<MwdToolfaceConstPtr> toolfaces;  // oldest first
  Diagnosis diagnosis;
};

/// The readings of one rig_state with the rest of the news. In the slips there is no weight on bit and no differential pressure.
Values readings_of(const News& news, const RigState& state, double bit_diameter);
/// The latest readings, and the errors of the simulation where they are measured; `bit_diameter` [m], 0: not known.
Values readings_of(const News& news, double bit_diameter);
/// The truth, as far as it is subscribed to.
Values truth_of(const News& news, double bit_diameter);
RigAbilities abilities_of(const RigLimits& limits);
/// `truth`: for what no rig can sense; null: those flags are down.
Flags flags_of(const RigState& state, const RigTruth* truth);
/// What shows a move of the string; its hook load is missing in a drop-out.
MoveReading move_reading_of(const RigState& state, const Values& readings);
/// Whether the bit drills by the readings: near bottom, in no slips, with a rate of penetration.
bool drills(const RigState& state);
RunState run_state_of(const RigState& state);

}  // namespace drill_rig_sim::console

#endif
