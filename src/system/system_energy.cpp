// What an energy balance takes from the system: stored energies and every force by its kind, at the state last evaluated or settled.
#include <cmath>

#include "drill_rig_sim/contact/normal_law.h"
#include "drill_rig_sim/contact/wall_contact.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/system/system.h"
#include "stuck_point_stiffness.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
/// k delta^e, the elastic part of the contact's force.
double elastic_force(const ContactLaw& law, double penetration) noexcept
{
  return normal_force({law.stiffness, law.exponent, 0.0}, penetration, 0.0).value;
}

/// Its energy, k delta^(e + 1)/(e + 1).
double contact_energy(const ContactLaw& law, double penetration) noexcept
{
  return penetration > 0.0 ? elastic_force(law, penetration) * penetration / (law.exponent + 1.0) : 0.0;
}

Eigen::Map<Vector6d> node_force(EnergySample& sample, NodeForce kind, int i)
{
  return Eigen::Map<Vector6d>(sample.force[static_cast<std::size_t>(kind)].data() + 6 * i);
}
}  // namespace

bool System::touches_wall(int i) const noexcept
{
  const NodeScratch& s = scratch_[i];
  return i + 1 < nodes() && s.position.z() < 0.0 && wall_gap(s.closest, s.position, mesh_.nodes[i].contact_radius) < 0.0;
}

/// The dead loads' potential, end moments included: the mean place of a cubic element is (x1 + x2)/2 + L/12 (n1 - n2).
double System::weight_potential() const noexcept
{
  double sum = standard_gravity * scene_.rig.hoisting.block_mass * scratch_.back().position.z() +
               standard_gravity * (mesh_.bit_mass - scene_.mud.density * mesh_.bit_displaced * scratch_[0].immersed) * scratch_[0].position.z();
  for (int e = 0; e + 1 < nodes(); ++e)
  {
    const BeamPose pose = element_pose(e);
    const Vector3d mean = 0.5 * (pose.upper_position + pose.lower_position) +
                          mesh_.elements[e].section.length / 12.0 * (pose.upper_normal - pose.lower_normal);
    sum -= loads_[e].dot(mean);
  }
  return sum;
}

StoredEnergy System::stored_energy() const noexcept
{
  StoredEnergy out;
  for (int i = 0; i < nodes(); ++i)
  {
    const MeshNode& node = mesh_.nodes[i];
    const NodeScratch& s = scratch_[i];
    const Vector3d v = s.rate.head<3>(), w = s.rate.tail<3>();
    const double along = v.dot(s.normal_start), spin = w.dot(s.normal_start);
    out.kinetic += 0.5 * (mass_across(i) * v.squaredNorm() - s.immersed * node.added_mass * along * along);
    out.turning += 0.5 * (node.tilt_inertia * w.squaredNorm() + (node.spin_inertia - node.tilt_inertia) * spin * spin);
    if (i + 1 == nodes()) continue;
    out.beams += beam_.energy(mesh_.elements[i].section, element_pose(i));
    out.bristles += 0.5 * contact_[i].tangential_stiffness * s.bristle.squaredNorm();
    if (touches_wall(i)) out.wall += contact_energy(contact_[i].law, -wall_gap(s.closest, s.position, mesh_.nodes[i].contact_radius));
  }
  out.bottom = contact_energy(scene_.string.front().bit->bottom, bottom_.penetration);
  out.bit_bristle = 0.5 * bit_bristle_ * bit_end_.twist * bit_end_.twist;
  if (start_->stuck_point.node >= 0)
  {
    const NodeScratch& s = scratch_[start_->stuck_point.node];
    const double turn = start_->nodes[start_->stuck_point.node].spin_angle + s.spin - start_->stuck_point.spin_angle;
    out.stuck_point = 0.5 * stuck_point_stiffness * (s.position - start_->stuck_point.position).squaredNorm() + 0.5 * stuck_point_torsion * turn * turn;
  }
  const LinePull pull = line_pull(scene_.rig.hoisting, scratch_.back().position.z(), hoist_end_.line_length);
  out.line = 0.5 * pull.tension * pull.tension / scene_.rig.hoisting.line_ea * hoist_end_.line_length;
  const TopDriveSpec& drive = scene_.rig.top_drive;
  out.rotor = 0.5 * drive.inertia * drive_end_.speed * drive_end_.speed;
  out.meter = 0.5 * drive.meter_stiffness * drive_end_.meter_twist * drive_end_.meter_twist;
  out.weight = weight_potential();
  return out;
}

void System::sample_energy(EnergySample& out) noexcept
{
  const std::size_t size = 6 * scratch_.size();
  for (std::vector<double>& force : out.force) force.assign(size, 0.0);
  out.rate.resize(size);
  out.increment.resize(size);
  out.step = stage_.time;
  out.stored = stored_energy();
  sample_elements(out);
  for (int i = 0; i < nodes(); ++i)
  {
    sample_node(i, out);
    if (touches_wall(i)) sample_wall(i, out);
  }
  sample_bit(out);
  sample_rig(out);
  sample_residual(out.force[static_cast<std::size_t>(NodeForce::unsolved)]);
}

void System::sample_elements(EnergySample& out) noexcept
{
  auto add = [&out](NodeForce kind, int e, const BeamForces& f, double sign)
  {
    auto lower = node_force(out, kind, e), upper = node_force(out, kind, e + 1);
    lower.head<3>() += sign * f.force;
    lower.tail<3>() += sign * f.moment_lower;
    upper.head<3>() -= sign * f.force;
    upper.tail<3>() += sign * f.moment_upper;
  };
  for (int e = 0; e + 1 < nodes(); ++e)
  {
    const BeamForces damped = element_forces(e, nullptr);
    BeamStrain strain;
    const BeamPose pose = element_pose(e);
    const BeamForces elastic = beam_.forces(mesh_.elements[e].section, pose, BeamDamping(), Vector3d::Zero(), strain);
    const BeamForces loaded = beam_.forces(mesh_.elements[e].section, pose, BeamDamping(), loads_[e], strain);
    add(NodeForce::beams, e, elastic, 1.0);
    add(NodeForce::structural, e, damped, 1.0);
    add(NodeForce::structural, e, loaded, -1.0);
  }
}

/// Inertia and mud.
void System::sample_node(int i, EnergySample& out) const noexcept
{
  const MeshNode& node = mesh_.nodes[i];
  const NodeScratch& s = scratch_[i];
  const Vector3d& n = s.normal_start;
  const Vector3d a = s.acceleration.head<3>(), alpha = s.acceleration.tail<3>();
  const Vector3d v = s.rate.head<3>(), w = s.rate.tail<3>();
  Eigen::Map<Vector6d>(out.rate.data() + 6 * i) = s.rate;
  Eigen::Map<Vector6d>(out.increment.data() + 6 * i) = s.increment;

  // the gyroscopic moment does no work
  auto inertia = node_force(out, NodeForce::inertia, i);
  inertia.head<3>() = mass_across(i) * a - (s.immersed * node.added_mass * n.dot(a)) * n;
  inertia.tail<3>() = node.tilt_inertia * alpha + ((node.spin_inertia - node.tilt_inertia) * n.dot(alpha)) * n;

  const double length = s.immersed * node.length;
  const MudSpec& mud = scene_.mud;
  auto drag = node_force(out, NodeForce::mud, i);
  drag.head<3>() = length * (mud.lateral_damping * v + ((mud.axial_damping - mud.lateral_damping) * n.dot(v)) * n);
  drag.tail<3>() = (length * mud.torsional_damping * n.dot(w)) * n;
  if (node.squeeze_film_damping > 0.0 && i + 1 < nodes() && s.position.z() < 0.0)
    node_force(out, NodeForce::squeeze_film, i).head<3>() = node.squeeze_film_damping * (v - s.closest.tangent * s.closest.tangent.dot(v));
}

void System::sample_wall(int i, EnergySample& out) noexcept
{
  const NodeScratch& s = scratch_[i];
  const double radius = mesh_.nodes[i].contact_radius;
  const WallForce f = wall_force(i, radius, nullptr);
  const Vector3d across = s.position - s.closest.centre;
  const Vector3d outward = across / std::sqrt(across.squaredNorm() + wall_contact_smoothing * wall_contact_smoothing);
  const double elastic = elastic_force(contact_[i].law, f.penetration);
  const Vector3d along = (elastic * s.closest.radius_slope) * s.closest.md_gradient;
  node_force(out, NodeForce::wall, i).head<3>() = elastic * outward - along;
  node_force(out, NodeForce::ledge, i).head<3>() = along;
  node_force(out, NodeForce::wall_damping, i).head<3>() = (f.normal_force - elastic) * outward;
  auto friction = node_force(out, NodeForce::friction, i);
  friction.head<3>() = -(f.force + f.normal_force * outward);
  friction.tail<3>() = -f.moment;
}

void System::sample_bit(EnergySample& out) const noexcept
{
  const Vector3d down = start_->well.bottom_normal();
  out.bottom_elastic = elastic_force(scene_.string.front().bit->bottom, bottom_.penetration);
  out.bottom_damped = bottom_.value - out.bottom_elastic;
  out.bottom = out.bottom_elastic * down;
  out.bottom_damping = out.bottom_damped * down;
  out.rock_speed = bottom_.speed;
  out.rock_advance = bottom_.advance;
  out.bit_torque = forces_.bit_torque;
  out.bit_speed = forces_.bit_speed;
  out.gauge_torque = node_force(out, NodeForce::friction, 0).tail<3>().dot(scratch_[0].normal_start);
  out.motor_speed = start_->bit.motor_speed;
  out.motor_flow_speed = motor_ ? 2.0 * pi * start_->flow / motor_->displacement_per_rev : 0.0;
  out.stuck_node = start_->stuck_point.node;
  if (out.stuck_node < 0) return;
  const NodeScratch& s = scratch_[out.stuck_node];
  const double turn = start_->nodes[out.stuck_node].spin_angle + s.spin - start_->stuck_point.spin_angle;
  out.stuck_point << stuck_point_stiffness * (s.position - start_->stuck_point.position), stuck_point_torsion * turn * s.normal_start;
}

void System::sample_rig(EnergySample& out) const noexcept
{
  const HoistingSpec& spec = scene_.rig.hoisting;
  const double height = scratch_.back().position.z();
  const LinePull pull = line_pull(spec, height, hoist_end_.line_length);
  out.hook_force = pull.hook_force;
  out.line_price = pull.tension * (1.0 + 0.5 * pull.tension / spec.line_ea);
  out.line_length = hoist_end_.line_length;
  out.line_length_start = start_->hoist.line_length;
  out.pay_out = -2.0 * spec.sheaves * hoist_end_.winch_speed * hoist_end_.line_length / strung_length(spec, height);
  out.meter_torque = forces_.meter_torque;
  out.drive_torque = forces_.drive_torque;
  out.rotor_speed = drive_end_.speed;
  out.rotor_inertia = scene_.rig.top_drive.inertia * drive_end_.acceleration;
  out.rotor_increment = drive_end_.last_increment;
}

/// The whole residual as the methods see it, not the sum of what this file takes apart: a force that is missing here would show.
void System::sample_residual(std::vector<double>& out) noexcept
{
  kept_scratch_ = scratch_;
  kept_forces_ = forces_;
  const HoistState hoist = hoist_end_;
  const DriveState drive = drive_end_;
  const BitState bit = bit_end_;
  const BottomForce bottom = bottom_;
  assemble(out.data(), nullptr);
  std::swap(scratch_, kept_scratch_);
  std::swap(forces_, kept_forces_);
  hoist_end_ = hoist;
  drive_end_ = drive;
  bit_end_ = bit;
  bottom_ = bottom;
}

}  // namespace drill_rig_sim
