// SPDX-License-Identifier: BSD-3-Clause
#include "drill_feed.h"

#include <cmath>

#include "drill_rig_sim/well/formation.h"

namespace drill_rig_sim
{
namespace
{
// at least, where its end is known: of drill [s]
double shortest_time(const Operation& o)
{
  if (!std::isnan(o.time)) return o.time;
  return std::isnan(o.distance) ? FeedLimits::counts : o.distance / o.speed;
}

bool is_known(const Scene& scene)
{
  for (const PartSpec& part : scene.string)
    if (part.type == PartType::mud_motor || (part.bit && part.bit->torque.model != BitTorqueModel::stribeck)) return false;
  return true;
}
}  // namespace

std::vector<SlowFeed> slow_feeds(const Scene& scene, double tvd)
{
  std::vector<SlowFeed> found;
  if (!is_known(scene)) return found;
  const FormationLayer& rock = layer_at(scene.formation, tvd);
  double rotary_speed = 0.0;
  for (std::size_t i = 0; i < scene.operations.size(); ++i)
  {
    const Operation& o = scene.operations[i];
    if (o.kind == OperationKind::rotate) rotary_speed = o.rotary_speed;
    const double coefficient = drilling_coefficient(rock, rotary_speed);
    if (o.kind != OperationKind::drill || !(coefficient > 0.0) || shortest_time(o) < FeedLimits::counts) continue;
    const double weight = rock.threshold + std::pow(o.speed / coefficient, 1.0 / rock.weight_exponent);
    if (weight < FeedLimits::low * o.weight) found.push_back({i, weight});
  }
  return found;
}

std::string feed_limit_text(std::size_t operation, const Operation& o, const char* limits, double weight, double duration,
                            const Printed& printed)
{
  const Printed::InSI kilonewton{"%.1f", "kN", 1e-3};
  std::string text = "operations: number " + std::to_string(operation + 1) + ", " + word_of(o.kind) + ": its speed of " +
                     printed(o.speed, Dimension::speed, {"%.4g", "m/s"}) + " " + limits + " the weight on bit to " +
                     printed(weight, Dimension::force, kilonewton);
  if (duration > 0.0) text += " for " + std::to_string(std::lround(duration)) + " s";
  return text + " (weight: " + printed(o.weight, Dimension::force, kilonewton) + "); needed for more: a larger speed";
}

}  // namespace drill_rig_sim
