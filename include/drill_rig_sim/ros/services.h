#ifndef DRILL_RIG_SIM_ROS_SERVICES_H
#define DRILL_RIG_SIM_ROS_SERVICES_H

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "drill_rig_sim/InjectFault.h"
#include "drill_rig_sim/LoadSurvey.h"
#include "drill_rig_sim/MakeConnection.h"
#include "drill_rig_sim/ResetWell.h"
#include "drill_rig_sim/RestoreState.h"
#include "drill_rig_sim/SaveState.h"
#include "drill_rig_sim/SetSpeed.h"
#include "drill_rig_sim/StepSimulation.h"
#include "drill_rig_sim/ros/publishing_thread.h"
#include "drill_rig_sim/ros/simulation_loop.h"

namespace drill_rig_sim
{
/// The node's services. One acts at a time, between two frames; whatever is refused changes nothing; no exception passes.
/// A new rig is built beside the running one and takes over only when it stands.
class Services
{
public:
  /// `node` answers on its own callback queue, so that a long step() holds up no command.
  Services(ros::NodeHandle& node, const Parameters& parameters, Scene scene, SimulationLoop& loop, PublishingThread& publishing,
           FrameRing& ring);

private:
  // A snapshot of the rig with what the node adds to it.
  struct Saved
  {
    std::shared_ptr<const SimulatorState> state;
    ProgramPlayer program;
    bool playing;
  };

  // Each returns the answer's message or throws with the reason for refusing.
  std::string reset_well(const ResetWell::Request& request);
  std::string load_survey(const LoadSurvey::Request& request);
  std::string pause();
  std::string resume();
  std::string tare();
  std::string set_speed(double speed);
  std::string save_state(const SaveState::Request& request);
  std::string restore_state(const RestoreState::Request& request);
  std::string inject_fault(const InjectFault::Request& request);
  void step(const StepSimulation::Request& request, RigState& state);

  void rebuild(const Scene& scene);
  void require_pausable() const;
  void command_all(const StepSimulation::Request& request);

  template <class Service, class Action>
  void serve(ros::NodeHandle& node, const std::string& name, Action action);

  const Parameters& parameters_;
  Scene scene_;    // what reset_well goes back to
  Scene running_;  // the same, with the bit depth asked for
  SimulationLoop& loop_;
  PublishingThread& publishing_;
  FrameRing& ring_;
  std::map<std::string, Saved> saved_;  // of the running scene
  std::mutex one_at_a_time_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace drill_rig_sim

#endif
