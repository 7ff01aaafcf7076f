#include "drill_rig_sim/string/mud.h"

#include <algorithm>

namespace drill_rig_sim
{
double confinement(double diameter, double hole_diameter) noexcept
{
  constexpr double most = 5.0;
  const double body = diameter * diameter, hole = hole_diameter * hole_diameter;
  const double room = std::max(hole - body, 0.0);
  return std::min((hole + body) / std::max(room, 1e-12 * body), most);
}

}  // namespace drill_rig_sim
