// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_MAILBOX_H
#define DRILL_RIG_SIM_ROS_MAILBOX_H

#include <ros/ros.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <string>

#include "drill_rig_sim/MudPumpCommand.h"
#include "drill_rig_sim/SteeringCommand.h"
#include "drill_rig_sim/TopDriveCommand.h"
#include "drill_rig_sim/WinchCommand.h"
#include "drill_rig_sim/crew/commands.h"
#include "drill_rig_sim/math/semaphore.h"
#include "drill_rig_sim/realtime/triple_buffer.h"
#include "drill_rig_sim/ros/command_senders.h"
#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
/// The commands refused since the node began, by topic or by service. Any thread may count and ask.
class Refusals
{
public:
  /// `reason`: one line, static storage.
  void count(const char* reason) noexcept
  {
    last_ = reason;
    ++number_;
  }
  std::uint64_t number() const noexcept { return number_; }
  const char* last() const noexcept { return last_; }  ///< why the last one was; empty: there was none

private:
  std::atomic<const char*> last_{""};
  std::atomic<std::uint64_t> number_{0};
};

/// Receives the command topics and keeps the latest good one of each kind for the simulation thread; the others it refuses at
/// once.
class Mailbox
{
public:
  /// On the command topics of `node`.
  explicit Mailbox(ros::NodeHandle& node);
  /// On no topic: for callers of receive().
  Mailbox() = default;

  /// From any one thread: a command has come.
  void receive(const WinchCommand& m) noexcept { keep(to_setpoint(m), winch_, CommandKind::winch, m.header.stamp); }
  void receive(const TopDriveCommand& m) noexcept { keep(to_setpoint(m), top_drive_, CommandKind::top_drive, m.header.stamp); }
  void receive(const MudPumpCommand& m) noexcept { keep(to_setpoint(m), pump_, CommandKind::mud_pump, m.header.stamp); }
  void receive(const SteeringCommand& m) noexcept { keep(to_setpoint(m), steering_, CommandKind::steering, m.header.stamp); }

  /// For the simulation thread: the latest set point not taken yet, or null.
  const WinchSetpoint* winch() noexcept { return winch_.read(); }
  const TopDriveSetpoint* top_drive() noexcept { return top_drive_.read(); }
  const PumpSetpoint* pump() noexcept { return pump_.read(); }
  const SteeringSetpoint* steering() noexcept { return steering_.read(); }

  /// For the simulation thread: whether a command of each of these kinds, a sum of bit_of(), has come since the last time that
  /// this was so, stamped 0 or not before `stamp` [ns]: an older one answers an earlier state.
  bool answered(unsigned kinds, std::int64_t stamp) noexcept;
  /// What the simulation thread waits on; a refused command posts it, with `for_commands` each one that is kept too.
  Semaphore& bell() noexcept { return bell_; }
  void ring_for_commands(bool for_commands) noexcept { rings_ = for_commands; }

  /// Forgets what has not been taken yet; on the reader's side.
  void clear() noexcept;

  Refusals& refusals() noexcept { return refusals_; }
  const CommandSenders& senders() const noexcept { return senders_; }

private:
  template <class Setpoint>
  void keep(const Setpoint& c, TripleBuffer<Setpoint>& latest, CommandKind kind, const ros::Time& stamp) noexcept
  {
    if (const char* wrong = what_is_wrong(c))
    {
      refusals_.count(wrong);
      return bell_.post();  // rig_state reports it while time stands too
    }
    latest.write(c);
    come_[static_cast<std::size_t>(kind)] = stamp.isZero() ? unstamped : static_cast<std::int64_t>(stamp.toNSec());
    if (rings_) bell_.post();
  }
  template <class Command>
  ros::Subscriber subscribe(ros::NodeHandle& node, const std::string& topic);

  static constexpr std::int64_t none = -1, unstamped = std::numeric_limits<std::int64_t>::max();

  TripleBuffer<WinchSetpoint> winch_;
  TripleBuffer<TopDriveSetpoint> top_drive_;
  TripleBuffer<PumpSetpoint> pump_;
  TripleBuffer<SteeringSetpoint> steering_;
  Refusals refusals_;
  CommandSenders senders_;
  std::array<std::atomic<std::int64_t>, command_kinds> come_{none, none, none, none};  // stamps of what answered() has not taken
  std::atomic<bool> rings_{false};
  Semaphore bell_;
  ros::Subscriber subscribers_[4];
};

}  // namespace drill_rig_sim

#endif
