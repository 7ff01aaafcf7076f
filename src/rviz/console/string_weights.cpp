// SPDX-License-Identifier: BSD-3-Clause
#include "string_weights.h"

#include <cmath>
#include <utility>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim::console
{
namespace
{
constexpr double moving = 0.02;                            // slowest block that counts as moving [m/s]
constexpr double turning = 2.0, still = 0.5;               // rotation that frees a string of friction; none [rad/s]
constexpr double even = 0.15;                              // share by which the speed of a steady move may differ
constexpr double off_bottom = 2.0;                         // [m]
constexpr double settles = 10.0, shortest = 5.0;           // [s]
constexpr double stretch = 0.5, stretch_per_depth = 1e-3;  // [m], [-]
constexpr double turns = 2.0, turns_per_depth = 3e-3;      // [-], [1/m]
constexpr double held = 1e4;                               // [N/m]
constexpr double between_readings = 5.0;                   // at most [s]
constexpr double near_enough = 100.0;                      // [m]
constexpr int least_readings = 4;

std::optional<Motion> motion_of(const MoveReading& now)
{
  if (now.in_slips || !(now.hole_depth - now.bit_depth > off_bottom)) return {};
  const double rotation = std::abs(now.rotation);
  if (rotation < still && now.block_velocity > moving) return Motion::pick_up;
  if (rotation < still && now.block_velocity < -moving) return Motion::slack_off;
  if (rotation > turning && std::abs(now.block_velocity) < moving) return Motion::rotating;
  return {};
}

bool is_even(double value, double mean)
{
  return std::abs(value - mean) <= even * std::abs(mean);
}
}  // namespace

std::string text_of(const StringWeight& weight, UnitSystem system)
{
  constexpr const char* names[motion_count] = {"Pick-up", "Slack-off", "Rotating"};
  const auto shown = [system](double si, Dimension dimension)
  { return number_text(si, dimension, system) + " " + unit_of(dimension, system).name; };
  return std::string(names[static_cast<std::size_t>(weight.motion)]) + " weight " + shown(weight.load, Dimension::force) +
         " at " + shown(weight.depth, Dimension::length);
}

std::optional<StringWeight> StringWeights::take(const MoveReading& now)
{
  std::optional<StringWeight> ended;
  if (before_ && (now.time < before_->time || now.epoch != before_->epoch)) *this = {};
  if (before_ && now.time == before_->time) return {};
  const std::optional<Motion> motion = motion_of(now);
  if (move_ && (motion != move_->motion || !goes_on(*move_, now))) ended = end();
  if (!move_ && motion && !std::isnan(now.hook_load))
  {
    Move begun;
    begun.motion = *motion;
    begun.first = now;
    move_ = begun;
  }
  if (move_)
  {
    add(*move_, now);
    if (const auto weight = weight_of(*move_, now.time)) found_ = last_[static_cast<std::size_t>(weight->motion)] = weight;
  }
  before_ = now;
  return ended;
}

std::optional<StringWeight> StringWeights::near(Motion motion, double bit_depth) const
{
  const std::optional<StringWeight>& weight = last_[static_cast<std::size_t>(motion)];
  return weight && std::abs(weight->depth - bit_depth) <= near_enough ? weight : std::nullopt;
}

std::optional<StringWeight> StringWeights::end()
{
  move_.reset();
  return std::exchange(found_, {});
}

bool StringWeights::goes_on(const Move& move, const MoveReading& now) const
{
  if (now.time - before_->time > between_readings) return false;
  return move.motion == Motion::rotating ? is_even(std::abs(now.rotation), move.turning_sum / move.readings)
                                         : is_even(now.block_velocity, move.speed_sum / move.readings);
}

void StringWeights::add(Move& move, const MoveReading& now) const
{
  if (move.readings > 0) move.turned += std::abs(now.rotation) * (now.time - before_->time);
  move.speed_sum += now.block_velocity;
  move.turning_sum += std::abs(now.rotation);
  ++move.readings;
  const double way = std::abs(now.block_height - move.first.block_height), depth = move.first.bit_depth;
  const bool all_moves = move.motion == Motion::rotating ? move.turned >= 2.0 * pi * (turns + turns_per_depth * depth)
                                                         : way >= stretch + stretch_per_depth * depth;
  if (now.time - move.first.time < settles || !all_moves || std::isnan(now.hook_load)) return;
  if (std::isnan(move.since)) move.since = now.time;
  const double load = now.hook_load - move.first.hook_load;
  ++move.count;
  move.load += load;
  move.depth += now.bit_depth;
  move.way += way;
  move.way_squared += way * way;
  move.way_load += way * load;
}

std::optional<StringWeight> StringWeights::weight_of(const Move& move, double now)
{
  if (!(now - move.since >= shortest) || move.count < least_readings) return {};
  const double n = move.count, spread = move.way_squared - move.way * move.way / n;
  const double grows = (move.way_load - move.way * move.load / n) / spread;  // slope of the line of least squares [N/m]
  if (move.motion != Motion::rotating && !(std::abs(grows) <= held)) return {};
  return StringWeight{move.motion, move.first.hook_load + move.load / n, move.depth / n};
}

}  // namespace drill_rig_sim::console
