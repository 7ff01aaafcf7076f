#include "drill_rig_sim/ros/services.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/ros/survey_request.h"
#include "drill_rig_sim/scene/read_scene.h"

namespace drill_rig_sim
{
namespace
{
// Says why a request is refused.
class Refusal : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

std::string one_line(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void require_obeyed(const CommandResult& result)
{
  if (result.outcome == CommandResult::Outcome::refused) throw Refusal(result.reason);
}
}  // namespace

Services::Services(ros::NodeHandle& node, const Parameters& parameters, Scene scene, SimulationLoop& loop,
                   PublishingThread& publishing, FrameRing& ring)
    : parameters_(parameters), scene_(std::move(scene)), running_(scene_), loop_(loop), publishing_(publishing), ring_(ring)
{
  using std_srvs::SetBool;
  using std_srvs::Trigger;
  const auto not_yet = [](const auto&, auto&) -> std::string { throw Refusal("not available yet"); };
  serve<ResetWell>(node, "reset_well", [this](const auto& q, auto&) { return reset_well(q); });
  serve<LoadSurvey>(node, "load_survey", [this](const auto& q, auto&) { return load_survey(q); });
  serve<Trigger>(node, "pause", [this](const auto&, auto&) { return pause(); });
  serve<Trigger>(node, "resume", [this](const auto&, auto&) { return resume(); });
  serve<Trigger>(node, "tare", [this](const auto&, auto&) { return tare(); });
  serve<SetSpeed>(node, "set_speed", [this](const auto& q, auto&) { return set_speed(q.speed); });
  serve<SaveState>(node, "save_state", [this](const auto& q, auto&) { return save_state(q); });
  serve<RestoreState>(node, "restore_state", [this](const auto& q, auto&) { return restore_state(q); });
  serve<InjectFault>(node, "inject_fault", [this](const auto& q, auto&) { return inject_fault(q); });
  serve<SetBool>(node, "set_slips", not_yet);
  serve<MakeConnection>(node, "make_connection", not_yet);
  serve<StepSimulation>(node, "step",
                        [this](const auto& q, auto& r)
                        {
                          step(q, r.state);
                          return std::string();
                        });
}

template <class Service, class Action>
void Services::serve(ros::NodeHandle& node, const std::string& name, Action action)
{
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  servers_.push_back(node.advertiseService<Request, Response>(name,
                                                              [this, name, action](Request& request, Response& response)
                                                              {
                                                                const std::lock_guard<std::mutex> lock(one_at_a_time_);
                                                                try
                                                                {
                                                                  response.message = action(request, response);
                                                                  response.success = true;
                                                                  if (!response.message.empty())
                                                                    ROS_INFO_STREAM(name << ": " << response.message);
                                                                }
                                                                catch (const std::exception& error)
                                                                {
                                                                  response.success = false;
                                                                  response.message = one_line(error.what());
                                                                  ROS_WARN_STREAM(name << " refused: " << response.message);
                                                                }
                                                                return true;
                                                              }));
}

void Services::rebuild(const Scene& scene)
{
  check_rate(parameters_.rate, scene);
  auto simulator = std::make_unique<Simulator>(scene, parameters_.seed);
  loop_.between_frames([&](SimulationLoop& loop) { simulator = loop.replace(std::move(simulator)); });
}

std::string Services::reset_well(const ResetWell::Request& request)
{
  const Scene scene = request.scene.empty() ? scene_ : read_scene(find_scene(request.scene));
  Scene next = scene;
  if (!(request.bit_depth >= 0.0 && request.bit_depth <= scene.well.hole_depth))
    throw Refusal("bit_depth is " + std::to_string(request.bit_depth) +
                  "; allowed is 0 (as the scene says) to the hole's depth, " + std::to_string(scene.well.hole_depth) + " m");
  if (request.bit_depth > 0.0) next.start.bit_depth = request.bit_depth;
  rebuild(next);
  // snapshots of the same rig stay good
  if (!request.scene.empty() || next.start.bit_depth != running_.start.bit_depth) saved_.clear();
  scene_ = scene;
  running_ = next;
  return "at the start of " + scene.name + ", bit at " + std::to_string(next.start.bit_depth) + " m";
}

std::string Services::load_survey(const LoadSurvey::Request& request)
{
  const Scene next = with_survey(scene_, request);
  rebuild(next);
  saved_.clear();
  scene_ = running_ = next;
  return "a well of " + std::to_string(next.well.survey.size()) + " stations, hole depth " +
         std::to_string(next.well.hole_depth) + " m, bit at " + std::to_string(next.start.bit_depth) + " m";
}

void Services::require_pausable() const
{
  if (loop_.time().follows()) throw Refusal("the time belongs to the rig that publishes /clock");
  if (loop_.time().in_lockstep()) throw Refusal("in lockstep time moves by the service step alone");
}

std::string Services::pause()
{
  require_pausable();
  loop_.between_frames([](SimulationLoop& loop) { loop.set_paused(true); });
  return "paused";
}

std::string Services::resume()
{
  require_pausable();
  bool failed = false;
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        failed = loop.rig().failed;
        if (!failed) loop.set_paused(false);
      });
  if (failed) throw Refusal("the last frame failed: reset_well or restore_state first");
  return "running";
}

std::string Services::tare()
{
  bool done = false;
  loop_.between_frames([&](SimulationLoop& loop) { done = loop.rig().simulator->tare(); });
  if (!done) throw Refusal("the bit is on bottom; allowed is off bottom");
  return "weight on bit and differential pressure read zero here";
}

std::string Services::set_speed(double speed)
{
  require_pausable();
  if (!(speed >= 0.0 && std::isfinite(speed)))
    throw Refusal("speed is " + std::to_string(speed) + "; allowed is a number >= 0, 0 = as fast as it goes");
  if (!loop_.time().has_own_clock() && speed != 1.0)
    throw Refusal("stamps are wall time (~publish_clock is false); allowed is 1");
  loop_.between_frames([=](SimulationLoop& loop) { loop.time().set_speed(speed, steady_now()); });
  return speed == 0.0 ? "as fast as it goes" : std::to_string(speed) + " simulated seconds per wall second";
}

std::string Services::save_state(const SaveState::Request& request)
{
  if (!request.file.empty()) throw Refusal("file: not available yet; allowed is a name alone");
  if (request.name.empty()) throw Refusal("name is empty; allowed is any other text");
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        const RunningRig& rig = loop.rig();
        if (rig.failed) throw Refusal("the last frame failed: there is no good state to go on from");
        saved_.insert_or_assign(request.name, Saved{rig.simulator->save(), rig.program, rig.playing});
      });
  return "saved as " + request.name;
}

std::string Services::restore_state(const RestoreState::Request& request)
{
  if (!request.file.empty()) throw Refusal("file: not available yet; allowed is a name alone");
  const auto found = saved_.find(request.name);
  if (found == saved_.end())
  {
    std::string names;
    for (const auto& entry : saved_) names += (names.empty() ? "" : ", ") + entry.first;
    throw Refusal("there is no state " + request.name + " of this rig; saved are: " + (names.empty() ? "none" : names));
  }
  loop_.between_frames([&](SimulationLoop& loop)
                       { loop.go_back(*found->second.state, found->second.program, found->second.playing); });
  return "restored " + request.name;
}

std::string Services::inject_fault(const InjectFault::Request& request)
{
  if (request.fault != InjectFault::Request::STUCK_PIPE) throw Refusal("not available yet; allowed is STUCK_PIPE");
  bool stuck = true;
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        Simulator& simulator = *loop.rig().simulator;
        if (request.clear)
          simulator.free_pipe();
        else
          stuck = simulator.stick_pipe(request.depth);
      });
  if (!stuck) throw Refusal("depth is " + std::to_string(request.depth) + "; allowed is a depth where there is pipe in the hole");
  return request.clear ? "the pipe is free" : "the pipe is stuck at " + std::to_string(request.depth) + " m";
}

void Services::command_all(const StepSimulation::Request& request)
{
  if (request.winch.size() > 1 || request.top_drive.size() > 1 || request.mud_pump.size() > 1)
    throw Refusal("allowed is no or one command of a kind");
  if (!request.steering.empty()) throw Refusal("steering: not available yet");
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        RunningRig& rig = loop.rig();
        if (rig.failed) throw Refusal("the last frame failed: reset_well or restore_state first");
        const bool may_be_half_done = request.winch.size() + request.top_drive.size() + request.mud_pump.size() > 1;
        const auto before = may_be_half_done ? rig.simulator->save() : nullptr;
        const auto accepted = rig.accepted;
        try
        {
          for (const auto& c : request.winch) require_obeyed(loop.take(to_setpoint(c)));
          for (const auto& c : request.top_drive) require_obeyed(loop.take(to_setpoint(c)));
          for (const auto& c : request.mud_pump) require_obeyed(loop.take(to_setpoint(c)));
        }
        catch (const Refusal&)
        {
          if (before) rig.simulator->restore(*before);  // refused whole
          rig.accepted = accepted;
          throw;
        }
      });
}

void Services::step(const StepSimulation::Request& request, RigState& state)
{
  if (!loop_.time().in_lockstep()) throw Refusal("allowed in lockstep alone (~clock)");
  command_all(request);
  const bool complete = loop_.step(request.frames);
  std::uint64_t handed_over = 0;
  loop_.between_frames([&](SimulationLoop&) { handed_over = ring_.handed_over(); });
  publishing_.wait_until_published(handed_over);
  const FrameRecord last = publishing_.last();
  state = to_rig_state(last, parameters_.frame_prefix + "rig_floor");
  if (!complete)
    throw Refusal(last.failure[0] != '\0' ? std::string("a frame failed: ") + last.failure.data() : "the node is shutting down");
}

}  // namespace drill_rig_sim
