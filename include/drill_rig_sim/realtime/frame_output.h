// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REALTIME_FRAME_OUTPUT_H
#define DRILL_RIG_SIM_REALTIME_FRAME_OUTPUT_H

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "drill_rig_sim/accuracy/outputs.h"
#include "drill_rig_sim/crew/operations.h"
#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/realtime/time_histogram.h"
#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/string_profile.h"
#include "drill_rig_sim/well/wellbore.h"

namespace drill_rig_sim
{
/// How the simulation thread fares, for diagnostics.
struct LoopStatistics
{
  TimeHistogram frame_times;  ///< that frames took to compute
  TimeHistogram lateness;     ///< of frames begun behind their time; only in real time, where they have one
  std::uint64_t overruns = 0;
  double dropped_seconds = 0.0;          ///< backlog dropped [s]
  std::uint64_t unpublished_frames = 0;  ///< frames not published because the publishers were behind
  std::uint64_t pictures_left_out = 0;   ///< frames published without the arrays that were due, for the same reason
  double speed = 1.0;
  double ticked_seconds = 0.0;  ///< simulated time that has passed frame by frame, through resets too [s]
};

enum class RunState
{
  running,
  paused,
  waiting,  ///< in lockstep, for a step
  failed
};

/// When commands were accepted [ns]; 0 = none yet.
struct CommandStamps
{
  std::int64_t last = 0;
  std::array<std::int64_t, command_kinds> accepted{};  ///< the set points asked for last, by CommandKind

  std::int64_t& of(CommandKind kind) noexcept { return accepted[static_cast<std::size_t>(kind)]; }
  std::int64_t of(CommandKind kind) const noexcept { return accepted[static_cast<std::size_t>(kind)]; }

  template <class V>
  void visit(V& v)
  {
    v("last", last);
    v("accepted", accepted);
  }
};

constexpr double accuracy_rate = 1.0;  ///< of the topic accuracy, per simulated second

/// What is published of the accuracy beside the simulator's statistics.
struct AccuracyRecord
{
  Outputs absolute_errors{};  ///< in the outputs' units; NaN where they are not measured
  std::array<StatisticDifferences, output_count>
      statistics{};  ///< errors of the outputs' statistics [-]; NaN where they are not measured, 0 where they were not asked for
  unsigned needs = 0;      ///< outputs that the scene asks for, a sum of Need
  double tolerance = 0.0;  ///< numerics.tolerance [-]
};

/// Of a simulator after its last frame, without the statistics. Neither allocates nor waits for a companion.
inline AccuracyRecord accuracy_of(const Simulator& simulator) noexcept
{
  AccuracyRecord accuracy;
  for (std::size_t i = 0; i < output_count; ++i)
    accuracy.absolute_errors[i] = simulator.measured_absolute_error(static_cast<Output>(i));
  accuracy.needs = simulator.scene().needs;
  accuracy.tolerance = simulator.scene().numerics.tolerance;
  return accuracy;
}

/// The same with the statistics, which take a search through 30 s for each output: for frames whose topic is due.
inline AccuracyRecord accuracy_with_statistics(const Simulator& simulator) noexcept
{
  AccuracyRecord accuracy = accuracy_of(simulator);
  for (std::size_t i = 0; i < output_count; ++i) accuracy.statistics[i] = simulator.measured_statistics(static_cast<Output>(i));
  return accuracy;
}

/// The values of a frame, without arrays.
struct FrameRecord
{
  std::int64_t stamp = 0;  ///< [ns]
  RunState run_state = RunState::running;
  std::uint32_t epoch = 0;  ///< how often another rig, well or saved state has taken the place of the one before
  Truth truth;
  Readings readings;
  RigSpec rig;
  CommandStamps commands;
  OperationStatus operation;  ///< number 0 also while commands from outside have the rig
  bool playing = false;       ///< program and operations give the commands
  std::uint32_t order = 0;    ///< number of the operations that the running rig was asked for; 0: none
  SimulatorStatistics physics;
  AccuracyRecord accuracy;
  LoopStatistics loop;
  std::uint64_t commands_refused = 0;  ///< since the node began
  const char* last_refusal = "";       ///< why the last one was; static storage
  ActiveFaults faults;
  FaultDepths fault_depths{};
  const char* last_clamp = "";      ///< which limit the last clamped command met; static storage
  std::array<char, 256> failure{};  ///< why the last frame failed; empty otherwise
};

/// What is drawn or listed along string and well: large, so a ring lends it only to frames that show it.
struct FrameArrays
{
  StringProfile profile;
  std::vector<WellNode> axis;  ///< the hole at each entry of the profile
  std::vector<PartPose> parts;
  std::vector<WellNode> well;
  std::vector<WellNode> stations;  ///< the hole at the survey's stations
};

/// What the simulation thread hands to the publishers after a frame. The arrays are filled where their flag is set.
struct FrameOutput : FrameArrays
{
  FrameRecord frame;
  bool new_stamp = true;  ///< false: nothing but a picture for a new subscriber
  bool rebuilt = false;   ///< the first one of another rig or well
  bool restored = false;  ///< the first one of a state that was saved
  bool state_due = false;
  bool state_again = false;  ///< without a new stamp: rig_state says it once more
  bool accuracy_due = false;
  bool profile_due = false;  ///< drillstring_state
  bool tf_due = false;
  bool markers_due = false;
  bool well_due = false;    ///< the well has changed, or there is a new subscriber
  bool tube_due = false;    ///< markers are due and have not shown the well as it is
  bool has_arrays = false;  ///< a ring has lent it a set

  /// Whether any of the arrays is to be filled.
  bool arrays_due() const noexcept { return profile_due || tf_due || markers_due || well_due; }
};

}  // namespace drill_rig_sim

#endif
