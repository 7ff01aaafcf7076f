// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_CONNECTION_LOG_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_CONNECTION_LOG_H

#include <optional>

#include "quantities.h"

namespace drill_rig_sim::console
{
/// What a connection is known by, of one rig_state.
struct PipeWork
{
  double time;  // simulated [s]
  bool in_slips;
  int stand_count;
  bool drills;  // near bottom with a rate of penetration
};

/// One connection.
struct Connection
{
  int number;               // since the first reading
  double in_slips;          // [s]
  double weight_to_weight;  // from the end of drilling to its next begin [s]; NaN before it is known
};

/// Times of connections. Only slips with more stands behind them than before are one; pipe that is taken away belongs to a trip.
/// Drilling counts once it has lasted 3 s. After a gap of more than 5 s in the readings, the connection under way is not counted.
class ConnectionLog
{
public:
  /// Takes a reading, in order of time. Returns a connection when its slips are pulled, and once more when the bit drills again.
  std::optional<Connection> take(const PipeWork& now);

private:
  void begin(const PipeWork& now);
  std::optional<Connection> take_slips(const PipeWork& now);
  std::optional<Connection> take_drilling(const PipeWork& now);

  std::optional<PipeWork> last_;
  std::optional<Connection> open_;  // the bit does not drill yet
  int number_ = 0, stands_ = 0;
  double slips_since_ = missing, drills_since_ = missing, drilled_at_ = missing;
};

}  // namespace drill_rig_sim::console

#endif
