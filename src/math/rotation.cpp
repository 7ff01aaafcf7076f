#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) noexcept
{
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

Eigen::Quaterniond pointed_along(const Eigen::Quaterniond& q, const Eigen::Vector3d& axis) noexcept
{
  return (shortest_turn(x_axis(q), axis) * q).normalized();
}

}  // namespace drill_rig_sim
