#include "drill_rig_sim/system/system.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/contact/bit_torque.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{
constexpr int held_by_rail[] = {0, 1, 3, 4};  // of the top node in dynamics
}  // namespace

System::System(const Scene& scene, Mesh mesh)
  : scene_(scene), mesh_(std::move(mesh)), beam_(find_beam(scene.numerics.element)), formation_(scene.formation)
{
  const std::size_t n = mesh_.nodes.size();
  contact_.assign(n, scene.contact);
  for (std::size_t i = 0; i < n; ++i) contact_[i].law = mesh_.nodes[i].contact;
  stage_.rate.assign(n, Vector6d::Zero());
  stage_.acceleration.assign(n, Vector6d::Zero());
  scratch_.resize(n);
  loads_.assign(n - 1, Vector3d::Zero());
  unused_residual_.assign(6 * n, 0.0);
  for (const PartSpec& part : scene_.string)
    if (part.motor) motor_ = &*part.motor;
  const BitSpec& bit = *scene_.string.front().bit;
  bit_bristle_ = drill_rig_sim::bit_bristle_stiffness(bit.torque, bit.diameter);
  forces_.tension.assign(n - 1, 0.0);
  forces_.torque.assign(n - 1, 0.0);
  forces_.bending_moment.assign(n, 0.0);
  forces_.contact.assign(n, 0.0);
  forces_.wall.assign(n, Vector3d::Zero());
}

void System::begin(const SystemState& state, double step, const Setpoints& setpoints) noexcept
{
  static_ = false;
  friction_ = FrictionMode::sticking;
  damping_time_ = scene_.numerics.structural_damping;
  setpoints_ = setpoints;
  begin_common(state);
  stage_at(step);
}

void System::stage_at(double time) noexcept
{
  stage_.time = time;
  hoist_end_ = time > 0.0 ? advance_hoist(*start_, time) : start_->hoist;
  const double motor = start_->bit.motor_speed;
  bit_drive_ = {motor, time * motor, start_->nodes[0].rate.spin + motor, time, 0.0};
}

void System::begin_static(const SystemState& state, FrictionMode friction, double coefficient) noexcept
{
  static_ = true;
  friction_ = friction;
  stage_.dv_du = coefficient;
  stage_.da_du = coefficient * coefficient;
  damping_time_ = 0.0;
  std::fill(stage_.rate.begin(), stage_.rate.end(), Vector6d::Zero());
  std::fill(stage_.acceleration.begin(), stage_.acceleration.end(), Vector6d::Zero());
  begin_common(state);
}

void System::begin_common(const SystemState& state) noexcept
{
  start_ = &state;
  for (std::size_t i = 0; i < scratch_.size(); ++i)
  {
    NodeScratch& s = scratch_[i];
    s.normal_start = x_axis(state.nodes[i].orientation);
    s.immersed = state.nodes[i].position.z() < 0.0 ? 1.0 : 0.0;
    s.closest.segment = state.nodes[i].segment;
    s.bristle = state.nodes[i].bristle;
  }
  for (std::size_t e = 0; e < loads_.size(); ++e)
    loads_[e].z() = -element_weight(static_cast<int>(e), state.nodes[e].position.z(), state.nodes[e + 1].position.z());
}

double System::element_weight(int e, double z_lower, double z_upper) const noexcept
{
  const MeshElement& element = mesh_.elements[e];
  const double height = std::max(z_upper - z_lower, 1e-9);
  const double immersed = z_upper <= 0.0 ? 1.0 : std::clamp(-z_lower / height, 0.0, 1.0);
  return standard_gravity * (element.linear_mass - scene_.mud.density * element.displaced * immersed) * element.section.length;
}

void System::configure(const double* u) noexcept
{
  for (std::size_t i = 0; i < scratch_.size(); ++i)
  {
    NodeScratch& s = scratch_[i];
    const NodeState& start = start_->nodes[i];
    s.increment = Eigen::Map<const Vector6d>(u + 6 * i);
    s.position = start.position + s.increment.head<3>();
    s.spin = s.increment.tail<3>().dot(s.normal_start);
    s.tilt = s.increment.tail<3>() - s.spin * s.normal_start;
    s.orientation = rotation_from_vector(s.tilt) * rotation_from_vector(s.spin * s.normal_start) * start.orientation;
    s.normal = x_axis(s.orientation);
    s.rate = stage_.dv_du * s.increment + stage_.rate[i];
    s.acceleration = stage_.da_du * s.increment + stage_.acceleration[i];
  }
}

void System::evaluate(const double* u, double* residual, BlockTridiagonal* tangent) noexcept
{
  profiler_.lap(Cost::other);
  ++work_.residuals;
  if (tangent) ++work_.tangents;
  std::fill(residual, residual + 6 * scratch_.size(), 0.0);
  configure(u);
  profiler_.lap(Cost::kinematics);
  assemble(residual, tangent);
}

void System::assemble(double* residual, BlockTridiagonal* tangent) noexcept
{
  if (tangent) tangent->diagonal(0).setZero();  // the elements write every other block before anything is added to it
  add_elements(residual, tangent);
  profiler_.lap(Cost::elements);
  if (!static_) add_mud_damping(residual, tangent);
  if (!static_ || stage_.da_du > 0.0) add_inertia(residual, tangent);
  profiler_.lap(Cost::inertia);
  add_walls(residual, tangent);
  profiler_.lap(Cost::contact);
  add_bit(residual, tangent);
  profiler_.lap(Cost::bit);
  if (start_->stuck_point.node >= 0) add_stuck_point(residual, tangent);
  if (!static_) add_rig(residual, tangent);
  hold_top(residual, tangent);
  profiler_.lap(Cost::rig);
}

void System::settle(const double* u) noexcept
{
  profiler_.lap(Cost::other);
  ++work_.residuals;
  std::fill(unused_residual_.begin(), unused_residual_.end(), 0.0);
  configure(u);
  profiler_.lap(Cost::kinematics);
  add_walls(unused_residual_.data(), nullptr);
  profiler_.lap(Cost::contact);
  add_bit(unused_residual_.data(), nullptr);
  profiler_.lap(Cost::bit);
  add_rig(unused_residual_.data(), nullptr);
  profiler_.lap(Cost::rig);
}

BeamPose System::element_pose(int e) const noexcept
{
  const MeshElement& element = mesh_.elements[e];
  const NodeScratch& lower = scratch_[e];
  const NodeScratch& upper = scratch_[e + 1];
  BeamPose pose{upper.position, lower.position, upper.normal, lower.normal, 0.0, upper.orientation, lower.orientation};
  if (element.bend != 0.0)
  {
    const Eigen::Quaterniond bent = upper.orientation * element.upper_end;
    pose.upper_normal = x_axis(bent);
    pose.upper_orientation = bent;
    pose.twist = twist_between(bent, lower.orientation);
  }
  else
    pose.twist = twist_between(upper.orientation, lower.orientation);
  return pose;
}

BeamForces System::element_forces(int e, BeamTangent* tangent) noexcept
{
  const MeshElement& element = mesh_.elements[e];
  const NodeScratch& lower = scratch_[e];
  const NodeScratch& upper = scratch_[e + 1];
  const BeamPose pose = element_pose(e);
  const BeamDamping damping{damping_time_, stage_.dv_du, lower.rate.head<3>() - upper.rate.head<3>(), upper.rate.tail<3>(),
                            lower.rate.tail<3>()};
  BeamStrain strain;
  BeamForces f = tangent ? beam_.forces_and_tangent(element.section, pose, damping, loads_[e], strain, *tangent)
                               : beam_.forces(element.section, pose, damping, loads_[e], strain);
  forces_.tension[e] = f.tension;
  forces_.torque[e] = -f.torque;
  forces_.bending_moment[e + 1] = (f.moment_upper - pose.upper_normal * pose.upper_normal.dot(f.moment_upper)).norm();
  return f;
}

void System::add_elements(double* residual, BlockTridiagonal* tangent) noexcept
{
  BeamTangent t;
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
  {
    const BeamForces f = element_forces(static_cast<int>(e), tangent ? &t : nullptr);
    Eigen::Map<Vector6d> r_lower(residual + 6 * e), r_upper(residual + 6 * e + 6);
    r_lower.head<3>() += f.force - 0.5 * loads_[e];
    r_lower.tail<3>() += f.moment_lower;
    r_upper.head<3>() -= f.force + 0.5 * loads_[e];
    r_upper.tail<3>() += f.moment_upper;
    if (tangent) scatter(t, static_cast<int>(e), *tangent);
  }
}

void System::evaluate_string_forces() noexcept
{
  for (int e = 0; e < static_cast<int>(mesh_.elements.size()); ++e) element_forces(e, nullptr);
}

/// Node e is the element's lower end, node e + 1 its upper end; d = lower - upper.
void System::scatter(const BeamTangent& t, int e, BlockTridiagonal& tangent) noexcept
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

double System::mass_across(int i) const noexcept
{
  const MeshNode& node = mesh_.nodes[i];
  const bool shaft = i + 1 == nodes() && !static_;
  return node.mass + scratch_[i].immersed * node.added_mass + (shaft ? scene_.rig.hoisting.block_mass : 0.0);
}

void System::accelerate(const double* residual) noexcept
{
  for (int i = 0; i < nodes(); ++i)
  {
    const MeshNode& node = mesh_.nodes[i];
    NodeScratch& s = scratch_[i];
    const Vector3d& n = s.normal_start;
    const Vector3d force = -Eigen::Map<const Vector3d>(residual + 6 * i), moment = -Eigen::Map<const Vector3d>(residual + 6 * i + 3);
    const double across = mass_across(i), along = across - s.immersed * node.added_mass;
    s.acceleration.head<3>() = force / across + (n.dot(force) * (1.0 / along - 1.0 / across)) * n;
    s.acceleration.tail<3>() = moment / node.tilt_inertia + (n.dot(moment) * (1.0 / node.spin_inertia - 1.0 / node.tilt_inertia)) * n;
  }
  for (int k : held_by_rail) scratch_.back().acceleration[k] = 0.0;
}

void System::multiply_mass(const double* x, double* y) const noexcept
{
  for (int i = 0; i < nodes(); ++i)
  {
    const MeshNode& node = mesh_.nodes[i];
    const NodeScratch& s = scratch_[i];
    const Vector3d& n = s.normal_start;
    const Vector3d a = Eigen::Map<const Vector3d>(x + 6 * i), alpha = Eigen::Map<const Vector3d>(x + 6 * i + 3);
    Eigen::Map<Vector3d>(y + 6 * i) = mass_across(i) * a - (s.immersed * node.added_mass * n.dot(a)) * n;
    Eigen::Map<Vector3d>(y + 6 * i + 3) = node.tilt_inertia * alpha + ((node.spin_inertia - node.tilt_inertia) * n.dot(alpha)) * n;
  }
  for (int k : held_by_rail) y[6 * (nodes() - 1) + k] = 0.0;
}

void System::add_mud_damping(double* residual, BlockTridiagonal* tangent) noexcept
{
  const double by_rate = stage_.dv_du;
  const MudSpec& mud = scene_.mud;
  for (std::size_t i = 0; i < scratch_.size(); ++i)
  {
    const NodeScratch& s = scratch_[i];
    const Vector3d& n = s.normal_start;
    const double length = s.immersed * mesh_.nodes[i].length;
    const double across = length * mud.lateral_damping;
    const double along = length * mud.axial_damping - across;  // along the string, less what acts across it
    const double torsional = length * mud.torsional_damping;
    Eigen::Map<Vector6d> r(residual + 6 * i);
    r.head<3>() += across * s.rate.head<3>() + (along * n.dot(s.rate.head<3>())) * n;
    r.tail<3>() += (torsional * n.dot(s.rate.tail<3>())) * n;
    if (!tangent) continue;
    auto d = tangent->diagonal(static_cast<int>(i));
    const Matrix3d nn = n * n.transpose();
    d.topLeftCorner<3, 3>() += (by_rate * along) * nn;
    d.topLeftCorner<3, 3>().diagonal().array() += by_rate * across;
    d.bottomRightCorner<3, 3>() += (by_rate * torsional) * nn;
  }
}

void System::add_inertia(double* residual, BlockTridiagonal* tangent) noexcept
{
  const double by_rate = stage_.dv_du, by_acceleration = stage_.da_du;
  for (std::size_t i = 0; i < scratch_.size(); ++i)
  {
    const MeshNode& node = mesh_.nodes[i];
    const NodeScratch& s = scratch_[i];
    const Vector3d& n = s.normal_start;
    Eigen::Map<Vector6d> r(residual + 6 * i);

    // translation: scalar across the string, less the added mass along it
    const double added = s.immersed * node.added_mass;
    const double mass = mass_across(static_cast<int>(i));
    const Vector3d a = s.acceleration.head<3>();
    r.head<3>() += mass * a - (added * n.dot(a)) * n;

    // rotation of a symmetric top in axes that tilt but do not spin
    const Vector3d w = s.rate.tail<3>(), alpha = s.acceleration.tail<3>();
    const double spin = w.dot(n);
    const double gyro = node.spin_inertia;
    r.tail<3>() += node.tilt_inertia * alpha + ((node.spin_inertia - node.tilt_inertia) * alpha.dot(n)) * n + gyro * spin * w.cross(n);
    if (!tangent) continue;

    auto d = tangent->diagonal(static_cast<int>(i));
    const Matrix3d nn = n * n.transpose();
    d.topLeftCorner<3, 3>() -= (by_acceleration * added) * nn;
    d.topLeftCorner<3, 3>().diagonal().array() += by_acceleration * mass;
    d.bottomRightCorner<3, 3>() += (by_acceleration * (node.spin_inertia - node.tilt_inertia)) * nn +
                                   (by_rate * gyro) * (w.cross(n) * n.transpose() - spin * skew(n));
    d.bottomRightCorner<3, 3>().diagonal().array() += by_acceleration * node.tilt_inertia;
  }
}

void System::hold_top(double* residual, BlockTridiagonal* tangent) noexcept
{
  const int top = nodes() - 1;
  Eigen::Map<Vector6d> r(residual + 6 * top);
  if (static_)
  {
    top_force_ = r[2];
    top_torque_ = -r[5];
  }
  for (int k = 0; k < 6; ++k)
  {
    const bool free = !static_ && (k == 2 || k == 5);
    if (free) continue;
    r[k] = 0.0;
    if (!tangent) continue;
    tangent->diagonal(top).row(k).setZero();
    tangent->diagonal(top).col(k).setZero();
    tangent->diagonal(top)(k, k) = 1.0;
    tangent->upper(top - 1).col(k).setZero();
    tangent->lower(top - 1).row(k).setZero();
  }
}

void System::finish(SystemState& state) const noexcept
{
  for (std::size_t i = 0; i < scratch_.size(); ++i)
  {
    const NodeScratch& s = scratch_[i];
    NodeState& node = state.nodes[i];
    // vectors across the old normal are carried to the new one
    auto carried = [&](const Vector3d& t)
    {
      const Vector3d moved = t + s.tilt.cross(t);
      return Vector3d(moved - s.normal * s.normal.dot(moved));
    };
    const double spin_rate = s.rate.tail<3>().dot(s.normal_start);
    node.last_rate = {node.rate.velocity, carried(node.rate.tilt), node.rate.spin};
    node.rate = {s.rate.head<3>(), carried(s.rate.tail<3>() - spin_rate * s.normal_start), spin_rate};
    node.last_increment = {s.increment.head<3>(), carried(s.tilt), s.spin};
    const double spin_acceleration = s.acceleration.tail<3>().dot(s.normal_start);
    node.acceleration = {s.acceleration.head<3>(), carried(s.acceleration.tail<3>() - spin_acceleration * s.normal_start), spin_acceleration};
    node.position = s.position;
    node.orientation = s.orientation.normalized();
    node.spin_angle += s.spin;
    node.bristle = s.bristle;
    node.segment = s.closest.segment;
  }
  if (static_) return;  // the top node is held as it was
  // the guide rail holds the shaft upright: round-off of many turns must not tilt it
  Eigen::Quaterniond& shaft = state.nodes.back().orientation;
  shaft = (Eigen::Quaterniond::FromTwoVectors(x_axis(shaft), -Vector3d::UnitZ()) * shaft).normalized();
  state.hoist = hoist_end_;
  state.drive = drive_end_;
  state.bit = bit_end_;
  state.last_step = stage_.time;
  state.time += stage_.time;
}

}  // namespace drill_rig_sim
