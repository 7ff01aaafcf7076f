// SPDX-License-Identifier: BSD-3-Clause
#include "pick.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
/// Share of the way from a to b at which a rod is nearest to a ray, within the rod.
double nearest_share(const Vector3d& a, const Vector3d& b, const Ray& ray)
{
  const Vector3d rod = b - a, off = a - ray.origin;
  const Vector3d rod_across = rod - rod.dot(ray.direction) * ray.direction,
                 off_across = off - off.dot(ray.direction) * ray.direction;
  const double size = rod_across.squaredNorm();
  return size > 0.0 ? std::clamp(-off_across.dot(rod_across) / size, 0.0, 1.0) : 0.0;
}
}  // namespace

std::optional<Picked> pick(const std::vector<DrawnNode>& nodes, double radius, double slope, const Ray& ray)
{
  std::optional<Picked> found;
  double best = 1.0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
  {
    const double share = nearest_share(nodes[i].position, nodes[i + 1].position, ray);
    const Vector3d place = nodes[i].position + share * (nodes[i + 1].position - nodes[i].position);
    const double ahead = (place - ray.origin).dot(ray.direction);
    if (ahead <= 0.0) continue;
    const double beside = (place - ray.origin - ahead * ray.direction).norm();
    const double measured = beside / (radius + slope * ahead);
    if (measured > best) continue;
    best = measured;
    found = Picked{{i, share}, place};
  }
  return found;
}

}  // namespace drill_rig_sim
