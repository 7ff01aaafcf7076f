#ifndef DRILL_RIG_SIM_REALTIME_FRAME_OUTPUT_H
#define DRILL_RIG_SIM_REALTIME_FRAME_OUTPUT_H

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/sim/signals.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/string_profile.h"
#include "drill_rig_sim/well/wellbore.h"

namespace drill_rig_sim
{
/// How the simulation thread fares, for diagnostics.
struct LoopStatistics
{
  static constexpr std::array<double, 5> bounds_ms{{1.0, 2.0, 5.0, 10.0, 20.0}};
  std::array<std::uint64_t, bounds_ms.size() + 1> frame_times{};  ///< frames that took less than each bound; last: longer
  double longest_frame = 0.0;                                     ///< [s]
  std::uint64_t overruns = 0;
  double dropped_seconds = 0.0;         ///< backlog dropped [s]
  std::uint64_t unpublished_frames = 0;  ///< frames not published because the publishers were behind
  double speed = 1.0;
  double ticked_seconds = 0.0;  ///< simulated time that has passed frame by frame, through resets too [s]

  /// Counts a frame that took `duration` [ns] to compute.
  void count_frame(std::int64_t duration) noexcept
  {
    const double ms = 1e-6 * static_cast<double>(duration);
    std::size_t bin = 0;
    while (bin < bounds_ms.size() && ms >= bounds_ms[bin]) ++bin;
    ++frame_times[bin];
    longest_frame = std::max(longest_frame, 1e-3 * ms);
  }
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
  std::array<std::int64_t, 3> accepted{};  ///< the set points asked for last: winch, top drive, pump

  template <class V>
  void visit(V& v)
  {
    v("last", last);
    v("accepted", accepted);
  }
};

/// What a frame tells, without arrays.
struct FrameRecord
{
  std::int64_t stamp = 0;  ///< [ns]
  RunState run_state = RunState::running;
  Truth truth;
  Readings readings;
  RigSpec rig;
  CommandStamps commands;
  SimulatorStatistics physics;
  LoopStatistics loop;
  const char* last_clamp = "";      ///< which limit the last clamped command met; static storage
  std::array<char, 256> failure{};  ///< why the last frame failed; empty otherwise
};

/// What the simulation thread hands to the publishers after a frame. The arrays are filled where their flag says so.
struct FrameOutput
{
  FrameRecord frame;
  bool new_stamp = true;  ///< false: nothing but a picture for a new subscriber
  bool rebuilt = false;   ///< the first one of another rig or well
  bool restored = false;  ///< the first one of a state that was saved
  bool state_due = false;
  bool state_again = false;  ///< without a new stamp: rig_state says it once more
  bool profile_due = false;  ///< drillstring_state
  bool tf_due = false;
  bool markers_due = false;
  bool well_due = false;  ///< the well has changed, or somebody new wants to see it
  bool tube_due = false;  ///< markers are due and have not shown the well as it is

  StringProfile profile;
  std::vector<WellNode> axis;  ///< the hole at each entry of the profile
  std::vector<PartPose> parts;
  std::vector<WellNode> well;
  std::vector<WellNode> stations;  ///< the hole at the survey's stations
};

}  // namespace drill_rig_sim

#endif
