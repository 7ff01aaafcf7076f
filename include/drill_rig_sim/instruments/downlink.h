// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_INSTRUMENTS_DOWNLINK_H
#define DRILL_RIG_SIM_INSTRUMENTS_DOWNLINK_H

#include <optional>

#include "drill_rig_sim/rig/setpoints.h"

namespace drill_rig_sim
{
/// How a rotary steerable tool is commanded from the surface: by the flow through it, which the driller lowers and raises.
///
/// A downlink is eleven bits of one length: a start bit 1, four bits of toolface in steps of 22.5 deg, four bits of ratio in
/// tenths (0 to 10), the most significant first, a parity bit that makes the number of ones of the eight even, a stop bit 0. 1:
/// the flow is lowered to less than `low` of what it was, but not stopped (0.3 of it); 0: as before. The tool looks at the middle
/// of each bit from where the flow fell; a downlink that is broken, has a wrong parity or a ratio above 10 is lost, and what was
/// in force stays. After a broken one the tool receives nothing for as long as one takes, so that its rest is no other one.
class DownlinkReceiver
{
public:
  static constexpr int bits = 11;
  static constexpr double low = 0.85, stopped = 0.3;            ///< of the flow before it
  static constexpr double toolface_step = 0.39269908169872414;  ///< 22.5 deg [rad]
  static constexpr double ratio_step = 0.1;

  /// What the tool receives at `time` [s]: `flow` through it [m3/s]; `bit_time` [s]. The command once it is complete.
  std::optional<SteeringSetpoint> hear(double time, double flow, double bit_time) noexcept;

  /// Bit `i` of a downlink, the start bit first: whether the flow is lowered. Of the nearest toolface and ratio that it can say.
  static bool is_low(const SteeringSetpoint& command, int i) noexcept;

  template <class V>
  void visit(V& v)
  {
    v("high", high_);
    v("began", began_);
    v("deaf_until", deaf_until_);
    v("heard", heard_);
    v("word", word_);
  }

private:
  std::optional<SteeringSetpoint> decode() const noexcept;

  double high_ = 0.0;        // flow between downlinks [m3/s]
  double began_ = 0.0;       // of the one under way [s]
  double deaf_until_ = 0.0;  // [s]
  int heard_ = -1;           // bits of it; -1: none is under way
  int word_ = 0;             // these bits
};

}  // namespace drill_rig_sim

#endif
