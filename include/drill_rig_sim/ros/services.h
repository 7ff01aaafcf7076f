// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_SERVICES_H
#define DRILL_RIG_SIM_ROS_SERVICES_H

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <mutex>
#include <string>
#include <vector>

#include "drill_rig_sim/DeleteState.h"
#include "drill_rig_sim/InjectFault.h"
#include "drill_rig_sim/ListStates.h"
#include "drill_rig_sim/LoadSurvey.h"
#include "drill_rig_sim/MakeConnection.h"
#include "drill_rig_sim/ResetWell.h"
#include "drill_rig_sim/RestoreState.h"
#include "drill_rig_sim/SaveState.h"
#include "drill_rig_sim/SetSpeed.h"
#include "drill_rig_sim/TareOver.h"
#include "drill_rig_sim/StepSimulation.h"
#include "drill_rig_sim/ros/follower_watch.h"
#include "drill_rig_sim/ros/publishing_thread.h"
#include "drill_rig_sim/ros/saved_states.h"
#include "drill_rig_sim/ros/simulation_loop.h"

namespace drill_rig_sim
{
/// The node's services. One acts at a time, between two frames; whatever is refused changes nothing; no exception passes.
/// A new rig is built beside the running one and takes over only when it stands.
/// While a step runs the others answer: `pause` ends it, what would put another rig or state in its place is refused until then.
class Services
{
public:
  /// `node` answers on its own callback queue, so that a long step() holds up no command.
  Services(ros::NodeHandle& node, const Parameters& parameters, Scene scene, SimulationLoop& loop, PublishingThread& publishing,
           FollowerWatch& followers);

private:
  using Lock = std::unique_lock<std::mutex>;

  // Each returns the answer's message or throws with the reason for refusing.
  std::string reset_well(const ResetWell::Request& request);
  std::string load_survey(const LoadSurvey::Request& request);
  std::string pause();
  std::string resume();
  std::string tare();
  std::string tare_over(const TareOver::Request& request, TareOver::Response& response);
  std::string set_speed(double speed);
  std::string save_state(const SaveState::Request& request);
  Saved present_state(bool to_go_on_from);
  std::string restore_state(const RestoreState::Request& request);
  std::string list_states(ListStates::Response& response);
  std::string delete_state(const std::string& name);
  std::string inject_fault(const InjectFault::Request& request);
  std::string set_slips(bool set);
  std::string make_connection(const MakeConnection::Request& request);
  /// Gives `lock` free while the frames are computed.
  std::string step(const StepSimulation::Request& request, StepSimulation::Response& answer, Lock& lock);

  void rebuild(const Scene& scene);
  /// Publishes what the rig of `scene` is made of, and the scene itself, its program only where that is played; sets the
  /// parameter robot_description. `stamp`: of the rig's start [ns]
  void describe(const Scene& scene, std::int64_t stamp) const;
  /// Where `next` is another rig than the running one; what the answer says of it.
  std::string forget_states_of_another(const Scene& next);
  void require_pausable() const;
  void require_no_step() const;

  template <class Service, class Action>
  void serve(ros::NodeHandle& node, const std::string& name, Action action);

  ros::NodeHandle node_;
  const Parameters& parameters_;
  Scene scene_;        // what reset_well goes back to
  double off_bottom_;  // of the bit at the start of the scene file, whatever has been loaded since [m]
  Scene running_;      // scene_ with the bit depth asked for
  SimulationLoop& loop_;
  PublishingThread& publishing_;
  FollowerWatch& followers_;
  SavedStates saved_;  // of the running scene
  bool step_under_way_ = false;
  std::mutex one_at_a_time_;
  ros::Publisher description_, scene_text_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace drill_rig_sim

#endif
