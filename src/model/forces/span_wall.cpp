// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/span_wall.h"

#include "drill_rig_sim/math/rotation.h"
#include "wall_parts.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

namespace
{
double span_radius(const StageContext& at, int e) noexcept
{
  return 0.5 * at.model.mesh().elements[e].outer_diameter;
}

/// Force and moment at the middle, on an end with this arm.
Vector6d share(const Vector3d& arm, const Vector3d& force, const Vector3d& moment) noexcept
{
  Vector6d out;
  out << 0.5 * force, 0.5 * moment + arm.cross(force);
  return out;
}

WallForce span_sticking_force(const StageContext& at, int e, Matrix6d* block) noexcept
{
  const SpanMotion& span = at.work.spans[e];
  const NodeMotion &lower = at.work.nodes[e], &upper = at.work.nodes[e + 1];
  const Vector6d rate = middle(span, lower.rate, upper.rate);
  const ContactMotion motion{span.position,  span.increment.head<3>(), span.increment.tail<3>(),
                             rate.head<3>(), rate.tail<3>(),           at.stage.dv_du,
                             at.stage.time};
  const Vector3d& bristle = at.start.spans[e].bristle;
  const WallLaw law = at.model.span_contact(e, span.closest, at.start.spans[e].rest);
  return block ? wall_contact(span.closest, span_radius(at, e), motion, bristle, law, *block)
               : wall_contact(span.closest, span_radius(at, e), motion, bristle, law);
}

WallForce span_sliding_force(const StageContext& at, int e, Matrix6d* block) noexcept
{
  const SpanMotion& span = at.work.spans[e];
  Matrix6d unused;
  return sliding_wall_contact(span.closest, span_radius(at, e), span.position, at.stage.sliding, at.model.span_contact(e),
                              block ? *block : unused);
}

using ForceAtSpan = WallForce (*)(const StageContext&, int, Matrix6d*) noexcept;

template <ForceAtSpan force_at>
void add_span_wall(const StageContext& at, const ForceRows& to) noexcept
{
  StageResult& result = at.work.result;
  Matrix6d block;
  each_outside(at.stage.guided_elements, at.model.elements(),
               [&](int e)
               {
                 const SpanMotion& span = at.work.spans[e];
                 WallForce f;
                 if (span.touches)
                 {
                   f = force_at(at, e, to.with_tangent() ? &block : nullptr);
                   to.force(e) -= share(span.lower_arm, f.force, f.moment);
                   to.force(e + 1) -= share(span.upper_arm, f.force, f.moment);
                   if (to.with_tangent()) add_at_ends(span, e, -block, *to.tangent());
                 }
                 result.span_bristle[e] = f.bristle;
                 result.span_rest[e] = rest_after(f, at.start.spans[e].rest, at.stage.time);
                 result.forces.span_contact[e] = f.normal_force;
                 result.forces.span_wall[e] = f.force;
               });
}

void store_span_wall(const StageContext& at, StoredEnergy& energy) noexcept
{
  each_outside(at.stage.guided_elements, at.model.elements(),
               [&](int e)
               {
                 const SpanMotion& span = at.work.spans[e];
                 const WallLaw& contact = at.model.span_contact(e);
                 energy.bristles += 0.5 * contact.tangential_stiffness * at.work.result.span_bristle[e].squaredNorm();
                 if (span.touches)
                   energy.wall += elastic_energy(contact.law, -wall_gap(span.closest, span.position, span_radius(at, e)));
               });
}

void sample_span(const StageContext& at, int e, EnergySample& sample) noexcept
{
  const SpanMotion& span = at.work.spans[e];
  const WallParts parts = parts_of(span_sticking_force(at, e, nullptr), span.closest, at.model.span_contact(e).law);
  const auto book = [&](NodeForce kind, const Vector3d& force, const Vector3d& moment)
  {
    at_node(sample, kind, e) += share(span.lower_arm, force, moment);
    at_node(sample, kind, e + 1) += share(span.upper_arm, force, moment);
  };
  book(NodeForce::wall, parts.elastic, Vector3d::Zero());
  book(NodeForce::ledge, parts.ledge, Vector3d::Zero());
  book(NodeForce::wall_damping, parts.damping, Vector3d::Zero());
  book(NodeForce::friction, parts.friction, parts.friction_moment);
}

void sample_span_wall(const StageContext& at, EnergySample& sample) noexcept
{
  each_outside(at.stage.guided_elements, at.model.elements(),
               [&](int e)
               {
                 if (at.work.spans[e].touches) sample_span(at, e, sample);
               });
}
}  // namespace

const Force span_wall = {"wall between the nodes",
                         Cost::contact,
                         Sum::string,
                         add_span_wall<span_sticking_force>,
                         add_span_wall<span_sliding_force>,
                         add_span_wall<span_sticking_force>,
                         store_span_wall,
                         sample_span_wall};

Vector6d middle(const SpanMotion& span, const Vector6d& lower, const Vector6d& upper) noexcept
{
  Vector6d out = 0.5 * (lower + upper);
  out.head<3>() += upper.tail<3>().cross(span.upper_arm) + lower.tail<3>().cross(span.lower_arm);
  return out;
}

void add_at_ends(const SpanMotion& span, int e, const Matrix6d& block, BlockTridiagonal& tangent) noexcept
{
  // J of an end: v = 1/2 v_end - [arm] w_end, w = 1/2 w_end
  const auto by_end = [&block](const Vector3d& arm)
  {
    Matrix6d out = 0.5 * block;
    out.rightCols<3>() -= block.leftCols<3>() * skew(arm);
    return out;
  };
  const auto at_end = [](const Vector3d& arm, const Matrix6d& rows)
  {
    Matrix6d out = 0.5 * rows;
    out.bottomRows<3>() += skew(arm) * rows.topRows<3>();
    return out;
  };
  const Matrix6d lower = by_end(span.lower_arm), upper = by_end(span.upper_arm);
  tangent.diagonal(e) += at_end(span.lower_arm, lower);
  tangent.diagonal(e + 1) += at_end(span.upper_arm, upper);
  tangent.upper(e) += at_end(span.lower_arm, upper);
  tangent.lower(e) += at_end(span.upper_arm, lower);
}

}  // namespace drill_rig_sim
