// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_PYTHON_IN_PROCESS_RIG_H
#define DRILL_RIG_SIM_SRC_PYTHON_IN_PROCESS_RIG_H

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "drill_rig_sim/crew/player.h"
#include "drill_rig_sim/scene/new_well.h"
#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/sim/finer_pair.h"
#include "drill_rig_sim/sim/simulator.h"

/// A rig that the caller steps, without ROS; by the same steps as the node in lockstep. What is refused is std::runtime_error
/// with one line, and nothing has changed.
namespace drill_rig_sim
{
/// Calls v for the fields of signals by the names of their message: set points are flat there, and the crew's task is a word,
/// current_operation(). What a rig cannot see of its steering is for the truth.
template <class V, bool with_steering>
struct ByMessage
{
  V& v;
  template <class T>
  void operator()(const char* name, T& field)
  {
    v(name, field);
  }
  void operator()(const char*, CrewTask&) {}
  void operator()(const char*, Setpoints& s)
  {
    v("winch", s.winch);
    v("top_drive", s.top_drive);
    v("mud_pump", s.pump);
    if constexpr (with_steering) v("steering", s.steering);
    if constexpr (with_steering) v("magnetic_steering", s.magnetic_steering);
  }
};

/// The signals by the names of RigState.msg or RigTruth.msg; those that are constant in a process (header, run_state) or stamps
/// are not there, nor refusals, which are exceptions.
template <class Values>
struct Signals
{
  Values signals;
  std::uint32_t epoch = 0;
  int operation_number = 0;
  double operation_progress = 0.0;
  OperationKind operation_kind = OperationKind::wait;
  AccuracyReport accuracy;
  ActiveFaults faults;
  FaultDepths fault_depths{};

  std::string current_operation() const;

  template <class V>
  void visit(V& v)
  {
    ByMessage<V, std::is_same_v<Values, TrueSignals>> by_message{v};
    signals.visit(by_message);
    v("epoch", epoch);
    v("operation_number", operation_number);
    v("operation_progress", operation_progress);
  }
};
using ShownFrame = Signals<ShownSignals>;
using TrueFrame = Signals<TrueSignals>;

/// A place in the frame of the rig floor [m].
struct Place
{
  double x = 0.0, y = 0.0, z = 0.0;

  template <class V>
  void visit(V& v)
  {
    v("x", x);
    v("y", y);
    v("z", z);
  }
};

/// By the names of BitTruth.msg.
struct Bit
{
  Place position;
  double wob = 0.0, torque = 0.0, speed = 0.0, inclination = 0.0, azimuth = 0.0, toolface = 0.0;

  template <class V>
  void visit(V& v)
  {
    v("position", position);
    v("wob", wob);
    v("torque", torque);
    v("speed", speed);
    v("inclination", inclination);
    v("azimuth", azimuth);
    v("toolface", toolface);
  }
};

/// A frame could not be computed: the state is that of the last one that could, to go back from by restore() or reset().
class FrameFailed : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The results of one frame.
struct Frame
{
  ShownFrame readings;
  TrueFrame truth;
  Bit bit;
};

/// Of many frames, a row each.
struct Recording
{
  std::vector<ShownFrame> readings;
  std::vector<TrueFrame> truth;
  std::vector<Bit> bit;
};

/// A state to go back to.
struct SavedRig
{
  std::shared_ptr<const SimulatorState> state;
  ScenePlayer player;
  bool playing;
};

/// Two threads at once are refused; one after the other may use it.
class InProcessRig
{
public:
  /// The rig of a scene's file at its start. `rate`: frames a second. `play`: the scene's program and operations give the set
  /// points until a command does.
  InProcessRig(const std::string& scene_file, double rate, std::uint64_t seed, bool play);

  /// Set points from the next frame on; all of them are taken, or none.
  void command(const std::optional<WinchSetpoint>& winch, const std::optional<TopDriveSetpoint>& top_drive,
               const std::optional<PumpSetpoint>& pump, const std::optional<SteeringSetpoint>& steering);
  /// Computes this number of frames. `may_go_on` is called now and then, and may throw; what has been computed by then stays.
  void advance(std::size_t frames, const std::function<void()>& may_go_on);
  /// The state after the last frame.
  Frame frame() const;
  /// The same; adds the state after every `every`-th of them, and after the last, to `out`.
  void record(std::size_t frames, std::size_t every, const std::function<void()>& may_go_on, Recording& out);
  /// Two finer models go along from now on (sim/finer_pair.h), before the first frame; until another scene, well or start.
  /// Meanwhile nothing is restored.
  void verify(double times);
  /// What they have found so far, in a dictionary of Python's or wherever `show` puts it.
  template <class Show>
  void verified(const Show& show) const
  {
    const Turn turn(*this);
    if (!finer_) throw std::runtime_error("nothing is verified: call verify() before the first frame");
    show(*simulator_, *finer_);
  }
  /// The last that has come up from downhole, if any.
  std::optional<ToolfaceReading> toolface() const;
  std::optional<MwdReading> survey() const;
  std::optional<InclinationReading> inclination() const;
  std::optional<DynamicsReading> dynamics() const;

  /// Of the batch kernels: the same scene gives the same bits by the same build and kernel alone.
  std::string kernel() const;
  /// Of how the files of scene and survey were read, one line each.
  std::vector<std::string> remarks() const;
  /// Of a joint of the pipe that is added and taken away [m].
  double joint_length() const noexcept { return scene_.string.back().joint_length; }
  /// Why the last frame's numbers may be wrong, one line (sim/accuracy.h); empty without a reason.
  std::string accuracy_warning() const;
  /// Its short identifier, that of code_of().
  std::string accuracy_code() const;
  /// The faults under way, by words_of().
  std::vector<std::string> active_faults() const;
  /// By output the error over the last 3 s that the companion measures, as a share of the output's range [-]
  /// (accuracy/measured_error.h); empty while nothing is measured.
  std::map<std::string, double> measured_errors() const;
  /// Why the error is not measured, one line; empty while it is, and before the first frame that is compared.
  std::string not_measured() const;
  /// Whether the scene's crew makes connections of its own.
  bool crew_connects() const noexcept { return scene_.connections == Connections::automatic; }
  /// Where the block would hang on lines without load [m]: what the drum has done, without what the load stretches.
  double drum_height() const;
  /// The same by rows of what gauges like the scene's showed: heights of the block without noise [m] and hook loads [N]. The
  /// sheaves' friction is taken out of a dead line's reading (rig/recorded_drum.h). Throws std::runtime_error unless both are as
  /// long.
  std::vector<double> drum_heights(const std::vector<double>& heights, const std::vector<double>& hook_loads) const;
  /// Force over speed of a wave along the pipe at the string's top [N s/m].
  double wave_impedance() const noexcept;
  /// Of the travelling block, hook and top drive [kg].
  double block_mass() const noexcept { return scene_.rig.hoisting.block_mass; }
  /// Of the crown block above the rotary table [m].
  double crown_height() const noexcept { return scene_.rig.hoisting.crown_height; }
  /// Largest acceleration of the block [m/s2].
  double block_acceleration() const noexcept { return scene_.rig.hoisting.max_acceleration; }
  /// Largest speed of the top drive [rad/s].
  double max_rotation() const noexcept { return scene_.rig.top_drive.max_speed; }
  /// Largest flow of the pump [m3/s].
  double max_flow() const noexcept { return scene_.rig.mud_pump.max_flow; }
  /// Back to the start of a scene's file, or of the present scene where `file` is empty; the bit at `bit_depth` [m MD], 0: where
  /// the scene has it.
  void reset(const std::string& file, double bit_depth);
  void load_survey(const NewWell& well);
  void tare();
  Zero tare_over(double duration);
  void fault(const std::string& name, bool clear, const std::string& target, double depth, double magnitude);
  void slips(bool are_set);
  /// Sets the slips on the joint that a connection with these joints needs (Simulator::set_slips_for).
  void slips_for(std::uint32_t joints, bool remove);
  void connection(std::uint32_t joints, bool remove);
  /// Begins operations, YAML as `operations` of a scene: a list or one block. They take the place of what is played.
  void operate(const std::string& operations);
  /// Why the operation under way was given up; empty: it was not.
  std::string given_up() const;
  SavedRig save() const;
  void restore(const SavedRig& saved);

private:
  /// The user of the rig, for as long as it lives. Refused to others meanwhile.
  class Turn
  {
  public:
    explicit Turn(const InProcessRig& rig);
    ~Turn() { busy_ = false; }

  private:
    std::atomic<bool>& busy_;
  };
  void require_good() const;
  void build(const Scene& scene);
  /// Computes them, and calls after_frame(k) after the k-th.
  template <class AfterFrame>
  void play(std::size_t frames, const std::function<void()>& may_go_on, const AfterFrame& after_frame);
  Frame last_frame() const;

  Scene scene_;  // of the file, whatever has been loaded since
  double off_bottom_, rate_;
  std::uint64_t seed_;
  std::uint32_t epoch_ = 0;  // of its frames
  bool play_, playing_ = false, failed_ = false;
  mutable std::atomic<bool> busy_{false};
  std::optional<Simulator> simulator_;
  std::optional<FinerPair> finer_;
  ScenePlayer player_;
};

}  // namespace drill_rig_sim

#endif
