// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/diagnostics_publisher.h"

#include <utility>

#include "drill_rig_sim/math/semaphore.h"

namespace drill_rig_sim
{
DiagnosticsPublisher::DiagnosticsPublisher(ros::NodeHandle& node, std::function<FrameRecord()> last, const Refusals& refusals,
                                           const CommandSenders& senders, std::function<std::string()> clock_trouble)
    : last_(std::move(last)),
      refusals_(refusals),
      senders_(senders),
      clock_trouble_(std::move(clock_trouble)),
      report_(ros::this_node::getName().substr(1)),
      diagnostics_(node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10)),
      timer_(node.createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { publish(); }))
{
}

void DiagnosticsPublisher::publish()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const FrameRecord frame = last_();
  const std::string trouble = trouble_of(frame.operation);
  if (trouble != trouble_ && !trouble.empty()) ROS_ERROR_STREAM(trouble);
  trouble_ = trouble;
  const std::string hung_up = text_of(frame.operation.hung_up);
  if (hung_up != hung_up_ && !hung_up.empty()) ROS_WARN_STREAM("operations: " << hung_up);
  hung_up_ = hung_up;
  diagnostics_.publish(report_.on(frame, refusals_, clock_trouble_(), steady_now(), senders_.trouble(ros::SteadyTime::now())));
}

}  // namespace drill_rig_sim
