// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/rig_node.h"

#include <memory>
#include <sstream>

#include "drill_rig_sim/hydraulics/mud_circuit.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/requests.h"

namespace drill_rig_sim
{
namespace
{
Scene checked_scene(const Parameters& parameters)
{
  Scene scene = read_scene(parameters.scene_file, parameters.settings);
  check_rate(parameters.rate, scene);
  return scene;
}

ros::NodeHandle on_queue(ros::CallbackQueue& queue)
{
  ros::NodeHandle node;
  node.setCallbackQueue(&queue);
  return node;
}
}  // namespace

RigNode::RigNode()
    : service_node_(on_queue(service_queue_)),
      parameters_(read_parameters(ros::NodeHandle("~"))),
      scene_(checked_scene(parameters_)),
      mailbox_(node_),
      loop_(parameters_, std::make_unique<Simulator>(scene_, parameters_.seed), mailbox_, ring_),
      operations_(service_node_, loop_),
      clock_(node_, service_node_, parameters_, [this](std::int64_t clock) { loop_.hear_clock(clock); }),
      followers_(node_, parameters_, [this](std::int64_t slowest) { loop_.hear_followers(slowest); }),
      publishing_(
          node_, parameters_, ring_, loop_.subscriptions(), [this] { loop_.refresh(); },
          [this](const FrameRecord& frame) { operations_.follow(frame); }, [this] { diagnostics_.publish(); }),
      diagnostics_(
          node_, [this] { return publishing_.last(); }, mailbox_.refusals(), mailbox_.senders(),
          [this] { return clock_.trouble(); }),
      services_(service_node_, parameters_, scene_, loop_, publishing_, followers_),
      spinner_(1),
      service_spinner_(2, &service_queue_)
{
  registering_.release();
  const std::string problem = try_realtime(parameters_.realtime);
  if (!problem.empty()) throw ParameterError("parameter ~" + problem);
  leave_core(parameters_.realtime.core);
  say_what_runs();
  publishing_.start();
  loop_.start();
  spinner_.start();
  service_spinner_.start();
}

void RigNode::say_what_runs()
{
  const Simulator& simulator = *loop_.rig().simulator;
  const SimulatorStatistics& rig = simulator.statistics();
  std::ostringstream steps, why;
  if (rig.step > 0.0)
    steps << "steps of " << rig.step << " s";
  else
    steps << "variable steps by a tolerance of " << scene_.numerics.tolerance;
  if (!simulator.choice().empty()) why << " (auto: " << simulator.choice() << ")";
  ROS_INFO_STREAM("scene " << scene_.name << ", level " << rig.level << why.str() << ", " << rig.nodes << " nodes, "
                           << steps.str() << ", rate " << parameters_.rate << " Hz, namespace " << node_.getNamespace());
  for (const std::string& remark : scene_.remarks) ROS_WARN_STREAM(remark);
  const std::string doubt =
      doubt_of_pressures(mud_circuit(scene_, build_mesh(scene_, scene_.start.bit_depth + scene_.start.block_height)));
  if (!doubt.empty()) ROS_WARN_STREAM("pressures: " << doubt);
  if (rig.tight) ROS_WARN_STREAM("assembly: " << text_of(*rig.tight));
  if (parameters_.publish_clock && !parameters_.use_sim_time)
    ROS_WARN("stamps are simulated time from 0, but /use_sim_time is not set: other nodes use wall time");
}

void RigNode::wait_for_shutdown()
{
  while (!ros::isShuttingDown()) ros::WallDuration(0.05).sleep();
  loop_.halt();
  ros::waitForShutdown();
}

RigNode::~RigNode()
{
  loop_.halt();
  service_spinner_.stop();
  spinner_.stop();
  loop_.join();
  publishing_.finish();
}

}  // namespace drill_rig_sim
