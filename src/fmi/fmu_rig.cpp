// SPDX-License-Identifier: BSD-3-Clause
#include "fmu_rig.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/write_scene.h"
#include "drill_rig_sim/sim/requests.h"
#include "drill_rig_sim/sim/run.h"

namespace drill_rig_sim::fmi
{
namespace
{
constexpr double longest_step = 3600.0;  // [s]

const Variable& variable(unsigned reference, std::initializer_list<VariableType> types)
{
  if (reference >= variables().size())
    throw std::runtime_error("value reference " + std::to_string(reference) + " is unknown: there are " +
                             std::to_string(variables().size()) + " variables");
  const Variable& v = variables()[reference];
  if (std::find(types.begin(), types.end(), v.type) == types.end())
    throw std::runtime_error(v.name + " is of another type than the function that was called");
  return v;
}

void check_value(const Variable& v, double value)
{
  if (!std::isfinite(value)) throw std::runtime_error(v.name + " must be a finite number");
  if (v.name == "seed" && value < 0.0)
    throw std::runtime_error("seed must be 0 or more (got " + std::to_string(static_cast<int>(value)) + ")");
  if (v.type == VariableType::drive_mode && !is_known(static_cast<TopDriveMode>(static_cast<int>(value))))
    throw std::runtime_error(v.name + " must be 0 to " + std::to_string(top_drive_mode_count - 1) + " (got " +
                             std::to_string(static_cast<int>(value)) + ")");
}

/// Whole frames of a step. Throws where they are not whole.
long frames_of(double duration, double rate)
{
  const double frames = duration * rate;
  if (std::isfinite(duration) && duration <= longest_step && frames > 0.5 &&
      std::abs(frames - std::round(frames)) < 1e-6 * frames)
    return std::lround(frames);
  std::ostringstream text;
  text << "the communication step must be a whole number of frames of " << 1.0 / rate << " s, at most " << longest_step
       << " s (got " << duration << " s)";
  throw std::runtime_error(text.str());
}
constexpr char scene_name[] = "/scene.yaml", rate_name[] = "/rate";

double read_rate(const std::string& file)
{
  double rate = 0.0;
  if (!(std::ifstream(file) >> rate)) throw std::runtime_error(file + ": must hold the frames a second");
  return rate;
}

void write(const std::string& file, const std::string& text)
{
  std::ofstream out(file);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(file + " could not be written whole; is the disk full?");
}
}  // namespace

void write_resources(const std::string& resources, const Scene& scene, double rate)
{
  write(resources + scene_name, write_scene(scene));
  std::ostringstream text;
  text << std::setprecision(17) << rate << "\n";
  write(resources + rate_name, text.str());
}

FmuRig::FmuRig(const std::string& scene_file, double rate) : scene_(read_scene(scene_file)), rate_(rate)
{
  reset();
}

FmuRig::FmuRig(const std::string& resources) : FmuRig(resources + scene_name, read_rate(resources + rate_name))
{
}

void FmuRig::reset()
{
  simulator_.reset();
  inputs_ = Inputs();
  inputs_.rate = rate_;
  inputs_.play_program = !scene_.program.empty() || !scene_.operations.empty();
  changed_.fill(false);
  tared_ = fixed_ = false;
  time_ = 0.0;
}

void FmuRig::build()
{
  check_rate(inputs_.rate, scene_);
  simulator_.emplace(scene_, static_cast<std::uint64_t>(inputs_.seed));
  player_ = ScenePlayer(simulator_->scene());
  playing_ = inputs_.play_program;
  built_by_parameters_ = true;
}

void FmuRig::begin_initialisation(double start)
{
  build();
  time_ = start;
}

void FmuRig::end_initialisation()
{
  rig();
  if (!built_by_parameters_) build();
  fixed_ = true;
}

const Simulator& FmuRig::rig() const
{
  if (!simulator_) throw std::runtime_error("outputs are known from the initialization mode on");
  return *simulator_;
}

void FmuRig::set(unsigned reference, std::initializer_list<VariableType> types, double value)
{
  const Variable& v = variable(reference, types);
  if (v.causality == Causality::output) throw std::runtime_error(v.name + " is an output and cannot be set");
  if (v.causality == Causality::parameter && fixed_)
    throw std::runtime_error(v.name + " is a parameter: it must be set before the initialization mode ends");
  check_value(v, value);
  if (v.get(inputs_) == value) return;
  v.set(inputs_, value);
  if (v.causality == Causality::parameter) built_by_parameters_ = false;
  if (v.is_setpoint) changed_[static_cast<std::size_t>(v.command)] = true;
}

double FmuRig::get(unsigned reference, std::initializer_list<VariableType> types) const
{
  const Variable& v = variable(reference, types);
  if (v.get != nullptr) return v.get(inputs_);
  const double value = v.in_truth != nullptr ? v.in_truth(rig().truth()) : v.in_readings(rig().readings());
  return std::isnan(value) ? 0.0 : value;
}

template <class Setpoint>
bool FmuRig::apply(CommandKind kind, const Setpoint& setpoint, std::vector<std::string>& refused)
{
  bool& changed = changed_[static_cast<std::size_t>(kind)];
  if (!changed) return false;
  if (const char* reason = why_refused(*simulator_, setpoint))
  {
    refused.push_back(std::string(command_kind_names[static_cast<int>(kind)]) + ": " + reason);
    return false;
  }
  simulator_->command(setpoint);
  changed = false;
  return true;
}

void FmuRig::apply_inputs(std::vector<std::string>& refused)
{
  const Setpoints& s = inputs_.setpoints;
  const bool of_winch = apply(CommandKind::winch, s.winch, refused);
  const bool any = of_winch | apply(CommandKind::top_drive, s.top_drive, refused) |
                   apply(CommandKind::mud_pump, s.pump, refused) | apply(CommandKind::steering, s.steering, refused);
  if (any && playing_)
  {
    player_.hand_over(*simulator_, of_winch);
    playing_ = false;
  }
  if (inputs_.tare && !tared_) tare(refused);
  tared_ = inputs_.tare;
}

void FmuRig::tare(std::vector<std::string>& refused)
{
  try
  {
    ask_tare(*simulator_);
  }
  catch (const std::runtime_error& error)
  {
    refused.push_back(std::string("tare: ") + error.what());
  }
}

std::vector<std::string> FmuRig::step(double now, double duration)
{
  rig();
  const long frames = frames_of(duration, inputs_.rate);
  if (!(std::abs(now - time_) < 1e-6 * std::max(1.0, std::abs(time_))))
  {
    std::ostringstream text;
    text << "the communication point must be " << time_ << " s, where the last step ended (got " << now << " s)";
    throw std::runtime_error(text.str());
  }
  std::vector<std::string> refused;
  apply_inputs(refused);
  for (long k = 0; k < frames; ++k)
    if (play_frame(*simulator_, playing_ ? &player_ : nullptr, 1.0 / inputs_.rate) == FrameStatus::failed)
      throw std::runtime_error(std::string("a frame failed: ") + simulator_->failure());
  time_ = now + duration;
  return refused;
}

FmuRig::Saved FmuRig::save() const
{
  return {rig().save(), player_, inputs_, changed_, playing_, tared_, time_};
}

void FmuRig::restore(const Saved& saved)
{
  rig();
  if (!simulator_->restore(*saved.state)) throw std::runtime_error("the state is of another rig");
  player_ = saved.player;
  inputs_ = saved.inputs;
  changed_ = saved.changed;
  playing_ = saved.playing;
  tared_ = saved.tared;
  time_ = saved.time;
}

}  // namespace drill_rig_sim::fmi
