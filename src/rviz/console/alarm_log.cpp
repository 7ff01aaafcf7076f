// SPDX-License-Identifier: BSD-3-Clause
#include "alarm_log.h"

#include <algorithm>
#include <iterator>

namespace drill_rig_sim::console
{
namespace
{
constexpr double again = 10.0;  // as on the page of drill web [s]
}

Alarm* AlarmLog::find(Flag flag)
{
  const auto found = std::find_if(alarms_.begin(), alarms_.end(), [flag](const Alarm& a) { return a.flag == flag; });
  return found == alarms_.end() ? nullptr : &*found;
}

void AlarmLog::remove_old()
{
  alarms_.erase(std::remove_if(alarms_.begin(), alarms_.end(), [](const Alarm& a) { return a.ended && a.acknowledged; }),
                alarms_.end());
}

std::vector<Alarm> AlarmLog::take(double time, const Flags& flags)
{
  std::vector<Alarm> changed;
  if (time < time_) alarms_.clear();
  time_ = time;
  for (const FlagRow& row : flag_rows())
  {
    const bool on = flags[static_cast<std::size_t>(row.flag)];
    Alarm* alarm = find(row.flag);
    if (alarm != nullptr && !alarm->ended && !(alarm->lasts && on) && time - alarm->to > again)
    {
      alarm->ended = true;
      alarm->lasts = false;
      changed.push_back(*alarm);
    }
    if (alarm != nullptr && !alarm->ended)
    {
      if (on) alarm->to = time;
      alarm->lasts = on;
      continue;
    }
    if (!on) continue;
    const Alarm begun{row.flag, time, time, true, row.level != Level::alarm};
    if (alarm != nullptr)
      *alarm = begun;
    else
      alarms_.push_back(begun);
    changed.push_back(begun);
  }
  remove_old();
  return changed;
}

void AlarmLog::acknowledge()
{
  for (Alarm& alarm : alarms_) alarm.acknowledged = true;
  remove_old();
}

std::vector<Alarm> AlarmLog::latched() const
{
  std::vector<Alarm> found;
  std::copy_if(alarms_.begin(), alarms_.end(), std::back_inserter(found), [](const Alarm& a) { return !a.acknowledged; });
  return found;
}

}  // namespace drill_rig_sim::console
