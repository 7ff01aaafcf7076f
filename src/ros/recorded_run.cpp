// SPDX-License-Identifier: BSD-3-Clause
// Runs in bags, to be played again.
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "drill_rig_sim/RigDescription.h"
#include "drill_rig_sim/RigTruth.h"
#include "drill_rig_sim/math/ends_with.h"
#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/ros/run_bag.h"

namespace drill_rig_sim
{
namespace
{
const std::string of_state = "truth/rig_state";
const std::string of_companion =
    "/companion/";  // ends what stands before the topics of a rig's companion, which is no rig of its own

std::string without_slashes(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of('/');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of('/') + 1 - begin);
}

/// What stands before the topics of the rig that is asked for.
std::string prefix_of(const rosbag::Bag& bag, const std::string& asked)
{
  std::set<std::string> found;
  rosbag::View all(bag);
  for (const rosbag::ConnectionInfo* connection : all.getConnections())
  {
    const std::string& topic = connection->topic;
    if (!ends_with(topic, "/" + of_state)) continue;
    const std::string prefix = topic.substr(0, topic.size() - of_state.size());
    if (ends_with(prefix, of_companion)) continue;
    if (asked.empty() || without_slashes(prefix) == without_slashes(asked)) found.insert(prefix);
  }
  if (found.empty())
    throw std::runtime_error("has no " + of_state + (asked.empty() ? "" : " in the namespace " + asked) +
                             ", which is needed to replay a run");
  if (found.size() == 1) return *found.begin();
  std::string names;
  for (const std::string& prefix : found) names += (names.empty() ? "" : ", ") + without_slashes(prefix);
  throw std::runtime_error("has several rigs, needed: --namespace with one of " + names);
}

template <class Message>
boost::shared_ptr<Message> read(const rosbag::MessageInstance& instance)
{
  boost::shared_ptr<Message> message = instance.instantiate<Message>();
  if (!message)
    throw std::runtime_error("was recorded by another version: " + instance.getDataType() + " of " + instance.getTopic() +
                             " has other fields; convert a bag of 0.2 with rosrun drill_rig_sim migrate_bag OLD.bag NEW.bag");
  return message;
}

RecordedRun::Row row_of(const RigTruth& state)
{
  RecordedRun::Row row;
  row.setpoints.winch = to_setpoint(state.winch);
  row.setpoints.top_drive = to_setpoint(state.top_drive);
  row.setpoints.pump = to_setpoint(state.mud_pump);
  row.setpoints.steering = to_setpoint(state.steering);
  row.commanded = !state.last_command.isZero();
  row.hook_load = state.hook_load;
  row.torque = state.torque;
  return row;
}

/// What the topics of a rig say, by stamps.
struct Topics
{
  std::string scene;
  std::optional<ros::Time> start;  // of a node's rig
  std::map<ros::Time, RecordedRun::Row> rows;
};

Topics topics_of(const rosbag::Bag& bag, const std::string& prefix)
{
  Topics topics;
  const std::string description = prefix + "rig_description", scene = prefix + "scene", state = prefix + of_state;
  rosbag::View view(bag, rosbag::TopicQuery(std::vector<std::string>{description, scene, state}));
  for (const rosbag::MessageInstance& message : view)
  {
    if (message.getTopic() == description) topics.start = read<RigDescription>(message)->header.stamp;
    if (message.getTopic() == scene) topics.scene = read<std_msgs::String>(message)->data;
    if (message.getTopic() != state) continue;
    const auto said = read<RigTruth>(message);
    topics.rows[said->header.stamp] = row_of(*said);
  }
  if (topics.start) topics.rows.erase(topics.rows.begin(), topics.rows.lower_bound(*topics.start));
  if (topics.rows.size() < 2)
    throw std::runtime_error(
        "has fewer than two rig states after its last start, needed: a run recorded from the start of the rig");
  return topics;
}

/// The stamp of the rig at its start: 0 in a bag of `drill run`; of a node that of its first state, which comes with the
/// description or a tick after it.
ros::Time stamp_of_start(const Topics& topics)
{
  if (!topics.start) return ros::Time();
  ros::Duration tick = ros::DURATION_MAX;
  for (auto row = topics.rows.begin(), next = std::next(row); next != topics.rows.end(); ++row, ++next)
    tick = std::min(tick, next->first - row->first);
  const ros::Time first = topics.rows.begin()->first;
  return first - *topics.start < tick * 1.5 ? first : *topics.start;
}

RecordedRun recorded_run(const Topics& topics)
{
  RecordedRun run;
  run.scene = topics.scene;
  const ros::Time start = stamp_of_start(topics);
  for (const auto& [stamp, row] : topics.rows)
  {
    run.rows.push_back(row);
    run.rows.back().time = (stamp - start).toSec();
  }
  return run;
}
}  // namespace

RecordedRun read_recorded_run(const std::string& file, const std::string& rig)
{
  try
  {
    const rosbag::Bag bag(file);
    return recorded_run(topics_of(bag, prefix_of(bag, rig)));
  }
  catch (const rosbag::BagException& error)
  {
    throw std::runtime_error(file + ": cannot be read as a bag: " + error.what());
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(file + ": " + error.what());
  }
}

}  // namespace drill_rig_sim
