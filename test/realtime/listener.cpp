// SPDX-License-Identifier: BSD-3-Clause
// Subscribes to topics as they come, without looking into them but for the stamp, and tells at the end what came and which stamps
// are missing.
//   realtime_listener PERIOD_NS TOPIC[=OFFSET]...   OFFSET: of the stamp in the message [bytes]; a stamp each period, unless
//   there is none
// Prints `TOPIC RECEIVED MISSING` a line when it is interrupted.
#include <ros/ros.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <string>

namespace
{
/// Any message, of which the bytes are kept that may hold a stamp.
struct AnyMessage
{
  std::uint8_t head[16] = {};
};
}  // namespace

namespace ros
{
namespace message_traits
{
template <>
struct MD5Sum<AnyMessage>
{
  static const char* value() { return "*"; }
  static const char* value(const AnyMessage&) { return "*"; }
};
template <>
struct DataType<AnyMessage>
{
  static const char* value() { return "*"; }
  static const char* value(const AnyMessage&) { return "*"; }
};
}  // namespace message_traits
namespace serialization
{
template <>
struct Serializer<AnyMessage>
{
  template <class Stream>
  static void read(Stream& stream, AnyMessage& m)
  {
    const std::size_t size = std::min<std::size_t>(stream.getLength(), sizeof m.head);
    std::memcpy(m.head, stream.getData(), size);
    stream.advance(stream.getLength());
  }
};
}  // namespace serialization
}  // namespace ros

namespace
{
class Topic
{
public:
  Topic(ros::NodeHandle& node, const std::string& argument, std::int64_t period)
      : name_(argument.substr(0, argument.find('='))), period_(period)
  {
    if (name_ != argument) offset_ = std::atoi(argument.c_str() + name_.size() + 1);
    subscriber_ = node.subscribe<AnyMessage>(name_, 10000, [this](const boost::shared_ptr<AnyMessage const>& m) { take(*m); });
  }
  void tell() const { std::printf("%s %ld %ld\n", name_.c_str(), received_, missing_); }

private:
  void take(const AnyMessage& m)
  {
    ++received_;
    if (offset_ < 0) return;
    std::uint32_t parts[2];  // s, ns
    std::memcpy(parts, m.head + offset_, sizeof parts);
    const std::int64_t stamp = std::int64_t{1000000000} * parts[0] + parts[1];
    if (last_ != 0 && stamp > last_) missing_ += (stamp - last_) / period_ - 1;
    last_ = stamp;
  }

  std::string name_;
  std::int64_t period_, last_ = 0;
  int offset_ = -1;
  long received_ = 0, missing_ = 0;
  ros::Subscriber subscriber_;
};
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "realtime_listener", ros::init_options::AnonymousName);
  ros::NodeHandle node;
  std::deque<Topic> topics;
  for (int i = 2; i < argc; ++i) topics.emplace_back(node, argv[i], std::atoll(argv[1]));
  ros::spin();
  for (const Topic& topic : topics) topic.tell();
}
