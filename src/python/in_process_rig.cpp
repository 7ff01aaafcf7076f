#include "in_process_rig.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/requests.h"
#include "drill_rig_sim/sim/run.h"
#include "drill_rig_sim/sim/simulator_state.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t most_frames = 100000;  // of one call, as of the service step

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

void require_few(std::size_t frames)
{
  if (frames > most_frames) throw std::runtime_error("frames is " + std::to_string(frames) + "; allowed is 0 to " + std::to_string(most_frames));
}

Signals signals_of(const RigSignals& signals, const OperationStatus& operation)
{
  return {signals, operation.number, operation.progress, operation.kind};
}

Bit bit_of(const Truth& t)
{
  return {{t.bit_position.x(), t.bit_position.y(), t.bit_position.z()}, t.wob, t.bit_torque, t.bit_speed, t.bit_inclination, t.bit_azimuth, t.bend_toolface};
}

template <class Reading>
std::optional<Reading> if_any(const Reading& reading)
{
  return reading.sequence > 0 ? std::optional<Reading>(reading) : std::nullopt;
}

FaultKind kind_named(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* found = std::find(std::begin(fault_names), std::end(fault_names), name);
  if (found == std::end(fault_names)) throw std::runtime_error("fault is " + name + "; allowed are those of InjectFault");
  return static_cast<FaultKind>(found - fault_names);
}
}  // namespace

std::string Signals::current_operation() const
{
  if (signals.crew != CrewTask::none) return text_of(signals.crew);
  return operation_number > 0 ? word_of(operation_kind) : "";
}

InProcessRig::InProcessRig(const std::string& scene_file, double rate, std::uint64_t seed, bool play)
    : scene_(read_scene(scene_file)), off_bottom_(off_bottom(scene_)), rate_(rate), seed_(seed), play_(play)
{
  build(scene_);
}

void InProcessRig::build(const Scene& scene)
{
  check_rate(rate_, scene);
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
  require_good();
  require(*simulator_, winch);
  require(*simulator_, top_drive);
  require(*simulator_, pump);
  require(*simulator_, steering);
  const bool any = take(*simulator_, winch) | take(*simulator_, top_drive) | take(*simulator_, pump) | take(*simulator_, steering);
  if (any) playing_ = false;
}

bool InProcessRig::one_frame() noexcept
{
  failed_ = play_frame(*simulator_, playing_ ? &player_ : nullptr, 1.0 / rate_) == FrameStatus::failed;
  return !failed_;
}

void InProcessRig::refuse_failure(std::size_t done, std::size_t frames) const
{
  throw std::runtime_error(std::string("a frame failed: ") + simulator_->failure() + " (" + std::to_string(done) + " of " + std::to_string(frames) +
                           " frames)");
}

void InProcessRig::advance(std::size_t frames)
{
  require_few(frames);
  require_good();
  for (std::size_t k = 0; k < frames; ++k)
    if (!one_frame()) refuse_failure(k, frames);
}

Frame InProcessRig::frame() const
{
  const OperationStatus operation = playing_ ? player_.operations().status() : OperationStatus();
  return {signals_of(simulator_->readings(), operation), signals_of(simulator_->truth(), operation), bit_of(simulator_->truth())};
}

Recording InProcessRig::record(std::size_t frames, std::size_t every)
{
  require_few(frames);
  require_good();
  if (every == 0) throw std::runtime_error("every is 0; allowed is a number of frames above 0");
  Recording r;
  for (std::size_t k = 1; k <= frames; ++k)
  {
    if (!one_frame()) refuse_failure(k - 1, frames);
    if (k % every != 0 && k != frames) continue;
    const Frame f = frame();
    r.readings.push_back(f.readings);
    r.truth.push_back(f.truth);
    r.bit.push_back(f.bit);
  }
  return r;
}

std::optional<ToolfaceReading> InProcessRig::toolface() const
{
  return if_any(simulator_->readings().toolface);
}

std::optional<MwdReading> InProcessRig::survey() const
{
  return if_any(simulator_->readings().mwd);
}

void InProcessRig::reset(const std::string& file, double bit_depth)
{
  const Scene scene = file.empty() ? scene_ : read_scene(file);
  build(with_bit_depth(scene, bit_depth));
  scene_ = scene;
  if (!file.empty()) off_bottom_ = off_bottom(scene_);
}

void InProcessRig::load_survey(const NewWell& well)
{
  const Scene scene = with_well(scene_, off_bottom_, well);
  build(scene);
  scene_ = scene;
}

void InProcessRig::tare()
{
  require_good();
  ask_tare(*simulator_);
}

void InProcessRig::fault(const std::string& name, bool clear, const std::string& target, double depth, double magnitude)
{
  require_good();
  ask_fault(*simulator_, fault_of(kind_named(name), target, depth, magnitude), clear);
}

void InProcessRig::slips(bool are_set)
{
  require_good();
  ask_slips(*simulator_, are_set);
}

void InProcessRig::connection(std::uint32_t joints, bool remove)
{
  require_good();
  ask_connection(*simulator_, joints, remove);
}

SavedRig InProcessRig::save() const
{
  if (failed_) throw std::runtime_error("the last frame failed: there is no good state to go on from");
  return {simulator_->save(), player_, playing_};
}

void InProcessRig::restore(const SavedRig& saved)
{
  if (!simulator_->restore(*saved.state)) throw std::runtime_error("the snapshot is of another rig");
  player_ = saved.player;
  playing_ = saved.playing;
  failed_ = false;
}

}  // namespace drill_rig_sim
