// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/rig/recorded_drum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drill_rig_sim
{
namespace
{
constexpr double standing_drum = 1e-3;  // by less, drum heights that are worked out from gauges differ while it stands [m]
constexpr int slips_tried = 40;

/// A row's gauges.
struct GaugeRow
{
  const HoistingSpec& spec;
  bool dead_line;
  double block_height;  // [m]
  double reading;       // of the hook load [N]

  /// On the lines, with the sheaves' friction built up to `slip` [N].
  double load(double slip) const noexcept
  {
    return reading / (dead_line ? dead_line_hook_load(1.0, slip, spec.sheaves, spec.sheave_efficiency) : 1.0);
  }
  double drum(double slip) const noexcept { return unloaded_height(spec, block_height, load(slip)); }
};

/// After a row.
struct RecordedDrum
{
  double stood = 0.0;  // where it was last known to move to [m]
  double slip = 0.0;   // of the sheaves
  double load = 0.0;   // on the lines [N]
};

/// The slip that agrees with what it makes the drum do since `before`, and leaves the load nearest to what it was.
double agreeing_slip(const GaugeRow& row, const RecordedDrum& before) noexcept
{
  double found = before.slip, least = std::numeric_limits<double>::infinity(), last = 0.0, last_off = 0.0;
  for (int k = 0; k <= slips_tried; ++k)
  {
    const double slip = -1.0 + 2.0 * k / slips_tried, off = slip - sheave_slip(before.slip, row.drum(slip) - before.stood);
    const bool crosses = k > 0 && off * last_off < 0.0;
    const double candidate = crosses ? last - (slip - last) * last_off / (off - last_off) : slip;
    const double change = std::abs(row.load(candidate) - before.load);
    if ((crosses || off == 0.0) && change < least)
    {
      least = change;
      found = candidate;
    }
    last = slip;
    last_off = off;
  }
  return found;
}
}  // namespace

double unloaded_height(const HoistingSpec& spec, double block_height, double hook_load) noexcept
{
  return spec.crown_height - (line_length_for(spec, block_height, hook_load) - spec.fixed_length) / (2.0 * spec.sheaves);
}

std::vector<double> drum_heights(const HoistingSpec& spec, bool dead_line, const std::vector<double>& heights,
                                 const std::vector<double>& hook_loads)
{
  std::vector<double> out;
  RecordedDrum drum;
  for (std::size_t k = 0; k < heights.size(); ++k)
  {
    const GaugeRow row{spec, dead_line, heights[k], hook_loads[k]};
    if (k == 0) drum.stood = row.drum(drum.slip);
    if (std::abs(row.drum(drum.slip) - drum.stood) > standing_drum)
    {
      if (dead_line) drum.slip = agreeing_slip(row, drum);
      drum.stood = row.drum(drum.slip);
    }
    drum.load = row.load(drum.slip);
    out.push_back(row.drum(drum.slip));
  }
  return out;
}

}  // namespace drill_rig_sim
