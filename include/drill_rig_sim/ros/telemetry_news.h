// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_TELEMETRY_NEWS_H
#define DRILL_RIG_SIM_ROS_TELEMETRY_NEWS_H

#include <array>
#include <cstdint>
#include <string>

#include "drill_rig_sim/ros/frame_messages.h"

namespace drill_rig_sim
{
/// What a frame brings from downhole that had not arrived before.
class TelemetryNews
{
public:
  /// Calls send(topic, message) for each reading that is new; `floor`: name of the frame `rig_floor`.
  template <class Send>
  void tell(const FrameRecord& frame, const std::string& floor, Send send)
  {
    const Sequences now = sequences_of(frame.readings);
    if (now[0] > last_[0]) send("downhole/mwd", to_mwd_survey(frame, floor));
    if (now[1] > last_[1]) send("downhole/toolface", to_mwd_toolface(frame, floor));
    if (now[2] > last_[2]) send("downhole/inclination", to_mwd_inclination(frame, floor));
    if (now[3] > last_[3]) send("downhole/dynamics", to_downhole_dynamics(frame, floor));
    last_ = now;
  }
  /// Another rig: all is new.
  void forget() noexcept { last_ = {}; }
  /// What these readings hold is not new.
  void skip(const Readings& readings) noexcept { last_ = sequences_of(readings); }

private:
  using Sequences = std::array<std::uint64_t, 4>;
  static Sequences sequences_of(const Readings& r) noexcept
  {
    return {r.mwd.sequence, r.toolface.sequence, r.inclination.sequence, r.dynamics.sequence};
  }

  Sequences last_{};
};

}  // namespace drill_rig_sim

#endif
