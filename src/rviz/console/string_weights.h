// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_STRING_WEIGHTS_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_STRING_WEIGHTS_H

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "quantities.h"

namespace drill_rig_sim::console
{
/// Moves of the string off bottom whose hook load is a weight of the string.
enum class Motion : std::size_t
{
  pick_up,
  slack_off,
  rotating,
  count
};
constexpr std::size_t motion_count = static_cast<std::size_t>(Motion::count);

/// The mean hook load of a steady move.
struct StringWeight
{
  Motion motion;
  double load;   // [N]
  double depth;  // mean of the bit's, measured [m]
};

/// "Pick-up weight 512.3 kN at 1520.00 m".
std::string text_of(const StringWeight& weight, UnitSystem system);

/// What shows a move, of one rig_state, in SI.
struct MoveReading
{
  double time;                          // simulated [s]
  double hook_load;                     // [N]; NaN in a drop-out
  double block_height, block_velocity;  // [m], + up [m/s]
  double rotation;                      // of the top drive [rad/s]
  double bit_depth, hole_depth;         // measured [m]
  bool in_slips;
  int epoch;  // of the run: another well
};

/// Finds pick-up, slack-off and rotating weights while they are shown, by the rules of `drill weights`
/// (src/python/field/moves.py): the bit is more than 2 m off bottom, block speed and rotation stay within 15 %. The first 10 s do
/// not count, nor the way until all of the string moves (0.5 m and 1/1000 of the depth), nor as many turns (2 and 3/1000 for each
/// metre). What remains must last 5 s. Unlike there, a pull whose load grows by more than 10 kN per metre of way is a string that
/// is held: no weight.
class StringWeights
{
public:
  /// Takes a reading, in order of time. Returns the weight of a move that has just ended.
  std::optional<StringWeight> take(const MoveReading& now);
  /// The last weight of this motion, of the move under way too, if it was measured within 100 m of this depth of the bit [m].
  std::optional<StringWeight> near(Motion motion, double bit_depth) const;

private:
  /// A move under way, and sums over its steady part.
  struct Move
  {
    Motion motion;
    MoveReading first;
    double speed_sum = 0.0, turning_sum = 0.0;  // over all its readings
    int readings = 0;
    double turned = 0.0;     // [rad]
    double since = missing;  // begin of the steady part [s]
    int count = 0;
    double load = 0.0, depth = 0.0, way = 0.0, way_squared = 0.0, way_load = 0.0;  // sums; load and way less those of `first`
  };

  std::optional<StringWeight> end();
  bool goes_on(const Move& move, const MoveReading& now) const;
  void add(Move& move, const MoveReading& now) const;
  static std::optional<StringWeight> weight_of(const Move& move, double now);

  std::array<std::optional<StringWeight>, motion_count> last_;
  std::optional<MoveReading> before_;
  std::optional<Move> move_;
  std::optional<StringWeight> found_;  // of the move under way
};

}  // namespace drill_rig_sim::console

#endif
