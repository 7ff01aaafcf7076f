// SPDX-License-Identifier: BSD-3-Clause
#include "join_depths.h"

#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr double rounding = 1e-6;  // [m]

void join(double& depth, double with)
{
  if (std::abs(depth - with) <= rounding) depth = with;
}
}  // namespace

void join_depths(Scene& scene)
{
  WellSpec& well = scene.well;
  if (!well.survey.empty()) join(well.hole_depth, well.survey.back().md);
  if (!well.sections.empty()) join(well.sections.back().to, well.hole_depth);
  join(scene.start.bit_depth, well.hole_depth);
}

}  // namespace drill_rig_sim
