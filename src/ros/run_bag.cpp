#include "drill_rig_sim/ros/run_bag.h"

#include <rosbag/bag.h>
#include <std_msgs/Float64.h>

#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/ros/frame_messages.h"
#include "drill_rig_sim/ros/telemetry_news.h"
#include "drill_rig_sim/sim/companion.h"

namespace drill_rig_sim
{
namespace
{
const std::string floor_name = "rig_floor";

std_msgs::Float64 number(double value)
{
  std_msgs::Float64 m;
  m.data = value;
  return m;
}
}  // namespace

struct RunBag::Writer
{
  std::string file;
  std::unique_ptr<rosbag::Bag> bag = std::make_unique<rosbag::Bag>();
  FrameRecord frame, companion;  // of the companion: stamp and truth
  bool begun = false;
  TelemetryNews news;

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
      throw std::runtime_error(file + " could not be written whole; is the disk full?");
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
    frame.stamp = std::llround(1e9 * frame.truth.time);
  }

  void write_limits(const RigSpec& rig)
  {
    std_msgs::Header header;
    header.stamp = to_time(frame.stamp);
    header.frame_id = floor_name;
    write("rig_limits", to_rig_limits(rig, header));
  }

  /// Topics behind `prefix`.
  void write_truth(const std::string& prefix, const FrameRecord& from)
  {
    write(prefix + "truth/rig_state", to_rig_state(from.truth, from, floor_name));
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
    write("hook_load", number(frame.readings.hook_load));
    write("torque", number(frame.readings.torque));
    write("rig_state", to_rig_state(frame.readings, frame, floor_name));
    write_truth("", frame);
    write("joint_states", to_joint_states(frame));
    write("bit/pose", to_bit_pose(frame, floor_name));
    write("bit/twist", to_bit_twist(frame, floor_name));
    write("bit/wrench", to_bit_wrench(frame, floor_name));
  }

  void write_telemetry()
  {
    news.tell(frame, floor_name, [this](const char* topic, const auto& message) { write(topic, message); });
  }
};

RunBag::RunBag(const std::string& file) : writer_(std::make_unique<Writer>())
{
  writer_->file = file;
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
        if (!w.begun) w.write_limits(simulator.scene().rig);
        w.begun = true;
        if (due) w.write_measurements();
        if (const Truth* companion = due ? truth_of_companion(simulator) : nullptr) w.write_companion(*companion);
        w.write_telemetry();
      });
}

void RunBag::close()
{
  writer_->close();
}

}  // namespace drill_rig_sim
