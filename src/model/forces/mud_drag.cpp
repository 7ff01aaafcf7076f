#include "drill_rig_sim/model/forces/mud_drag.h"

#include "drill_rig_sim/model/forces/free_string.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{
/// Coefficients of a node.
struct Drag
{
  double across;     // [N s/m]
  double along;      // along the string, less what acts across it [N s/m]
  double torsional;  // [N m s/rad]
  double quadratic;  // across the string [N s2/m2]
};

Drag drag_of(const StageContext& at, int i) noexcept
{
  const MeshNode& node = at.model.mesh().nodes[i];
  const double wet = at.stage.immersed[i];
  return {wet * node.mud_across, wet * (node.mud_along - node.mud_across), wet * node.mud_about,
          wet * node.length * lateral_drag(at.model.scene().mud, node.diameter)};
}

Vector3d across_string(const NodeMotion& node, const Vector3d& n) noexcept
{
  return node.rate.head<3>() - n * n.dot(node.rate.head<3>());
}

/// `n`: the string's direction at the start of the step, whoever integrates.
Vector6d force_of(const Drag& drag, const NodeMotion& node, const Vector3d& n) noexcept
{
  const Vector3d sideways = across_string(node, n);
  Vector6d out;
  out.head<3>() = drag.across * node.rate.head<3>() + (drag.along * n.dot(node.rate.head<3>())) * n +
                  (drag.quadratic * sideways.norm()) * sideways;
  out.tail<3>() = (drag.torsional * n.dot(node.rate.tail<3>())) * n;
  return out;
}

void add_mud_drag(const StageContext& at, const ForceRows& to) noexcept
{
  if (moved_in_batches(at)) return;  // the batch kernel of the beams has it
  const double dv_du = at.stage.dv_du;
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    if (at.stage.guides[i].guided) continue;
    const NodeMotion& node = at.work.nodes[i];
    const Drag drag = drag_of(at, i);
    const Vector3d& n = at.stage.normal[i];
    to.force(i) += force_of(drag, node, n);
    if (!to.with_tangent()) continue;
    auto d = to.slope(i);
    const Matrix3d nn = n * n.transpose();
    d.topLeftCorner<3, 3>() += (dv_du * drag.along) * nn;
    d.topLeftCorner<3, 3>().diagonal().array() += dv_du * drag.across;
    d.bottomRightCorner<3, 3>() += (dv_du * drag.torsional) * nn;
    // of |v| v, v across the string: |v| (1 - n n^T) + v v^T/|v|
    const Vector3d sideways = across_string(node, n);
    const double speed = sideways.norm();
    if (speed <= 0.0) continue;
    d.topLeftCorner<3, 3>() += (dv_du * drag.quadratic / speed) * (sideways * sideways.transpose()) - (dv_du * drag.quadratic * speed) * nn;
    d.topLeftCorner<3, 3>().diagonal().array() += dv_du * drag.quadratic * speed;
  }
}

void sample_mud_drag(const StageContext& at, EnergySample& sample) noexcept
{
  for (int i = 0; i < at.model.nodes(); ++i)
    if (!at.stage.guides[i].guided) at_node(sample, NodeForce::mud, i) += force_of(drag_of(at, i), at.work.nodes[i], at.stage.normal[i]);
}
}  // namespace

const Force mud_drag = {"mud drag", Cost::inertia, Sum::string, add_mud_drag, nullptr, nullptr, nullptr, sample_mud_drag};

}  // namespace drill_rig_sim
