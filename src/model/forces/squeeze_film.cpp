// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/squeeze_film.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{
/// [N s/m]; 0 where there is none.
double damping_of(const StageContext& at, int i) noexcept
{
  const double damping = at.model.mesh().nodes[i].squeeze_film_damping;
  return damping > 0.0 && at.work.nodes[i].position.z() < 0.0 ? damping : 0.0;
}

Matrix3d across_hole(const NodeMotion& node) noexcept
{
  return Matrix3d::Identity() - node.closest.tangent * node.closest.tangent.transpose();
}

void add_at(const StageContext& at, int i, const ForceRows& to) noexcept
{
  const double damping = damping_of(at, i);
  if (damping <= 0.0) return;
  const NodeMotion& node = at.work.nodes[i];
  const Matrix3d across = across_hole(node);
  to.force(i).head<3>() += damping * (across * node.rate.head<3>());
  if (to.with_tangent()) to.slope(i).topLeftCorner<3, 3>() += (at.stage.dv_du * damping) * across;
}

void add_squeeze_film(const StageContext& at, const ForceRows& to) noexcept
{
  each_outside(at.stage.guided_nodes, at.model.top(), [&](int i) { add_at(at, i, to); });
}

void sample_squeeze_film(const StageContext& at, EnergySample& sample) noexcept
{
  add_squeeze_film(at, {at.work, sample.force[static_cast<std::size_t>(NodeForce::squeeze_film)].data(), nullptr});
}
}  // namespace

const Force squeeze_film = {"squeeze film", Cost::contact, Sum::contact, add_squeeze_film,
                            nullptr,        nullptr,       nullptr,      sample_squeeze_film};

void add_film_at_bit(const StageContext& at, const ForceRows& to) noexcept
{
  add_at(at, 0, to);
}

}  // namespace drill_rig_sim
