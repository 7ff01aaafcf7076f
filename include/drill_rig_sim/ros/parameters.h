// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_PARAMETERS_H
#define DRILL_RIG_SIM_ROS_PARAMETERS_H

#include <ros/ros.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "drill_rig_sim/realtime/threads.h"
#include "drill_rig_sim/realtime/timekeeper.h"
#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// A parameter that cannot be used: what() is one line with its name, its value and what is allowed.
class ParameterError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// What the string is coloured by.
enum class ColorQuantity
{
  contact_force,
  tension,
  torque,
  bending_moment
};

constexpr std::uint32_t most_frames_of_step = 100000;  ///< of one call of the service step

/// The node's private parameters.
struct Parameters
{
  std::string scene_file;             ///< absolute
  std::vector<std::string> settings;  ///< of every scene that is read, as read_scene() takes them
  double rate = 100.0;                ///< frames per simulated second
  double state_rate = 100.0;          ///< per simulated second; as `rate` unless set
  double drillstring_rate = 10.0;     ///< per simulated second
  double tf_rate = 30.0;              ///< per wall second
  double marker_rate = 5.0;           ///< per wall second
  double trajectory_rate = 1.0;       ///< per wall second
  double command_timeout = 0.0;       ///< simulated [s]; 0 = off
  std::string frame_prefix;
  std::array<double, 6> rig_pose{};  ///< of the rig floor in `world`: x, y, z [m], roll, pitch, yaw [rad]
  std::uint64_t seed = 0;
  bool play_program = false;
  ClockMode clock = ClockMode::realtime;
  unsigned step_on_commands = 0;  ///< lockstep: kinds of commands, a sum of bit_of(CommandKind), that make the rig go on to its
                                  ///< next rig_state; 0: it goes on by the service
  bool publish_clock = true;
  bool use_sim_time = false;  ///< the global /use_sim_time
  double lateral_exaggeration = 50.0;
  ColorQuantity color_by = ColorQuantity::contact_force;
  RealtimeSpec realtime;
  double force_scale = 5e-3;  ///< length of a contact force's arrow [m/N]

  TimeSource time_source() const noexcept
  {
    if (publish_clock) return TimeSource::own;
    return use_sim_time ? TimeSource::other_rig : TimeSource::wall;
  }
  /// Of a topic's messages [messages]: in lockstep, also of a rig that follows another's clock, none of a step is lost to a slow
  /// subscriber; else a second's frames, so that what a busy machine catches up on (Timekeeper::most_backlog) is not lost either.
  std::uint32_t queue() const noexcept
  {
    const bool by_steps = clock == ClockMode::lockstep || time_source() == TimeSource::other_rig;
    return by_steps ? most_frames_of_step : std::max(10u, static_cast<std::uint32_t>(std::ceil(rate)));
  }
  /// Between two messages of rig_state.
  std::uint32_t frames_of_state() const noexcept
  {
    return static_cast<std::uint32_t>(std::max(1.0, std::round(rate / state_rate)));
  }
  std::string floor() const { return frame_prefix + "rig_floor"; }                 ///< frame of all that is measured
  std::int64_t frame_period() const noexcept { return std::llround(1e9 / rate); }  ///< simulated [ns]
};

/// Reads and checks the private parameters of `node`. Throws ParameterError.
Parameters read_parameters(const ros::NodeHandle& node);

/// Absolute path of a file that a parameter or a request names: absolute, package://PACKAGE/..., or relative to a folder of this
/// package. Throws ParameterError, which begins with `what`, where the package or the file is not found.
std::string find_file(const std::string& what, const std::string& name, const std::string& folder_of_relative);

/// The same of a scene, in config/scenes.
std::string find_scene(const std::string& name);

}  // namespace drill_rig_sim

#endif
