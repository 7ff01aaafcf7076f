#include "drawn_rig.h"

namespace drill_rig_sim
{
Eigen::Vector3d DrawnRig::bit_face() const
{
  const DrawnNode& bit = nodes.front();
  return bit.position + string->from_bit.front() * bit.axis.tangent;
}

std::string DrawnRig::prefix() const
{
  const std::string own = "rig_floor";
  const bool ends = floor.size() >= own.size() && floor.compare(floor.size() - own.size(), own.size(), own) == 0;
  return ends ? floor.substr(0, floor.size() - own.size()) : std::string();
}

}  // namespace drill_rig_sim
