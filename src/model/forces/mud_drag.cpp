// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/mud_drag.h"

#include "drill_rig_sim/model/forces/free_string.h"
#include "drill_rig_sim/rig/rigid_body.h"

namespace drill_rig_sim::one_lane
{
#include "drill_rig_sim/string/mud_text.h"
}  // namespace drill_rig_sim::one_lane

namespace drill_rig_sim
{
namespace
{
one_lane::MudDrag drag_of(const Model& model, const Stage& stage, int i) noexcept
{
  const MeshNode& node = model.mesh().nodes[i];
  const double wet = stage.immersed[i];
  return {wet * node.mud_across, wet * (node.mud_along - node.mud_across), wet * node.mud_about,
          wet * node.length * lateral_drag(model.scene().mud, node.diameter)};
}

void add_mud_drag(const StageContext& at, const ForceRows& to) noexcept
{
  if (moved_in_batches(at)) return;  // the batch kernel of the beams has it
  const double dv_du = at.stage.dv_du;
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    if (at.stage.guides.guided[static_cast<std::size_t>(i)]) continue;
    const one_lane::MudDrag drag = drag_of(at.model, at.stage, i);
    const one_lane::V3 n = one_lane::from(at.stage.normal[i]);
    const one_lane::V6 rate = one_lane::from(at.work.nodes[i].rate);
    to.force(i) += to_eigen(mud_force(drag, n, rate));
    if (!to.with_tangent()) continue;
    auto d = to.slope(i);
    d.topLeftCorner<3, 3>() += to_eigen(mud_slope(drag, n, rate, dv_du, {0.0, 0.0}));
    d.bottomRightCorner<3, 3>() += mud_turning_slope(drag, dv_du).nn * at.stage.normal[i] * at.stage.normal[i].transpose();
  }
}

void sample_mud_drag(const StageContext& at, EnergySample& sample) noexcept
{
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    if (at.stage.guides.guided[static_cast<std::size_t>(i)]) continue;
    const one_lane::V6 force =
        mud_force(drag_of(at.model, at.stage, i), one_lane::from(at.stage.normal[i]), one_lane::from(at.work.nodes[i].rate));
    at_node(sample, NodeForce::mud, i) += to_eigen(force);
  }
}
}  // namespace

Eigen::Matrix<double, 6, 1> mud_drag_of_sliding(const Model& model, const Stage& stage, int i,
                                                const Eigen::Vector3d& down) noexcept
{
  const Eigen::Vector3d along = stage.sliding.axial_speed * down, about = stage.sliding.spin_speed * down;
  return to_eigen(mud_force(drag_of(model, stage, i), one_lane::from(down), {one_lane::from(along), one_lane::from(about)}));
}

const Force mud_drag = {"mud drag", Cost::inertia, Sum::string, add_mud_drag, nullptr, nullptr, nullptr, sample_mud_drag};

}  // namespace drill_rig_sim
