// SPDX-License-Identifier: BSD-3-Clause
// A controller in C++: the front page's autodriller (launch/autodriller.py) as a node with parameters. It follows rig_state and
// commands winch and top drive.
#include <drill_rig_sim/RigState.h>
#include <drill_rig_sim/TopDriveCommand.h>
#include <drill_rig_sim/WinchCommand.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <cstdint>

namespace
{
constexpr double settling = 8.0;  // on the way down, until the hook load rings no more: then the weight is zeroed [s]

/// Turns the string, lowers the bit, and feeds the block ever faster while weight is missing and slower while there is too much.
class WeightHolder
{
public:
  WeightHolder()
      : weight_(parameter("weight", 10e3)),
        most_feed_(parameter("most_feed", 0.015)),
        gain_(parameter("gain", 5e-7)),
        tag_speed_(parameter("tag_speed", 0.01)),
        winch_(rig_.advertise<drill_rig_sim::WinchCommand>("winch/command", 1, true)),
        top_drive_(rig_.advertise<drill_rig_sim::TopDriveCommand>("top_drive/command", 1, true)),
        tare_(rig_.serviceClient<std_srvs::Trigger>("tare")),
        states_(rig_.subscribe("rig_state", 1, &WeightHolder::take, this, ros::TransportHints().tcpNoDelay()))
  {
    turn_.mode = drill_rig_sim::TopDriveCommand::SPEED;
    turn_.speed = parameter("speed", 9.4);
  }

private:
  static double parameter(const std::string& name, double otherwise) { return ros::NodeHandle("~").param(name, otherwise); }

  void take(const drill_rig_sim::RigState& state)
  {
    const ros::Time now = state.header.stamp;
    if (began_.isZero() || now < last_ || state.epoch != epoch_) begin(state);
    const double elapsed = (now - last_).toSec();
    last_ = now;
    if (!is_zeroed_ && (now - began_).toSec() > settling) is_zeroed_ = zero();
    if (is_zeroed_) feed_ = std::clamp(feed_ + gain_ * (weight_ - state.surface_wob) * elapsed, 0.0, most_feed_);
    drill_rig_sim::WinchCommand down;
    down.block_velocity = -feed_;
    winch_.publish(down);
  }

  /// With the first state of a run: the node or the well was begun anew, or a snapshot restored, and the weight has another zero.
  void begin(const drill_rig_sim::RigState& state)
  {
    began_ = last_ = state.header.stamp;
    epoch_ = state.epoch;
    feed_ = std::min(tag_speed_, most_feed_);
    is_zeroed_ = false;
    top_drive_.publish(turn_);
  }

  bool zero()
  {
    std_srvs::Trigger request;
    if (tare_.call(request) && request.response.success) return true;
    ROS_WARN_STREAM_THROTTLE(1.0, "the weight on bit could not be zeroed: " << request.response.message);
    return false;
  }

  double weight_;      // wanted on bit [N]
  double most_feed_;   // [m/s]
  double gain_;        // [m/s per N s]
  double tag_speed_;   // of the block until there is weight [m/s]
  double feed_ = 0.0;  // of the block, downwards [m/s]
  drill_rig_sim::TopDriveCommand turn_;
  ros::NodeHandle rig_;
  ros::Publisher winch_, top_drive_;
  ros::ServiceClient tare_;
  ros::Subscriber states_;
  ros::Time began_, last_;
  std::uint32_t epoch_ = 0;  // of the last state
  bool is_zeroed_ = false;
};
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "weight_holder");
  ros::service::waitForService("tare");
  WeightHolder holder;
  ros::spin();
}
