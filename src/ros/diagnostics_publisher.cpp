#include "drill_rig_sim/ros/diagnostics_publisher.h"

#include <sstream>
#include <utility>

#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
namespace
{
using diagnostic_msgs::DiagnosticStatus;

template <class T>
void add(DiagnosticStatus& status, const std::string& key, const T& value)
{
  std::ostringstream text;
  text << value;
  diagnostic_msgs::KeyValue pair;
  pair.key = key;
  pair.value = text.str();
  status.values.push_back(pair);
}

const char* word(RunState state)
{
  switch (state)
  {
    case RunState::running:
      return "running";
    case RunState::paused:
      return "paused";
    case RunState::waiting:
      return "waiting for a step";
    case RunState::failed:
      break;
  }
  return "failed";
}

std::string histogram(const LoopStatistics& loop)
{
  std::ostringstream text;
  for (std::size_t i = 0; i < loop.frame_times.size(); ++i)
  {
    const bool last = i == LoopStatistics::bounds_ms.size();
    text << (i == 0 ? "" : ", ") << (last ? ">= " : "< ") << LoopStatistics::bounds_ms[last ? i - 1 : i]
         << " ms: " << loop.frame_times[i];
  }
  return text.str();
}
}  // namespace

DiagnosticsPublisher::DiagnosticsPublisher(ros::NodeHandle& node, std::function<FrameRecord()> last)
    : last_(std::move(last)),
      name_(ros::this_node::getName().substr(1)),
      factor_since_(ros::WallTime::now()),
      diagnostics_(node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10)),
      timer_(node.createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { publish(); }))
{
}

void DiagnosticsPublisher::publish()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const FrameRecord frame = last_();
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = to_time(frame.stamp);
  array.status = {time_status(frame), physics_status(frame), command_status(frame)};
  diagnostics_.publish(array);
}

DiagnosticStatus DiagnosticsPublisher::status(const std::string& part) const
{
  DiagnosticStatus s;
  s.name = name_ + ": " + part;
  s.hardware_id = name_;
  s.level = DiagnosticStatus::OK;
  return s;
}

double DiagnosticsPublisher::real_time_factor(const FrameRecord& frame)
{
  const ros::WallTime now = ros::WallTime::now();
  const double wall = (now - factor_since_).toSec();
  if (wall >= 0.5)
  {
    factor_ = 1e-9 * static_cast<double>(frame.stamp - factor_stamp_) / wall;
    factor_since_ = now;
    factor_stamp_ = frame.stamp;
  }
  return factor_;
}

DiagnosticStatus DiagnosticsPublisher::time_status(const FrameRecord& frame)
{
  DiagnosticStatus s = status("time");
  s.message = word(frame.run_state);
  const bool behind = frame.loop.dropped_seconds > dropped_before_;
  dropped_before_ = frame.loop.dropped_seconds;
  if (behind)
  {
    s.level = DiagnosticStatus::WARN;
    s.message += ", slower than asked";
  }
  add(s, "state", word(frame.run_state));
  add(s, "simulated_time", frame.measurements.time);
  add(s, "real_time_factor", real_time_factor(frame));
  add(s, "speed", frame.loop.speed);
  add(s, "overruns", frame.loop.overruns);
  add(s, "dropped_seconds", frame.loop.dropped_seconds);
  add(s, "unpublished_frames", frame.loop.unpublished_frames);
  add(s, "longest_frame_ms", 1e3 * frame.loop.longest_frame);
  add(s, "frame_times", histogram(frame.loop));
  return s;
}

DiagnosticStatus DiagnosticsPublisher::physics_status(const FrameRecord& frame) const
{
  DiagnosticStatus s = status("physics");
  const SimulatorStatistics& p = frame.physics;
  s.message = "solved";
  if (frame.run_state == RunState::failed)
  {
    s.level = DiagnosticStatus::ERROR;
    s.message = std::string("time stands at the last good state: ") + frame.failure.data();
  }
  add(s, "level", p.level);
  add(s, "integrator", p.integrator);
  add(s, "step", p.step);
  add(s, "nodes", p.nodes);
  add(s, "coordinates", p.coordinates);
  add(s, "frames", p.frames);
  add(s, "steps", p.steps);
  add(s, "newton_iterations", p.newton_iterations);
  add(s, "newton_iterations_per_step",
      p.steps > 0 ? static_cast<double>(p.newton_iterations) / static_cast<double>(p.steps) : 0.0);
  add(s, "convergence_failures", p.convergence_failures);
  add(s, "error_test_failures", p.error_test_failures);
  add(s, "error_estimate", p.last_error_estimate);
  return s;
}

DiagnosticStatus DiagnosticsPublisher::command_status(const FrameRecord& frame)
{
  DiagnosticStatus s = status("commands");
  const std::uint64_t refused = frame.physics.commands_refused;
  s.message = "obeyed";
  if (frame.measurements.commands_timed_out)
  {
    s.level = DiagnosticStatus::WARN;
    s.message = "the command stream stopped: brake set, drive coasts";
  }
  else if (refused > refused_before_)
  {
    s.level = DiagnosticStatus::WARN;
    s.message = std::string("refused: ") + frame.last_refusal;
  }
  refused_before_ = refused;
  add(s, "clamped", frame.physics.commands_clamped);
  add(s, "refused", refused);
  add(s, "last_refusal", frame.last_refusal);
  return s;
}

}  // namespace drill_rig_sim
