// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_SIMULATOR_H
#define DRILL_RIG_SIM_SIM_SIMULATOR_H

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/crew/rig_controls.h"
#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/instruments/zero_window.h"
#include "drill_rig_sim/math/kernel.h"
#include "drill_rig_sim/model/energy_accounts.h"
#include "drill_rig_sim/model/profiler.h"
#include "drill_rig_sim/model/work.h"
#include "drill_rig_sim/scene/fault_spec.h"
#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/sim/accuracy.h"
#include "drill_rig_sim/sim/assembly_fit.h"
#include "drill_rig_sim/sim/faults.h"
#include "drill_rig_sim/sim/string_profile.h"
#include "drill_rig_sim/sim/string_watch.h"
#include "drill_rig_sim/solve/reference_report.h"

namespace drill_rig_sim
{
class Wellbore;
struct SimulatorState;

enum class FrameStatus
{
  running,  ///< the frame was computed
  failed    ///< it could not be: time stands at the last good state until restore() or a rebuilt Simulator
};

/// Where companions compute their frames. A run and its measured error are the same to the bit by the first two.
enum class CompanionPace
{
  in_turn,             ///< in the thread that computes the run's frames, before each
  own_thread,          ///< in a thread of their own; the run waits where they are late
  own_thread_unwaited  ///< in a thread of their own; where they are late for too long, the error is no longer measured: for real
                       ///< time
};

/// The companion that measures the error (numerics.companion), as of its last frame that the run has taken.
struct CompanionStatistics
{
  const char* level = "";  ///< empty: there is none
  int nodes = 0;
  int coordinates = 0;   ///< of its last frame
  double seconds = 0.0;  ///< computing time since the start [s]
};

/// Counters since the start, for diagnostics and the runner's summary.
struct SimulatorStatistics
{
  std::uint64_t frames = 0;
  std::uint64_t steps = 0;  ///< physics steps that were accepted
  std::uint64_t newton_iterations = 0;
  std::uint64_t convergence_failures = 0;  ///< attempts without a solution, repeated with half the step
  std::uint64_t error_test_failures = 0;   ///< attempts repeated with half the step for accuracy
  Work work;                               ///< residuals, tangents and linear solves
  std::uint64_t commands_clamped = 0;
  std::uint64_t commands_refused = 0;
  int nodes = 0;
  int coordinates = 0;                   ///< of the last frame
  int guided_nodes = 0;                  ///< of the last frame
  std::uint64_t guided_node_frames = 0;  ///< guided nodes, summed over all frames
  Kernel kernel = Kernel::scalar;        ///< of the batch kernels
  const char* level = "";
  const char* integrator = "";
  double step = 0.0;                   ///< numerics.step, 0: variable [s]
  double last_step = 0.0;              ///< the one that the last frame lies in, or its last [s]
  double last_error_estimate = 0.0;    ///< local, of the last step's positions [m]
  std::optional<TightAssembly> tight;  ///< by the start's forces
  StringLoads loads;                   ///< at the end of the last step, up to 50 ms after the frame
  AccuracyReport accuracy;             ///< what stands after the last frame
  bool error_is_measured =
      false;  ///< numerics.companion goes along, and these are the errors by output (Simulator::measured_error()) [-]:
  Outputs errors{};
  const char* not_measured = "";  ///< why the error is not measured, one line; empty while it is
  CompanionStatistics companion;
  Profiler costs;             ///< where the frames' time went
  bool is_reference = false;  ///< the integrator is ida, and this is its report:
  ReferenceReport reference;
};

/// A rig, a string and a well that commands drive through time. Knows no wall clock and no ROS.
/// After construction nothing here allocates but save(), make_connection(), attend() and a restore() of a longer or shorter
/// string, and frame() never throws.
class Simulator final : public RigControls
{
public:
  /// Builds the rig at rest in static equilibrium, winch braked, as `scene.start` says.
  /// Throws std::runtime_error with one line (what, where, what is allowed) if the scene cannot be built.
  explicit Simulator(const Scene& scene, std::uint64_t seed = 0);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;

  CommandResult command(const WinchSetpoint& c) noexcept override;
  CommandResult command(const TopDriveSetpoint& c) noexcept override;
  CommandResult command(const PumpSetpoint& c) noexcept override;
  CommandResult command(const SteeringSetpoint& c) noexcept override;
  /// Why a command would be refused at present, one line, static storage: slips and a broken-out string lock what would turn, run
  /// or pump, and a string without a rotary_steerable cannot be steered; null: it would not be.
  const char* locked(const WinchSetpoint& c) const noexcept;
  const char* locked(const TopDriveSetpoint& c) const noexcept;
  const char* locked(const PumpSetpoint& c) const noexcept;
  const char* locked(const SteeringSetpoint& c) const noexcept;
  /// The set points asked for by the last commands, or the watchdog's, though no frame has been computed since; the truth holds
  /// what interlocks and faults leave of them.
  Setpoints setpoints() const noexcept;
  const Setpoints& asked() const noexcept override;
  /// Winch and drive streams that stop for longer than this set the brake and coast the drive [s]; 0 = off.
  void set_command_timeout(double seconds) noexcept;
  /// The winch's or the drive's last command stands until its next one: no stream is expected, whose silence would be noticed.
  void winch_command_stands() noexcept;
  void drive_command_stands() noexcept;

  /// Advances by `duration` [s], a multiple of the scene's step, in as many physics steps; where that is 0, in steps as its
  /// tolerance allows. Nothing happens in a duration that is not above 0.
  FrameStatus frame(double duration) noexcept;
  void fail(const char* reason) noexcept override;
  /// Opens an energy balance for the frames to come, or closes it. Frames cost some three residuals a step more while it is open,
  /// and give the same results. restore() opens it anew.
  void balance_energy(bool on = true);
  /// The balance's accounts since it was opened; all zero without a balance.
  const EnergyAccounts& energy() const noexcept;
  /// Why the last frame failed, one line; empty while running.
  const char* failure() const noexcept;

  const Truth& truth() const noexcept override;
  const Readings& readings() const noexcept override;
  /// Fills the arrays in place; they allocate on first use only.
  void profile(StringProfile& out) const;
  /// Named bottom-hole parts and every `every`-th pipe joint.
  void part_poses(int every, std::vector<PartPose>& out) const;
  /// As the last whole step left it: by variable steps up to 50 ms before the last frame's end.
  const Wellbore& wellbore() const noexcept;
  /// The uncorrected path of the last metres drilled, oldest first (a bounded buffer).
  void raw_path(std::vector<Eigen::Vector3d>& out) const;
  const SimulatorStatistics& statistics() const noexcept;
  const Scene& scene() const noexcept override;
  /// Why level auto has chosen what it has, one line; empty for other levels.
  const std::string& choice() const noexcept;

  bool tare() noexcept override;
  /// The same zeroes at their means over the last `duration` [s], for the gauges `zero` answers which. False, and nothing
  /// changed, on bottom, in the slips, and where that is longer than zero_held().
  bool tare_over(double duration, Zero& zero) noexcept;
  /// How long the string has hung, or moved steadily, with the same set point of the pump, at most some ZeroWindow::longest [s].
  double zero_held() const noexcept;
  bool stick_pipe(double md) noexcept override;
  void free_pipe() noexcept override;
  const char* inject(const Fault& fault) noexcept override;
  void clear(FaultKind kind, Gauge gauge) noexcept override;
  /// The faults under way, by inject() or the scene's program. One whose magnitude makes no difference (a factor of 1) is not
  /// listed.
  ActiveFaults active_faults() const noexcept;
  /// Where they are (sim/faults.h).
  FaultDepths fault_depths() const noexcept;
  bool set_free_length(double from_bit) noexcept override;

  const char* set_slips(bool set) noexcept override;
  /// Sets the slips on the joint that a connection with these joints needs (0: a stand), also where another one is nearer to the
  /// rotary table. Refused (a text) as set_slips() is, and where the string does not have as many joints. Allocates.
  const char* set_slips_for(int joints, bool remove);
  const char* make_connection(int joints, bool remove) noexcept override;
  void call_crew(bool on) noexcept override;
  /// What the rig's crew does between two frames: makes up the string of a connection that is over, and connections of its own
  /// (crew.h). Only here a simulator rebuilds its string, and then allocates: a millisecond for 3 km of guided pipe, five for
  /// free nodes. play_frame() calls it before every frame; without it no connection ends. `duration`: of the frame that follows
  /// [s].
  void attend(double duration) noexcept;

  /// Another model of the same rig that goes through what this one goes through, frame by frame: its set points, faults, slips,
  /// connections and zeros. Only its numerics differ: how far the two come apart measures what the numerics make of the rig.
  /// Built as the scene starts, so before the first frame. All that a frame hands out comes from this simulator, and is what it
  /// would be without a companion. Throws as the constructor does, and where frames were computed. Its number, for the functions
  /// below.
  int add_companion(const NumericsSpec& numerics);
  int companions() const noexcept;
  /// In the thread that calls frame(), or one of their own. Throws std::system_error where the system has no thread left.
  void set_companion_pace(CompanionPace pace);
  /// What companion `i` shows after the last frame. This and the next two wait for it.
  const Truth& companion_truth(int i) const noexcept;
  const SimulatorStatistics& companion_statistics(int i) const noexcept;
  /// Error of an output over 3 s, as accuracy/measured_error.h has it [-]; NaN unless numerics.companion asks for a companion and
  /// that still runs.
  double measured_error(Output output) const noexcept;
  /// The same in the output's unit.
  double measured_absolute_error(Output output) const noexcept;
  /// And of its statistics over 30 s, relative as measured_error() [-].
  StatisticDifferences measured_statistics(Output output) const noexcept;
  /// Why companion `i` no longer goes along, one line; empty while it does.
  const char* companion_failure(int i) const noexcept;

  /// A copy of everything that the next frame depends on.
  std::shared_ptr<const SimulatorState> save() const;
  /// Back to a saved state of this same scene; false, and nothing changed, for one of another scene, or whose string is not what
  /// it says. After it the next frames are bit-identical to those that followed save().
  bool restore(const SimulatorState& state);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace drill_rig_sim

#endif
