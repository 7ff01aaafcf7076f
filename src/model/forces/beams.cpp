// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/beams.h"

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/forces/free_string.h"
#include "drill_rig_sim/model/pointing.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
/// Node e is the element's lower end, node e + 1 its upper end.
BeamPose pose_of(const StageContext& at, int e) noexcept
{
  const MeshElement& element = at.model.mesh().elements[e];
  const NodeMotion& lower = at.work.nodes[e];
  const NodeMotion& upper = at.work.nodes[e + 1];
  BeamPose pose{upper.position,
                lower.position,
                upper.normal,
                lower.normal,
                0.0,
                upper.orientation,
                lower.orientation,
                at.stage.free_stretch[static_cast<std::size_t>(e)]};
  if (element.bend != 0.0 || at.model.mesh().is_shaft(e))
  {
    const Eigen::Quaterniond bent =
        element.bend != 0.0 ? upper.orientation * element.upper_end : shaft_end(at.model, at.stage, at.work).orientation;
    pose.upper_normal = x_axis(bent);
    pose.upper_orientation = bent;
    pose.twist = twist_between(bent, lower.orientation);
  }
  else
    pose.twist = twist_between(upper.orientation, lower.orientation);
  return pose;
}

/// Angular velocity: the spin of the rate is about the normal at the start of the step, that of the pipe about the present one.
Vector3d turning_of(const NodeMotion& node) noexcept
{
  return node.rate.tail<3>() + node.carried_spin * (node.normal - node.axis);
}

BeamDamping damping_of(const StageContext& at, int e) noexcept
{
  const NodeMotion& lower = at.work.nodes[e];
  const NodeMotion& upper = at.work.nodes[e + 1];
  BeamDamping damping{at.stage.structural_damping,
                      at.stage.dv_du,
                      lower.rate.head<3>() - upper.rate.head<3>(),
                      turning_of(upper),
                      turning_of(lower),
                      upper.carried_spin * upper.normal,
                      lower.carried_spin * lower.normal};
  if (!at.model.mesh().is_shaft(e)) return damping;
  const ShaftEnd end = shaft_end(at.model, at.stage, at.work);
  damping.upper_turning += end.spin * end.off;
  damping.upper_spin += end.spin * end.off;
  return damping;
}

/// By the collar's rotation instead of the shaft's.
void take_collar(const StageContext& at, int e, BeamTangent& t) noexcept
{
  const Vector3d& n = at.work.nodes[e + 1].normal;
  const Vector3d off = shaft_end(at.model, at.stage, at.work).off;
  for (Eigen::Matrix3d* by_upper : {&t.force_upper, &t.upper_upper, &t.lower_upper})
    *by_upper += (*by_upper * off) * n.transpose();
}

bool guided_element(const StageContext& at, int e) noexcept
{
  return at.stage.guides.spans(static_cast<std::size_t>(e));
}

/// d = lower - upper. An element writes the blocks of its upper node and those between; only the first node's is there before.
void scatter(const BeamTangent& t, int e, BlockTridiagonal& tangent) noexcept
{
  auto lower = tangent.diagonal(e);
  lower.topLeftCorner<3, 3>() += t.force_d;
  lower.topRightCorner<3, 3>() += t.force_lower;
  lower.bottomLeftCorner<3, 3>() += t.lower_d;
  lower.bottomRightCorner<3, 3>() += t.lower_lower;
  auto upper = tangent.diagonal(e + 1);
  upper.topLeftCorner<3, 3>() = t.force_d;
  upper.topRightCorner<3, 3>() = -t.force_upper;
  upper.bottomLeftCorner<3, 3>() = -t.upper_d;
  upper.bottomRightCorner<3, 3>() = t.upper_upper;
  auto lower_by_upper = tangent.upper(e);
  lower_by_upper.topLeftCorner<3, 3>() = -t.force_d;
  lower_by_upper.topRightCorner<3, 3>() = t.force_upper;
  lower_by_upper.bottomLeftCorner<3, 3>() = -t.lower_d;
  lower_by_upper.bottomRightCorner<3, 3>() = t.lower_upper;
  auto upper_by_lower = tangent.lower(e);
  upper_by_lower.topLeftCorner<3, 3>() = -t.force_d;
  upper_by_lower.topRightCorner<3, 3>() = -t.force_lower;
  upper_by_lower.bottomLeftCorner<3, 3>() = t.upper_d;
  upper_by_lower.bottomRightCorner<3, 3>() = t.upper_lower;
}

/// Writes the diagonal block of its upper node.
void add_element(const StageContext& at, int e, const ForceRows& to) noexcept
{
  const BeamKind& kind = at.model.beam();
  const BeamSection& section = at.model.mesh().elements[e].section;
  const Vector3d& load = at.stage.load[e];
  const BeamPose pose = pose_of(at, e);
  const BeamDamping damping = damping_of(at, e);
  BeamTangent t;
  BeamStrain strain;
  const BeamForces f = to.with_tangent() ? kind.forces_and_tangent(section, pose, damping, load, strain, t)
                                         : kind.forces(section, pose, damping, load, strain);
  auto lower = to.force(e), upper = to.force(e + 1);
  lower.head<3>() += f.force - 0.5 * load;
  lower.tail<3>() += f.moment_lower;
  upper.head<3>() -= f.force + 0.5 * load;
  upper.tail<3>() += f.moment_upper;
  if (!to.with_tangent()) return;
  if (at.model.mesh().is_shaft(e)) take_collar(at, e, t);
  scatter(t, e, *to.tangent());
}

void add_elements(const StageContext& at, const ForceRows& to) noexcept
{
  open_string(at, to);
  for (int e = 0; e < at.model.elements(); ++e)
    if (!guided_element(at, e)) add_element(at, e, to);
}

void add_beams(const StageContext& at, const ForceRows& to) noexcept
{
  if (moved_in_batches(at))
    add_free_string(at, to);
  else
    add_elements(at, to);
}

/// Beams between a guided node and a free one: what they push it to its wall with.
void add_beams_at_guides(const StageContext& at, const ForceRows& to) noexcept
{
  const auto add_beam_at = [&](int e)
  {
    const Vector3d force = element_forces(at, e).force, half = 0.5 * at.stage.load[e];
    to.force(e).head<3>() += force - half;
    to.force(e + 1).head<3>() -= force + half;
  };
  for (const Runs::Run& run : at.stage.guided_nodes)
  {
    if (run.first > 0) add_beam_at(run.first - 1);
    if (run.last < at.model.nodes()) add_beam_at(run.last - 1);
  }
}

/// The dead load's potential, end moments included: the mean place of a cubic element is (x1 + x2)/2 + L/12 (n1 - n2). The two
/// other elements leave the end moments away, and then the normals in it.
double weight_potential(const StageContext& at, int e, const BeamPose& pose) noexcept
{
  const double arm = at.model.beam().load_moments ? at.model.mesh().elements[e].section.length / 12.0 : 0.0;
  const Vector3d mean = 0.5 * (pose.upper_position + pose.lower_position) + arm * (pose.upper_normal - pose.lower_normal);
  return -at.stage.load[e].dot(mean);
}

void store_beams(const StageContext& at, StoredEnergy& energy) noexcept
{
  if (moved_in_batches(at)) return store_free_string(at, energy);
  for (int e = 0; e < at.model.elements(); ++e)
    if (!guided_element(at, e)) store_beam(at, e, energy);
}

void add_to_ends(EnergySample& sample, NodeForce kind, int e, const BeamForces& f, double sign) noexcept
{
  auto lower = at_node(sample, kind, e), upper = at_node(sample, kind, e + 1);
  lower.head<3>() += sign * f.force;
  lower.tail<3>() += sign * f.moment_lower;
  upper.head<3>() -= sign * f.force;
  upper.tail<3>() += sign * f.moment_upper;
}

void sample_beams(const StageContext& at, EnergySample& sample) noexcept
{
  if (moved_in_batches(at)) return sample_free_string(at, sample);
  for (int e = 0; e < at.model.elements(); ++e)
    if (!guided_element(at, e)) sample_beam(at, e, sample);
}

/// How far the shaft's end has turned since the start of the step beyond the collar.
Vector3d turn_of_shaft(const StageContext& at, const ShaftEnd& end, const NodeMotion& collar) noexcept
{
  const Vector3d moved = at.stage.lean - at.start.lean;
  return collar.spin * end.off + collar.normal.cross(moved);
}
}  // namespace

const Force beams = {"beams",      Cost::elements,      Sum::string, add_beams,
                     add_elements, add_beams_at_guides, store_beams, sample_beams};

void open_string(const StageContext& at, const ForceRows& to) noexcept
{
  if (to.with_tangent()) to.slope(0).setZero();
  for (const Runs::Run& run : at.stage.guided_nodes)
  {
    if (run.first > 0) to.open(run.first);
    if (run.last < at.model.nodes()) to.open(run.last - 1);
  }
}

void add_beam(const StageContext& at, int e, const ForceRows& to) noexcept
{
  if (!to.with_tangent()) return add_element(at, e, to);
  const Eigen::Matrix<double, 6, 6> there = to.slope(e + 1);
  add_element(at, e, to);
  to.slope(e + 1) += there;
}

void store_beam(const StageContext& at, int e, StoredEnergy& energy) noexcept
{
  const BeamPose pose = pose_of(at, e);
  energy.beams += at.model.beam().energy(at.model.mesh().elements[e].section, pose);
  energy.weight += weight_potential(at, e, pose);
}

void sample_beam(const StageContext& at, int e, EnergySample& sample) noexcept
{
  const BeamKind& kind = at.model.beam();
  const BeamSection& section = at.model.mesh().elements[e].section;
  const BeamPose pose = pose_of(at, e);
  BeamStrain strain;
  // the same element without damping and load is the elastic part; what damping adds is the rest
  const BeamForces elastic = kind.forces(section, pose, BeamDamping(), Vector3d::Zero(), strain), all = element_forces(at, e),
                   undamped = kind.forces(section, pose, BeamDamping(), at.stage.load[e], strain);
  add_to_ends(sample, NodeForce::beams, e, elastic, 1.0);
  add_to_ends(sample, NodeForce::structural, e, all, 1.0);
  add_to_ends(sample, NodeForce::structural, e, undamped, -1.0);
  if (!at.model.mesh().is_shaft(e)) return;
  sample.shaft = {all.moment_upper, elastic.moment_upper, all.moment_upper - undamped.moment_upper,
                  turn_of_shaft(at, shaft_end(at.model, at.stage, at.work), at.work.nodes[e + 1])};
}

void find_beam_forces(const StageContext& at, int e) noexcept
{
  const BeamPose pose = pose_of(at, e);
  const BeamForces f = element_forces(at, e);
  const Vector3d& n = pose.upper_normal;
  RigForces& out = at.work.result.forces;
  out.tension[e] = f.tension;
  out.torque[e] = -f.torque;
  out.bending_moment[e + 1] = (f.moment_upper - n * n.dot(f.moment_upper)).norm();
}

BeamForces element_forces(const StageContext& at, int e) noexcept
{
  BeamStrain strain;
  return at.model.beam().forces(at.model.mesh().elements[e].section, pose_of(at, e), damping_of(at, e), at.stage.load[e], strain);
}

}  // namespace drill_rig_sim
