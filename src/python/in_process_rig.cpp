// SPDX-License-Identifier: BSD-3-Clause
#include "in_process_rig.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/math/kernel.h"
#include "drill_rig_sim/rig/recorded_drum.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/requests.h"
#include "drill_rig_sim/sim/run.h"
#include "drill_rig_sim/sim/simulator_state.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t most_frames = 100000;  // of one call, as of the service step
constexpr std::size_t frames_between_looks = 100;

template <class Setpoint>
void require(const Simulator& simulator, const std::optional<Setpoint>& command)
{
  const char* wrong = command ? why_refused(simulator, *command) : nullptr;
  if (wrong) throw std::runtime_error(wrong);
}

template <class Setpoint>
bool take(Simulator& simulator, const std::optional<Setpoint>& command) noexcept
{
  if (command) simulator.command(*command);
  return command.has_value();
}

template <class Values>
Signals<Values> signals_of(const Values& signals, const Simulator& simulator, std::uint32_t epoch,
                           const OperationStatus& operation)
{
  return {signals,
          epoch,
          operation.number,
          operation.progress,
          operation.kind,
          simulator.statistics().accuracy,
          simulator.active_faults(),
          simulator.fault_depths()};
}

Bit bit_of(const Truth& t)
{
  Bit bit;
#define BIT(name, field, dimension, value, ...) bit.field = value;
#include "drill_rig_sim/scene/signal_list.h"
  return bit;
}

template <class Reading>
std::optional<Reading> if_any(const Reading& reading)
{
  return reading.sequence > 0 ? std::optional<Reading>(reading) : std::nullopt;
}

FaultKind kind_named(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (int kind = 0; kind < fault_count; ++kind)
    if (name == fault_traits[kind].word) return static_cast<FaultKind>(kind);
  std::string allowed;
  for (const FaultTraits& fault : fault_traits) allowed += (allowed.empty() ? "" : ", ") + std::string(fault.word);
  throw std::runtime_error("fault is " + name + "; allowed: " + allowed);
}
}  // namespace

template <class Values>
std::string Signals<Values>::current_operation() const
{
  if (signals.crew != CrewTask::none) return text_of(signals.crew);
  return operation_number > 0 ? word_of(operation_kind) : "";
}
template struct Signals<ShownSignals>;
template struct Signals<TrueSignals>;

InProcessRig::InProcessRig(const std::string& scene_file, double rate, std::uint64_t seed, bool play)
    : scene_(read_scene(scene_file)), off_bottom_(off_bottom(scene_)), rate_(rate), seed_(seed), play_(play)
{
  build(scene_);
}

void InProcessRig::build(const Scene& scene)
{
  check_rate(rate_, scene);
  finer_.reset();
  if (simulator_) ++epoch_;
  simulator_.emplace(scene, seed_);
  player_ = ScenePlayer(simulator_->scene());
  playing_ = play_;
  failed_ = false;
}

void InProcessRig::require_good() const
{
  if (failed_) throw std::runtime_error("the last frame failed: reset or restore first");
}

void InProcessRig::command(const std::optional<WinchSetpoint>& winch, const std::optional<TopDriveSetpoint>& top_drive,
                           const std::optional<PumpSetpoint>& pump, const std::optional<SteeringSetpoint>& steering)
{
  const Turn turn(*this);
  require_good();
  require(*simulator_, winch);
  require(*simulator_, top_drive);
  require(*simulator_, pump);
  require(*simulator_, steering);
  const bool any =
      take(*simulator_, winch) | take(*simulator_, top_drive) | take(*simulator_, pump) | take(*simulator_, steering);
  if (!any || !playing_) return;
  player_.hand_over(*simulator_, winch.has_value());
  playing_ = false;
}

InProcessRig::Turn::Turn(const InProcessRig& rig) : busy_(rig.busy_)
{
  if (busy_.exchange(true)) throw std::runtime_error("another thread is using this rig");
}

template <class AfterFrame>
void InProcessRig::play(std::size_t frames, const std::function<void()>& may_go_on, const AfterFrame& after_frame)
{
  if (frames > most_frames)
    throw std::runtime_error("frames is " + std::to_string(frames) + "; allowed is 0 to " + std::to_string(most_frames));
  require_good();
  for (std::size_t k = 1; k <= frames; ++k)
  {
    failed_ = play_frame(*simulator_, playing_ ? &player_ : nullptr, 1.0 / rate_) == FrameStatus::failed;
    if (failed_)
      throw FrameFailed(std::string("a frame failed: ") + simulator_->failure() + " (" + std::to_string(k) + " of " +
                        std::to_string(frames) + " frames)");
    if (finer_) finer_->add(*simulator_, 1.0 / rate_);
    after_frame(k);
    if (k % frames_between_looks == 0) may_go_on();
  }
}

void InProcessRig::advance(std::size_t frames, const std::function<void()>& may_go_on)
{
  const Turn turn(*this);
  play(frames, may_go_on, [](std::size_t) {});
}

Frame InProcessRig::last_frame() const
{
  const OperationStatus operation = playing_ ? player_.operations().status() : OperationStatus();
  return {signals_of<ShownSignals>(simulator_->readings(), *simulator_, epoch_, operation),
          signals_of<TrueSignals>(simulator_->truth(), *simulator_, epoch_, operation), bit_of(simulator_->truth())};
}

std::vector<std::string> InProcessRig::remarks() const
{
  const Turn turn(*this);
  return scene_.remarks;
}

std::string InProcessRig::kernel() const
{
  const Turn turn(*this);
  return name_of(simulator_->statistics().kernel);
}

std::string InProcessRig::accuracy_code() const
{
  const Turn turn(*this);
  return code_of(simulator_->statistics().accuracy.doubt);
}

std::vector<std::string> InProcessRig::active_faults() const
{
  const Turn turn(*this);
  return words_of(simulator_->active_faults());
}

std::string InProcessRig::accuracy_warning() const
{
  const Turn turn(*this);
  return text_of(simulator_->statistics().accuracy);
}

std::map<std::string, double> InProcessRig::measured_errors() const
{
  const Turn turn(*this);
  const SimulatorStatistics& now = simulator_->statistics();
  std::map<std::string, double> found;
  if (!now.error_is_measured) return found;
  for (std::size_t i = 0; i < output_count; ++i) found[output_traits[i].name] = now.errors[i];
  return found;
}

std::string InProcessRig::not_measured() const
{
  const Turn turn(*this);
  return simulator_->statistics().not_measured;
}

double InProcessRig::drum_height() const
{
  const Turn turn(*this);
  return unloaded_height(scene_.rig.hoisting, simulator_->truth().block_height, simulator_->truth().hook_load);
}

std::vector<double> InProcessRig::drum_heights(const std::vector<double>& heights, const std::vector<double>& hook_loads) const
{
  if (hook_loads.size() != heights.size()) throw std::runtime_error("heights and hook loads must have the same length");
  return drill_rig_sim::drum_heights(scene_.rig.hoisting, scene_.instruments.hook_load.place == HookLoadPlace::dead_line, heights,
                                     hook_loads);
}

double InProcessRig::wave_impedance() const noexcept
{
  const PartSpec& pipe = scene_.string.back();
  const double area = 0.25 * M_PI * (pipe.outer_diameter * pipe.outer_diameter - pipe.inner_diameter * pipe.inner_diameter);
  return std::sqrt(pipe.young_modulus * area * pipe.linear_mass);
}

Frame InProcessRig::frame() const
{
  const Turn turn(*this);
  return last_frame();
}

void InProcessRig::record(std::size_t frames, std::size_t every, const std::function<void()>& may_go_on, Recording& out)
{
  const Turn turn(*this);
  if (every < 1 || every > most_frames)
    throw std::runtime_error("every is " + std::to_string(every) + "; allowed is 1 to " + std::to_string(most_frames));
  play(frames, may_go_on,
       [&](std::size_t k)
       {
         if (k % every != 0 && k != frames) return;
         const Frame f = last_frame();
         out.readings.push_back(f.readings);
         out.truth.push_back(f.truth);
         out.bit.push_back(f.bit);
       });
}

void InProcessRig::verify(double times)
{
  const Turn turn(*this);
  if (finer_) throw std::runtime_error("finer models are already running");
  finer_.emplace(*simulator_, times);
}

std::optional<ToolfaceReading> InProcessRig::toolface() const
{
  const Turn turn(*this);
  return if_any(simulator_->readings().toolface);
}

std::optional<MwdReading> InProcessRig::survey() const
{
  const Turn turn(*this);
  return if_any(simulator_->readings().mwd);
}

std::optional<InclinationReading> InProcessRig::inclination() const
{
  const Turn turn(*this);
  return if_any(simulator_->readings().inclination);
}

std::optional<DynamicsReading> InProcessRig::dynamics() const
{
  const Turn turn(*this);
  return if_any(simulator_->readings().dynamics);
}

void InProcessRig::reset(const std::string& file, double bit_depth)
{
  const Turn turn(*this);
  const Scene scene = file.empty() ? scene_ : read_scene(file);
  build(with_bit_depth(scene, bit_depth));
  scene_ = scene;
  if (!file.empty()) off_bottom_ = off_bottom(scene_);
}

void InProcessRig::load_survey(const NewWell& well)
{
  const Turn turn(*this);
  const Scene scene = with_well(scene_, off_bottom_, well);
  build(scene);
  scene_ = scene;
}

void InProcessRig::tare()
{
  const Turn turn(*this);
  require_good();
  ask_tare(*simulator_);
}

Zero InProcessRig::tare_over(double duration)
{
  const Turn turn(*this);
  require_good();
  return ask_tare_over(*simulator_, duration);
}

void InProcessRig::fault(const std::string& name, bool clear, const std::string& target, double depth, double magnitude)
{
  const Turn turn(*this);
  require_good();
  const FaultKind kind = kind_named(name);
  if (!clear) require_only_what_applies(kind, target, depth, magnitude);
  ask_fault(*simulator_, fault_of(kind, target, depth, magnitude), clear);
}

void InProcessRig::slips(bool are_set)
{
  const Turn turn(*this);
  require_good();
  ask_slips(*simulator_, are_set);
}

void InProcessRig::slips_for(std::uint32_t joints, bool remove)
{
  const Turn turn(*this);
  require_good();
  ask_slips_for(*simulator_, joints, remove);
}

void InProcessRig::connection(std::uint32_t joints, bool remove)
{
  const Turn turn(*this);
  require_good();
  ask_connection(*simulator_, joints, remove);
}

void InProcessRig::operate(const std::string& operations)
{
  const Turn turn(*this);
  require_good();
  require_on_hook(*simulator_);
  const ScenePlayer player = operations_of(operations, "operations", present_scene(*simulator_));
  if (playing_) player_.hand_over(*simulator_, false);
  player_ = player;
  playing_ = true;
}

std::string InProcessRig::given_up() const
{
  const Turn turn(*this);
  return playing_ ? text_of(player_.operations().status().trouble) : "";
}

SavedRig InProcessRig::save() const
{
  const Turn turn(*this);
  if (failed_) throw std::runtime_error("the last frame failed: there is no good state to go on from");
  return {simulator_->save(), player_, playing_};
}

void InProcessRig::restore(const SavedRig& saved)
{
  const Turn turn(*this);
  if (finer_) throw std::runtime_error("a verified run cannot be reset or restored");
  if (!simulator_->restore(*saved.state)) throw std::runtime_error("the snapshot is of another rig");
  ++epoch_;
  player_ = saved.player;
  playing_ = saved.playing;
  failed_ = false;
}

}  // namespace drill_rig_sim
