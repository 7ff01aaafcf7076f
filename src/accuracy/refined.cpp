// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/accuracy/refined.h"

namespace drill_rig_sim
{
NumericsSpec refined(NumericsSpec numerics, double times) noexcept
{
  numerics.refinement *= times;
  return numerics;
}

NumericsSpec with_free_nodes(NumericsSpec numerics) noexcept
{
  numerics.level = Level::beam3d;
  numerics.guided_element_length = numerics.free_length = 0.0;
  return numerics;
}

CompanionKind chosen_companion(const NumericsSpec& numerics) noexcept
{
  if (numerics.companion != CompanionKind::automatic) return numerics.companion;
  return numerics.level == Level::automatic && !has_no_levels(numerics.integrator) ? CompanionKind::coarser : CompanionKind::none;
}

const char* why_not_measured(const NumericsSpec& numerics) noexcept
{
  if (chosen_companion(numerics) != CompanionKind::none) return "";
  if (numerics.companion == CompanionKind::none) return "numerics.companion is none";
  return numerics.level == Level::automatic ? "the method of numerics.integrator has no companion"
                                            : "numerics.level is set by hand and numerics.companion is not";
}

}  // namespace drill_rig_sim
