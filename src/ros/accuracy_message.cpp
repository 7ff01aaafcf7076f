// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/accuracy_message.h"

#include <limits>

#include "drill_rig_sim/accuracy/output_difference.h"
#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
std::string text_of(const CompanionStatistics& companion)
{
  std::string text = companion.level;
  if (text.empty()) return text;
  text += ", " + std::to_string(companion.nodes) + " nodes";
  if (companion.coordinates > 0)
    text += ", " + std::to_string(companion.coordinates) + " coordinates";  // counted by its first frame
  return text;
}

std::string why_not_measured(const SimulatorStatistics& physics)
{
  if (physics.error_is_measured) return "";
  return *physics.not_measured ? physics.not_measured : "no frame has been compared yet";
}

double companion_cost_share(const SimulatorStatistics& physics) noexcept
{
  const double all = physics.costs.seconds() + physics.companion.seconds;
  return all > 0.0 ? physics.companion.seconds / all : 0.0;
}

Accuracy to_accuracy(const FrameRecord& frame, const std::string& floor)
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const SimulatorStatistics& p = frame.physics;
  Accuracy m;
  m.header = to_header(frame.stamp, floor);
  for (std::size_t i = 0; i < output_count; ++i)
  {
    m.outputs.push_back(output_traits[i].name);
    m.needed.push_back((frame.accuracy.needs & output_traits[i].need) != 0u);
    m.error.push_back(p.error_is_measured ? p.errors[i] : unknown);
    m.absolute.push_back(p.error_is_measured ? frame.accuracy.absolute_errors[i] : unknown);
    const StatisticDifferences& s = frame.accuracy.statistics[i];
    m.mean_error.push_back(p.error_is_measured ? s.mean : unknown);
    m.deviation_error.push_back(p.error_is_measured ? s.deviation : unknown);
    m.extremes_error.push_back(p.error_is_measured ? s.extremes : unknown);
    m.period_error.push_back(p.error_is_measured ? s.period : unknown);
  }
  m.window = difference_window;
  m.statistics_window = statistics_window;
  m.tolerance = frame.accuracy.tolerance;
  m.measured = p.error_is_measured;
  m.companion = text_of(p.companion);
  m.why_not_measured = why_not_measured(p);
  m.cost_share = companion_cost_share(p);
  return m;
}

}  // namespace drill_rig_sim
