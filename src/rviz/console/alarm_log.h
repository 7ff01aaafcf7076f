// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_ALARM_LOG_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_ALARM_LOG_H

#include <vector>

#include "flags.h"

namespace drill_rig_sim::console
{
/// One flag from its begin to its end.
struct Alarm
{
  Flag flag;
  double from, to;  // simulated; `to` is the latest time known while it lasts [s]
  bool lasts;
  bool acknowledged;   // true from the start below level `alarm`
  bool ended = false;  // it was over for 10 s
};

/// The flags of a rig over time. A flag that comes back within 10 s is still the same alarm. A flag of level `alarm` stays in
/// `latched` until it is acknowledged, however short it was.
class AlarmLog
{
public:
  /// The flags at a time [s]. A time that went back (another well) forgets all. Returns what began now (`lasts`) and what is over
  /// for 10 s (`ended`).
  std::vector<Alarm> take(double time, const Flags& flags);
  /// All of them.
  void acknowledge();
  /// Alarms to be acknowledged, at most one of each flag, in the order of their begin.
  std::vector<Alarm> latched() const;

private:
  Alarm* find(Flag flag);
  void remove_old();

  std::vector<Alarm> alarms_;
  double time_ = 0.0;
};

}  // namespace drill_rig_sim::console

#endif
