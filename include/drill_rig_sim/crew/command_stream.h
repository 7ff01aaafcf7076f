// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_COMMAND_STREAM_H
#define DRILL_RIG_SIM_CREW_COMMAND_STREAM_H

#include <algorithm>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
/// Tells a controller's stream of commands, whose silence means that the controller is lost, from orders that are given once and
/// stand until the next one: a driller's click, a `rostopic pub -1`.
class CommandStream
{
public:
  static constexpr int shortest = 4;  ///< commands, each within half the timeout after the one before

  /// A command has come at simulated time `now` [s]. True: it belongs to a stream.
  bool take(double now, double timeout) noexcept
  {
    const bool goes_on = now >= last_ && now - last_ <= 0.5 * timeout + time_rounding;
    count_ = goes_on ? std::min(count_ + 1, shortest) : 1;
    last_ = now;
    return count_ >= shortest;
  }

private:
  int count_ = 0;      // of commands in a row, up to `shortest`
  double last_ = 0.0;  // when the last one came [s]
};

}  // namespace drill_rig_sim

#endif
