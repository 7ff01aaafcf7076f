// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/run_bag.h"

#include <console_bridge/console.h>
#include <rosbag/bag.h>
#include <std_msgs/String.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "drill_rig_sim/realtime/cadence.h"
#include "drill_rig_sim/ros/accuracy_message.h"
#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/ros/frame_messages.h"
#include "drill_rig_sim/ros/telemetry_news.h"
#include "drill_rig_sim/scene/write_scene.h"
#include "drill_rig_sim/sim/companion.h"

namespace drill_rig_sim
{
namespace
{
const std::string floor_name = "rig_floor";
}  // namespace

struct RunBag::Writer
{
  std::string file;
  std_msgs::String scene;
  std::unique_ptr<rosbag::Bag> bag = std::make_unique<rosbag::Bag>();
  FrameRecord frame, companion;  // of the companion: stamp and truth
  bool with_companion = false;
  bool begun = false;
  TelemetryNews news;
  Cadence accuracy_cadence{accuracy_rate};

  template <class Message>
  void write(const std::string& topic, const Message& message)
  {
    bag->write("/rig/" + topic, to_time(frame.stamp), message);
  }

  /// Runs `work`, which writes. A bag that could not is given up, never closed: its destructor would try again and end the
  /// program.
  template <class Work>
  void attempt(Work work)
  {
    try
    {
      work();
    }
    catch (const rosbag::BagException&)
    {
      static_cast<void>(bag.release());
      console_bridge::noOutputHandler();  // the class_loader of Debian 13 would warn of the bag's plug-in when the program ends
      throw std::runtime_error(file + " could not be written completely; is the disk full?");
    }
  }

  void close()
  {
    if (bag) attempt([this] { bag->close(); });
  }

  void take(const Simulator& simulator)
  {
    frame.truth = simulator.truth();
    frame.readings = simulator.readings();
    frame.faults = simulator.active_faults();
    frame.fault_depths = simulator.fault_depths();
    frame.physics.accuracy = simulator.statistics().accuracy;
    frame.stamp = std::llround(1e9 * frame.truth.time);
  }

  /// What does not change in a run.
  void write_start(const RigSpec& rig)
  {
    write("scene", scene);
    write("rig_limits", to_rig_limits(rig, to_header(frame.stamp, floor_name)));
  }

  /// Topics behind `prefix`.
  void write_truth(const std::string& prefix, const FrameRecord& from)
  {
    write(prefix + "truth/rig_state", to_rig_truth(from.truth, from, floor_name));
    write(prefix + "truth/bit", to_bit_truth(from, floor_name));
  }

  void write_companion(const Truth& truth)
  {
    companion.stamp = frame.stamp;
    companion.truth = truth;
    write_truth("companion/", companion);
  }

  void write_measurements()
  {
    write("hook_load", to_number(frame.readings.hook_load));
    write("torque", to_number(frame.readings.torque));
    write("rig_state", to_rig_state(frame.readings, frame, floor_name));
    write_truth("", frame);
    write("joint_states", to_joint_states(frame));
    write("bit/pose", to_bit_pose(frame, floor_name));
    write("bit/twist", to_bit_twist(frame, floor_name));
    write("bit/wrench", to_bit_wrench(frame, floor_name));
  }

  void write_accuracy(const Simulator& simulator)
  {
    if (!accuracy_cadence.due(frame.stamp)) return;
    frame.physics = simulator.statistics();
    frame.accuracy = accuracy_with_statistics(simulator);
    Accuracy message = to_accuracy(frame, floor_name);
    // a bag is the same wherever it is made: what depends on the speed of the companion's thread is left out
    message.companion = frame.physics.companion.level;
    message.cost_share = std::numeric_limits<double>::quiet_NaN();
    write("accuracy", message);
  }

  void write_telemetry()
  {
    news.tell(frame, floor_name, [this](const char* topic, const auto& message) { write(topic, message); });
  }
};

RunBag::RunBag(const std::string& file, const Scene& scene, bool with_companion) : writer_(std::make_unique<Writer>())
{
  writer_->with_companion = with_companion;
  writer_->file = file;
  writer_->scene.data = write_scene(scene);
  writer_->attempt([&] { writer_->bag->open(file, rosbag::bagmode::Write); });
}

RunBag::~RunBag()
{
  try
  {
    close();
  }
  catch (const std::runtime_error&)
  {
  }
}

void RunBag::add(const Simulator& simulator, bool due)
{
  Writer& w = *writer_;
  w.take(simulator);
  if (w.frame.stamp == 0) return;
  w.attempt(
      [&]
      {
        if (!w.begun) w.write_start(simulator.scene().rig);
        w.begun = true;
        if (due) w.write_measurements();
        w.write_accuracy(simulator);
        if (const Truth* companion = due && w.with_companion ? truth_of_companion(simulator) : nullptr)
          w.write_companion(*companion);
        w.write_telemetry();
      });
}

void RunBag::close()
{
  writer_->close();
}

}  // namespace drill_rig_sim
