// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/services.h"

#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/ros/frame_messages.h"
#include "drill_rig_sim/ros/rig_description.h"
#include "drill_rig_sim/ros/robot_description.h"
#include "drill_rig_sim/ros/survey_request.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/scene_hash.h"
#include "drill_rig_sim/scene/write_scene.h"
#include "drill_rig_sim/sim/requests.h"
#include "fault_request.h"
#include "step_request.h"

namespace drill_rig_sim
{
namespace
{
void require_name_or_file(const std::string& name, const std::string& file)
{
  if (!file.empty() && !name.empty()) throw Refusal("name and file are both given; allowed is one of them");
}

std::string written(double number)
{
  std::ostringstream out;
  out << number;
  return out.str();
}

// what is to be said of how a scene's files were read, behind an answer
std::string remarks_of(const Scene& scene)
{
  std::string text;
  for (const std::string& remark : scene.remarks) text += "; " + remark;
  return text;
}
}  // namespace

Services::Services(ros::NodeHandle& node, const Parameters& parameters, Scene scene, SimulationLoop& loop,
                   PublishingThread& publishing, FollowerWatch& followers)
    : node_(node),
      parameters_(parameters),
      scene_(std::move(scene)),
      off_bottom_(off_bottom(scene_)),
      running_(scene_),
      loop_(loop),
      publishing_(publishing),
      followers_(followers),
      description_(node.advertise<RigDescription>("rig_description", 1, true)),
      scene_text_(node.advertise<std_msgs::String>("scene", 1, true))
{
  using std_srvs::SetBool;
  using std_srvs::Trigger;
  serve<ResetWell>(node, "reset_well", [this](const auto& q, auto&, Lock&) { return reset_well(q); });
  serve<LoadSurvey>(node, "load_survey", [this](const auto& q, auto&, Lock&) { return load_survey(q); });
  serve<Trigger>(node, "pause", [this](const auto&, auto&, Lock&) { return pause(); });
  serve<Trigger>(node, "resume", [this](const auto&, auto&, Lock&) { return resume(); });
  serve<Trigger>(node, "tare", [this](const auto&, auto&, Lock&) { return tare(); });
  serve<TareOver>(node, "tare_over", [this](const auto& q, auto& r, Lock&) { return tare_over(q, r); });
  serve<SetSpeed>(node, "set_speed", [this](const auto& q, auto&, Lock&) { return set_speed(q.speed); });
  serve<SaveState>(node, "save_state", [this](const auto& q, auto&, Lock&) { return save_state(q); });
  serve<RestoreState>(node, "restore_state", [this](const auto& q, auto&, Lock&) { return restore_state(q); });
  serve<ListStates>(node, "list_states", [this](const auto&, auto& r, Lock&) { return list_states(r); });
  serve<DeleteState>(node, "delete_state", [this](const auto& q, auto&, Lock&) { return delete_state(q.name); });
  serve<InjectFault>(node, "inject_fault", [this](const auto& q, auto&, Lock&) { return inject_fault(q); });
  serve<SetBool>(node, "set_slips", [this](const auto& q, auto&, Lock&) { return set_slips(q.data); });
  serve<MakeConnection>(node, "make_connection", [this](const auto& q, auto&, Lock&) { return make_connection(q); });
  serve<StepSimulation>(node, "step", [this](const auto& q, auto& r, Lock& lock) { return step(q, r, lock); });
  describe(scene_, loop_.time().stamp());  // the node is built before its loop starts
}

template <class Service, class Action>
void Services::serve(ros::NodeHandle& node, const std::string& name, Action action)
{
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const auto answer = [this, name, action](Request& request, Response& response)
  {
    Lock lock(one_at_a_time_);
    try
    {
      response.message = one_line(action(request, response, lock));
      response.success = true;
      if (!response.message.empty()) ROS_INFO_STREAM(name << ": " << response.message);
    }
    catch (const std::exception& error)
    {
      response.success = false;
      response.message = one_line(error.what());
      ROS_WARN_STREAM(name << " refused: " << response.message);
    }
    return true;
  };
  servers_.push_back(node.advertiseService<Request, Response>(name, answer));
}

void Services::require_no_step() const
{
  if (step_under_way_) throw Refusal("a step is under way; pause ends it");
}

void Services::rebuild(const Scene& scene)
{
  check_rate(parameters_.rate, scene);
  auto simulator = std::make_unique<Simulator>(scene, parameters_.seed);
  std::int64_t stamp = 0;
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        simulator = loop.replace(std::move(simulator));
        stamp = loop.time().stamp();
      });
  describe(scene, stamp);
}

void Services::describe(const Scene& scene, std::int64_t stamp) const
{
  description_.publish(to_rig_description(scene, to_header(stamp, parameters_.floor())));
  Scene played = scene;
  if (!parameters_.play_program)
  {
    played.program.clear();
    played.operations.clear();
  }
  std_msgs::String text;
  text.data = write_scene(played);
  scene_text_.publish(text);
  // a master that has gone would be waited for
  if (ros::master::check()) node_.setParam("robot_description", robot_description(scene, parameters_.frame_prefix));
}

std::string Services::reset_well(const ResetWell::Request& request)
{
  require_no_step();
  const Scene scene = request.scene.empty() ? scene_ : read_scene(find_scene(request.scene), parameters_.settings);
  const Scene next = with_bit_depth(scene, request.bit_depth);
  rebuild(next);
  const std::string forgotten = forget_states_of_another(next);
  scene_ = scene;
  running_ = next;
  if (!request.scene.empty()) off_bottom_ = off_bottom(scene_);
  return "at the start of " + scene.name + ", bit at " + std::to_string(next.start.bit_depth) + " m" + forgotten +
         remarks_of(next);
}

std::string Services::load_survey(const LoadSurvey::Request& request)
{
  require_no_step();
  const Scene next = with_well(scene_, off_bottom_, to_new_well(request));
  rebuild(next);
  const std::string forgotten = forget_states_of_another(next);
  scene_ = running_ = next;
  return "a well of " + std::to_string(next.well.survey.size()) + " stations, hole depth " +
         std::to_string(next.well.hole_depth) + " m, bit at " + std::to_string(next.start.bit_depth) + " m" + forgotten +
         remarks_of(next);
}

std::string Services::forget_states_of_another(const Scene& next)
{
  if (saved_.count() == 0 || scene_hash(next) == scene_hash(running_)) return {};
  std::string said = "; saved states of the previous rig that were deleted: " + std::to_string(saved_.count());
  saved_.clear();
  return said;
}

void Services::require_pausable() const
{
  if (loop_.time().follows()) throw Refusal("time is controlled by the rig that publishes /clock");
  if (loop_.time().in_lockstep()) throw Refusal("in lockstep time moves only by the service step");
}

std::string Services::pause()
{
  if (loop_.time().in_lockstep())
  {
    bool ended = false;
    loop_.between_frames([&](SimulationLoop& loop) { ended = loop.end_step_early(); });
    followers_.give_up();
    if (!ended && !step_under_way_) throw Refusal("no step is under way, and in lockstep time moves only by the service step");
    return "the step is ended";
  }
  require_pausable();
  loop_.between_frames([](SimulationLoop& loop) { loop.set_paused(true); });
  return "paused";
}

std::string Services::resume()
{
  require_pausable();
  loop_.between_frames(
      [](SimulationLoop& loop)
      {
        require_good(loop.rig());
        loop.set_paused(false);
      });
  return "running";
}

std::string Services::tare()
{
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        require_good(loop.rig());
        ask_tare(*loop.rig().simulator);
        loop.hand_over_again();
      });
  return "weight on bit and differential pressure are zeroed";
}

std::string Services::tare_over(const TareOver::Request& request, TareOver::Response& response)
{
  Zero zero;
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        require_good(loop.rig());
        zero = ask_tare_over(*loop.rig().simulator, request.duration);
        loop.hand_over_again();
      });
  response.duration = zero.duration;
  response.hook_load = zero.hook_load;
  response.hook_load_deviation = zero.hook_load_deviation;
  response.stand_pipe_pressure = zero.stand_pipe_pressure;
  response.stand_pipe_pressure_deviation = zero.stand_pipe_pressure_deviation;
  return words_of(zero);
}

std::string Services::set_speed(double speed)
{
  require_pausable();
  constexpr double slowest = 1e-6;  // a frame in hours: below, time stands
  if (!(speed == 0.0 || (speed >= slowest && std::isfinite(speed))))
    throw Refusal("speed is " + written(speed) + "; allowed is 0 = as fast as possible, or a number >= " + written(slowest));
  if (!loop_.time().has_own_clock() && speed != 1.0)
    throw Refusal("speed must be 1: stamps are wall time (~publish_clock is false)");
  loop_.between_frames([=](SimulationLoop& loop) { loop.set_speed(speed); });
  return speed == 0.0 ? "as fast as possible" : std::to_string(speed) + " simulated seconds per wall second";
}

std::string Services::save_state(const SaveState::Request& request)
{
  require_name_or_file(request.name, request.file);
  Saved saved = present_state(true);
  if (!request.file.empty())
  {
    write_saved(request.file, saved);
    return "written to " + std::filesystem::absolute(request.file).string();
  }
  saved_.keep(request.name, std::move(saved));
  return "saved as " + request.name;
}

Saved Services::present_state(bool to_go_on_from)
{
  Saved saved;
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        const RunningRig& rig = loop.rig();
        if (to_go_on_from && rig.failed) throw Refusal("the last frame failed: there is no good state to go on from");
        saved = {rig.simulator->save(), rig.player, rig.playing, rig.commands, rig.simulator->statistics().kernel,
                 loop.time().stamp(),   0,          {}};
      });
  saved.start = scene_start(running_);
  return saved;
}

std::string Services::restore_state(const RestoreState::Request& request)
{
  require_no_step();
  require_name_or_file(request.name, request.file);
  const Saved saved = request.file.empty() ? saved_.find(request.name) : read_saved(request.file, present_state(false));
  Kernel kernel = saved.kernel;
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        if (!loop.go_back(*saved.state, *saved.player, saved.playing, saved.commands))
          throw Refusal("the state does not fit the scene: its string has another mesh");
        kernel = loop.rig().simulator->statistics().kernel;
      });
  std::string restored = "restored " + (request.file.empty() ? request.name : request.file);
  if (kernel == saved.kernel) return restored;
  return restored + ", saved with kernel " + name_of(saved.kernel) + ": results with kernel " + name_of(kernel) +
         " differ in rounding";
}

std::string Services::list_states(ListStates::Response& response)
{
  saved_.list(response);
  return {};
}

std::string Services::delete_state(const std::string& name)
{
  saved_.remove(name);
  return "deleted " + name;
}

std::string Services::inject_fault(const InjectFault::Request& request)
{
  const Fault fault = to_fault(request);
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        require_good(loop.rig());
        ask_fault(*loop.rig().simulator, fault, request.clear);
      });
  return said_of(fault, request.clear);
}

std::string Services::set_slips(bool set)
{
  bool pumps = false;
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        require_good(loop.rig());
        Simulator& simulator = *loop.rig().simulator;
        ask_slips(simulator, set);
        pumps = set && simulator.setpoints().pump.flow > 0.0;
        loop.hand_over_again();
      });
  return std::string(set ? "the slips are set" : "the slips are pulled") + (pumps ? "; the pump runs" : "");
}

std::string Services::make_connection(const MakeConnection::Request& request)
{
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        require_good(loop.rig());
        ask_connection(*loop.rig().simulator, request.joints, request.remove);
        loop.hand_over_again();
      });
  const std::string pipe = request.joints > 0 ? std::to_string(request.joints) + " joints" : "one stand";
  return (request.remove ? "removing " : "adding ") + pipe + "; current_operation shows when it is finished";
}

std::string Services::step(const StepSimulation::Request& request, StepSimulation::Response& answer, Lock& lock)
{
  const auto answer_last = [&]
  {
    FrameRecord last = publishing_.last();
    tell(last, parameters_.floor(), answer);
    return last;
  };
  answer_last();  // what is refused changes nothing
  if (!loop_.time().in_lockstep()) throw Refusal("allowed only in lockstep (~clock)");
  if (parameters_.step_on_commands != 0) throw Refusal("this node steps on commands (~step_on_commands)");
  require_no_step();
  const std::uint32_t frames = frames_of(request, parameters_.rate);
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        command_all(loop, request);
        loop.begin_step(frames);
      });
  step_under_way_ = true;
  lock.unlock();  // the other services answer meanwhile
  const StepResult result = loop_.wait_for_step();
  publishing_.wait_until_published(result.handed_over);
  const FrameRecord last = answer_last();
  const std::string late = result.end == StepResult::End::complete ? followers_.wait_for(last.stamp) : "";
  lock.lock();
  step_under_way_ = false;
  const std::string computed = " (" + std::to_string(result.frames) + " of " + std::to_string(frames) + " frames)";
  if (!late.empty()) throw Refusal("this rig's frames are computed, but " + late);
  switch (result.end)
  {
    case StepResult::End::complete:
      return {};
    case StepResult::End::failed:
      throw Refusal(std::string("a frame failed: ") + last.failure.data() + computed);
    case StepResult::End::ended_early:
      break;
    case StepResult::End::shut_down:
      throw Refusal("the node is shutting down" + computed);
  }
  throw Refusal("ended by pause" + computed);
}

}  // namespace drill_rig_sim
