// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/parameters.h"

#include <ros/package.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

#include "drill_rig_sim/ros/own_time.h"

namespace drill_rig_sim
{
namespace
{
// Reads parameters one by one, remembers which names exist, and words every complaint alike.
class Reader
{
public:
  explicit Reader(const ros::NodeHandle& node) : node_(node) {}

  void number(const std::string& name, double& value, double low, double high, const std::string& allowed)
  {
    XmlRpc::XmlRpcValue raw;
    if (!find(name, raw)) return;
    if (!as_number(raw, value) || !(value >= low && value <= high)) refuse(name, raw, allowed);
  }

  void flag(const std::string& name, bool& value)
  {
    XmlRpc::XmlRpcValue raw;
    if (!find(name, raw)) return;
    if (raw.getType() != XmlRpc::XmlRpcValue::TypeBoolean) refuse(name, raw, "true or false");
    value = static_cast<bool>(raw);
  }

  void text(const std::string& name, std::string& value)
  {
    XmlRpc::XmlRpcValue raw;
    if (!find(name, raw)) return;
    if (raw.getType() != XmlRpc::XmlRpcValue::TypeString) refuse(name, raw, "text");
    value = static_cast<std::string>(raw);
  }

  /// `KEY=VALUE`, with ; between two of them.
  void settings(std::vector<std::string>& values)
  {
    std::string all;
    text("settings", all);
    std::istringstream parts(all);
    for (std::string part; std::getline(parts, part, ';');)
    {
      const std::size_t first = part.find_first_not_of(" \t\n");
      if (first == std::string::npos) continue;
      values.push_back(part.substr(first, part.find_last_not_of(" \t\n") + 1 - first));
    }
  }

  /// Names of command_kind_names, with commas between them.
  void command_kinds_of(const std::string& name, unsigned& kinds)
  {
    std::string all;
    text(name, all);
    std::istringstream parts(all);
    for (std::string part; std::getline(parts, part, ',');)
    {
      const std::size_t first = part.find_first_not_of(' ');
      const std::string kind = first == std::string::npos ? "" : part.substr(first, part.find_last_not_of(' ') + 1 - first);
      const auto* found = std::find(std::begin(command_kind_names), std::end(command_kind_names), kind);
      if (found == std::end(command_kind_names))
        refuse(name, all, "of winch, top_drive, mud_pump and steering, with commas between them");
      kinds |= 1u << (found - std::begin(command_kind_names));
    }
  }

  void frame_prefix(std::string& value)
  {
    text("frame_prefix", value);
    if (!value.empty() && (value.front() == '/' || value.find_first_of(" \t\n") != std::string::npos))
      refuse("frame_prefix", value, "text without white space that does not begin with / (not valid in tf2)");
  }

  template <class Enum>
  void choice(const std::string& name, Enum& value, const std::vector<std::string>& words)
  {
    XmlRpc::XmlRpcValue raw;
    if (!find(name, raw)) return;
    std::string allowed;
    for (std::size_t i = 0; i < words.size(); ++i)
    {
      allowed += (i == 0 ? "" : ", ") + words[i];
      if (raw.getType() != XmlRpc::XmlRpcValue::TypeString || static_cast<std::string>(raw) != words[i]) continue;
      value = static_cast<Enum>(i);
      return;
    }
    refuse(name, raw, "one of " + allowed);
  }

  void whole_number(const std::string& name, double& value, double most, const std::string& allowed = "a whole number >= 0",
                    double least = 0.0)
  {
    number(name, value, least, most, allowed);
    XmlRpc::XmlRpcValue raw;
    if (value != std::floor(value) && find(name, raw)) refuse(name, raw, allowed);
  }

  void numbers(const std::string& name, std::array<double, 6>& values, const std::string& allowed)
  {
    XmlRpc::XmlRpcValue raw;
    if (!find(name, raw)) return;
    if (raw.getType() != XmlRpc::XmlRpcValue::TypeArray || raw.size() != static_cast<int>(values.size()))
      refuse(name, raw, allowed);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!as_number(raw[static_cast<int>(i)], values[i]) || !std::isfinite(values[i])) refuse(name, raw, allowed);
  }

  // A name that nothing has asked for is a misspelt one.
  void refuse_unknown() const
  {
    std::vector<std::string> names;
    node_.getParamNames(names);
    const std::string own = node_.getNamespace() + "/";
    for (const std::string& name : names)
    {
      if (name.compare(0, own.size(), own) != 0 || known_.count(name.substr(own.size()))) continue;
      std::string allowed;
      for (const std::string& k : known_) allowed += (allowed.empty() ? "" : ", ") + k;
      throw ParameterError("parameter ~" + name.substr(own.size()) + " is unknown; allowed are " + allowed);
    }
  }

  [[noreturn]] static void refuse(const std::string& name, const XmlRpc::XmlRpcValue& raw, const std::string& allowed)
  {
    std::ostringstream value;
    raw.write(value);
    const bool text = raw.getType() == XmlRpc::XmlRpcValue::TypeString;
    throw ParameterError("parameter ~" + name + " is " + (text ? '"' + value.str() + '"' : value.str()) + "; allowed is " +
                         allowed);
  }

private:
  bool find(const std::string& name, XmlRpc::XmlRpcValue& raw)
  {
    known_.insert(name);
    return node_.getParam(name, raw);
  }

  static bool as_number(XmlRpc::XmlRpcValue& raw, double& value)
  {
    if (raw.getType() == XmlRpc::XmlRpcValue::TypeInt)
      value = static_cast<int>(raw);
    else if (raw.getType() == XmlRpc::XmlRpcValue::TypeDouble)
      value = static_cast<double>(raw);
    else
      return false;
    return true;
  }

  const ros::NodeHandle& node_;
  std::set<std::string> known_;
};

// A regular file: to open a pipe or a device may block.
bool readable(const std::string& file)
{
  std::error_code error;
  return std::filesystem::is_regular_file(file, error) && access(file.c_str(), R_OK) == 0;
}
}  // namespace

namespace
{
void read_realtime(Reader& read, RealtimeSpec& spec)
{
  double priority = spec.fifo_priority, core = spec.core;
  read.whole_number("realtime/fifo_priority", priority, 98.0, "a whole number from 0 to 98, 0 = off");
  read.flag("realtime/lock_memory", spec.lock_memory);
  read.whole_number("realtime/core", core, 4095.0, "a whole number from -1 on, -1 = any", -1.0);
  spec.fifo_priority = static_cast<int>(priority);
  spec.core = static_cast<int>(core);
}
}  // namespace

Parameters read_parameters(const ros::NodeHandle& node)
{
  Parameters p;
  Reader read(node);
  std::string scene = "bohai.yaml";
  double seed = 0.0;
  const std::string rate_range = "a number from 0.1 to 10000 [1/s]", display_range = "a number from 0.01 to 1000 [1/s]";
  read.text("scene", scene);
  read.settings(p.settings);
  read.number("rate", p.rate, 0.1, 1e4, rate_range);
  p.state_rate = p.rate;
  read.number("state_rate", p.state_rate, 0.01, p.rate, "a number from 0.01 to ~rate [1/s]");
  read.number("drillstring_rate", p.drillstring_rate, 0.01, p.rate, "a number from 0.01 to ~rate [1/s]");
  read.number("tf_rate", p.tf_rate, 0.01, 1000.0, display_range);
  read.number("marker_rate", p.marker_rate, 0.01, 1000.0, display_range);
  read.number("trajectory_rate", p.trajectory_rate, 0.01, 1.0, "a number from 0.01 to 1 [1/s]");
  read.number("command_timeout", p.command_timeout, 0.0, 1e9, "a number >= 0 [s], 0 = off");
  read.frame_prefix(p.frame_prefix);
  read.numbers("rig_pose", p.rig_pose, "a list of six finite numbers: x, y, z [m], roll, pitch, yaw [rad]");
  read.whole_number("seed", seed, 9e15);
  read.flag("play_program", p.play_program);
  read.choice("clock", p.clock, {"realtime", "lockstep", "free_run"});
  read.command_kinds_of("step_on_commands", p.step_on_commands);
  read.flag("publish_clock", p.publish_clock);
  read.number("lateral_exaggeration", p.lateral_exaggeration, 1.0, 1e4, "a number from 1 to 10000");
  read.number("force_scale", p.force_scale, 0.0, 1e3, "a number >= 0 [m/N]");
  read.choice("color_by", p.color_by, {"contact_force", "tension", "torque", "bending_moment"});
  read_realtime(read, p.realtime);
  read.refuse_unknown();

  p.seed = static_cast<std::uint64_t>(seed);
  if (p.step_on_commands != 0 && p.clock != ClockMode::lockstep)
    throw ParameterError("parameter ~step_on_commands: allowed only with ~clock lockstep");
  p.use_sim_time = simulated_time();
  if (!p.publish_clock && p.clock != ClockMode::realtime)
    throw ParameterError("parameter ~clock must be realtime where ~publish_clock is false: another node publishes /clock");
  try
  {
    p.scene_file = find_scene(scene);
  }
  catch (const ParameterError& error)
  {
    throw ParameterError(std::string("parameter ~") + error.what());
  }
  return p;
}

std::string find_file(const std::string& what, const std::string& name, const std::string& folder_of_relative)
{
  std::string file = name;
  const std::string scheme = "package://";
  if (name.compare(0, scheme.size(), scheme) == 0)
  {
    const std::size_t slash = name.find('/', scheme.size());
    const std::string package = name.substr(scheme.size(), slash - scheme.size());
    const std::string folder = ros::package::getPath(package);
    if (folder.empty() || slash == std::string::npos)
      throw ParameterError(what + " is " + name + "; allowed is package://PACKAGE/FILE with a package that exists");
    file = folder + name.substr(slash);
  }
  else if (name.empty() || name.front() != '/')
  {
    file = ros::package::getPath("drill_rig_sim") + "/" + folder_of_relative + "/" + name;
  }
  if (name.empty() || !readable(file))
    throw ParameterError(what + " is " + name +
                         "; allowed is a regular file that can be read, absolute, package://PACKAGE/FILE, " + "or relative to " +
                         folder_of_relative + " (tried " + file + ")");
  return file;
}

std::string find_scene(const std::string& name)
{
  return find_file("scene", name, "config/scenes");
}

}  // namespace drill_rig_sim
