// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_TIMES_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_TIMES_H

#include <cstdio>
#include <string>

namespace drill_rig_sim
{
/// When a condition held in a run, with gaps or without [s].
struct Times
{
  explicit Times(double now) : since(now), until(now) {}

  /// It holds `now`. `before`: the frame before this one.
  void add(double now, double before)
  {
    if (until == before) lasted += now - before;
    until = now;
  }

  double since, until;
  double lasted = 0.0;
};

/// 2.0 to 5.0 s; with gaps: 1.2 s between 2.0 and 5.0 s.
inline std::string text_of(const Times& times)
{
  const bool gaps = times.lasted < times.until - times.since - 0.05;
  char text[96];
  if (gaps)
    std::snprintf(text, sizeof text, "%.1f s between %.1f and %.1f s", times.lasted, times.since, times.until);
  else
    std::snprintf(text, sizeof text, "%.1f to %.1f s", times.since, times.until);
  return text;
}

}  // namespace drill_rig_sim

#endif
