// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_SIMULATOR_STATE_H
#define DRILL_RIG_SIM_SIM_SIMULATOR_STATE_H

#include <cstdint>
#include <utility>
#include <vector>

#include "drill_rig_sim/accuracy/measured_error.h"
#include "drill_rig_sim/crew/command_delay.h"
#include "drill_rig_sim/crew/commands.h"
#include "drill_rig_sim/crew/connection.h"
#include "drill_rig_sim/crew/crew.h"
#include "drill_rig_sim/crew/interlocks.h"
#include "drill_rig_sim/instruments/downlink.h"
#include "drill_rig_sim/instruments/instruments.h"
#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/instruments/zero_mean.h"
#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"
#include "drill_rig_sim/sim/accuracy.h"
#include "drill_rig_sim/sim/level_watch.h"
#include "drill_rig_sim/sim/stride.h"

namespace drill_rig_sim
{
struct SimulatorState;

/// Of a simulator's companions, only in a snapshot. A file holds as many as its simulator has.
struct CompanionStates
{
  std::vector<SimulatorState> states;

  template <class V>
  void visit(V& v);
};

/// Everything that the next frame of a Simulator depends on. A copy is a snapshot; visit() is the one list of its fields
/// (math/visit.h).
struct SimulatorState
{
  SimulatorState(State start, RigForces at_start) : mechanics(std::move(start)), forces(std::move(at_start)) {}

  std::uint64_t scene = 0;  ///< scene_hash() of the rig that it belongs to
  StringBuilt string;
  State mechanics;
  RigForces forces;  ///< of the last step: for the truth, and for which pipe is guided
  CommandState commands;
  CommandDelay delay;
  DownlinkReceiver downlink;
  InterlockState interlocks;
  bool tared = false;
  ConnectionState connection;
  CrewState crew;
  ZeroMean zero_mean;           ///< of the true hook load
  double tare_hook_load = 0.0;  ///< true one [N]
  double tare_pressure = 0.0;   ///< true one over the motor [Pa]
  AccuracyMemory accuracy;
  LevelMemory levels;
  MeasuredError measured;        ///< where numerics.companion asks for it
  bool companion_ended = false;  ///< the error is no longer measured
  Stride stride;
  Truth truth;
  Instruments instruments;
  Readings readings;
  CompanionStates companions;

  template <class V>
  void visit(V& v)
  {
    v("scene", scene);
    v("string", string);
    v("mechanics", mechanics);
    v("forces", forces);
    v("commands", commands);
    v("delay", delay);
    v("downlink", downlink);
    v("interlocks", interlocks);
    v("connection", connection);
    v("crew", crew);
    v("zero_mean", zero_mean);
    v("tared", tared);
    v("tare_hook_load", tare_hook_load);
    v("tare_pressure", tare_pressure);
    v("accuracy", accuracy);
    v("levels", levels);
    v("measured", measured);
    v("companion_ended", companion_ended);
    v("stride", stride);
    v("truth", truth);
    v("instruments", instruments);
    v("readings", readings);
    v("companions", companions);
  }
};

template <class V>
void CompanionStates::visit(V& v)
{
  v.list("state", states.data(), states.size());
}

}  // namespace drill_rig_sim

#endif
