#include "drill_rig_sim/model/mast.h"

#include <algorithm>

namespace drill_rig_sim
{
void open_mast(ClosestPoint& closest) noexcept
{
  if (closest.segment != 0 || closest.md >= 0.0) return;
  const double opened = closest.radius - mast_opening * closest.md;
  const double inside = std::max(closest.radius, mast_radius);
  closest.radius_slope = opened < inside ? -mast_opening : 0.0;
  closest.radius = std::min(opened, inside);
}

}  // namespace drill_rig_sim
