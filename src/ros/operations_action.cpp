// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/operations_action.h"

#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/ros/diagnostics_report.h"
#include "drill_rig_sim/sim/requests.h"
#include "step_request.h"

namespace drill_rig_sim
{
namespace
{
constexpr double feedback_period = 0.2;  // of simulated time [s]

constexpr char replaced[] = "another rig, well or saved state has taken the place of this one";

std::string finished(const OperationStatus& operation)
{
  const std::string hung_up = text_of(operation.hung_up);
  return (operation.count == 1 ? "1 operation is finished" : std::to_string(operation.count) + " operations are finished") +
         (hung_up.empty() ? "" : "; " + hung_up);
}

RunOperationsFeedback feedback_of(const OperationStatus& operation, const std::string& what, const Readings& readings)
{
  RunOperationsFeedback feedback;
  feedback.operation_number = static_cast<std::uint32_t>(operation.number);
  feedback.operation_count = static_cast<std::uint32_t>(operation.count);
  feedback.current_operation = what;
  feedback.operation_progress = operation.progress;
  feedback.bit_depth = readings.bit_depth;
  feedback.hole_depth = readings.hole_depth;
  return feedback;
}
}  // namespace

OperationsAction::OperationsAction(ros::NodeHandle& node, SimulationLoop& loop)
    : loop_(loop), server_(node, "run_operations", false)
{
  server_.registerGoalCallback([this] { begin(); });
  server_.registerPreemptCallback([this] { cancel(); });
  server_.start();
}

void OperationsAction::begin()
{
  const auto goal = server_.acceptNewGoal();
  try
  {
    ROS_INFO_STREAM("run_operations: " << start(goal->operations));
  }
  catch (const std::exception& error)
  {
    RunOperationsResult result;
    result.message = one_line(error.what());
    ROS_WARN_STREAM("run_operations refused: " << result.message);
    server_.setAborted(result, result.message);
  }
}

/// Reads and checks while the rig goes on, then gives it the player between two frames.
std::string OperationsAction::start(const std::string& operations)
{
  Scene present;
  std::uint32_t epoch = 0;
  const auto require_ready = [](SimulationLoop& loop)
  {
    require_good(loop.rig());
    require_on_hook(*loop.rig().simulator);
  };
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        require_ready(loop);
        present = present_scene(*loop.rig().simulator);
        epoch = loop.epoch();
      });
  const ScenePlayer player = operations_of(operations, "goal", present);
  RunOperationsFeedback begun;
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        require_ready(loop);
        if (loop.epoch() != epoch) throw std::runtime_error(replaced);
        began_ = last_ = loop.rig().simulator->truth().time;
        epoch_ = epoch;
        order_ = loop.play(player);
        const OperationStatus first = loop.rig().player.operations().status();
        begun = feedback_of(first, word_of(first.kind), loop.rig().simulator->readings());
      });
  server_.publishFeedback(begun);  // a client may wait for it before it lets time go on
  return std::to_string(player.operations().status().count) + " begin";
}

void OperationsAction::cancel()
{
  const std::uint32_t order = order_.exchange(0);
  if (order == 0) return;  // it has just ended
  loop_.between_frames(
      [&](SimulationLoop& loop)
      {
        loop.stop_playing(order);
        if (loop.epoch() == epoch_) last_ = loop.rig().simulator->truth().time;
      });
  RunOperationsResult result;
  result.message = "cancelled";
  result.duration = last_ - began_;
  server_.setPreempted(result, result.message);
}

void OperationsAction::end(bool success, const std::string& message)
{
  if (order_.exchange(0) == 0) return;  // cancelled
  RunOperationsResult result;
  result.success = success;
  result.message = message;
  result.duration = last_ - began_;
  if (success)
    server_.setSucceeded(result, message);
  else
    server_.setAborted(result, message);
}

void OperationsAction::follow(const FrameRecord& frame)
{
  const std::uint32_t order = order_;
  if (order == 0) return;
  if (frame.epoch > epoch_) return end(false, replaced);
  if (frame.order != order) return;  // of a frame before it began
  const double now = frame.truth.time;
  last_ = now;
  if (frame.run_state == RunState::failed) return end(false, std::string("a frame failed: ") + frame.failure.data());
  if (!frame.playing) return end(false, "a command on a topic has taken over the rig");
  const OperationStatus& operation = frame.operation;
  if (operation.trouble != OperationTrouble::none) return end(false, trouble_of(operation));
  if (operation.number == 0) return end(true, finished(operation));
  if (operation.number != told_number_ || std::abs(now - told_at_) >= feedback_period) give_feedback(frame);
}

void OperationsAction::give_feedback(const FrameRecord& frame)
{
  told_number_ = frame.operation.number;
  told_at_ = frame.truth.time;
  server_.publishFeedback(feedback_of(frame.operation, what_is_done(frame), frame.readings));
}

}  // namespace drill_rig_sim
