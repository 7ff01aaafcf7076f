// Wall contact and stuck point: the parts of the system that hold the string in the hole.
#include "drill_rig_sim/contact/wall_contact.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/system/system.h"
#include "stuck_point_stiffness.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

namespace
{
SlidingMotion sliding_of(FrictionMode mode)
{
  switch (mode)
  {
    case FrictionMode::up:
      return {-1.0, 0.0};
    case FrictionMode::down:
      return {1.0, 0.0};
    case FrictionMode::rotate:
      return {0.0, 1.0};
    default:
      return {};
  }
}
}  // namespace

void System::add_walls(double* residual, BlockTridiagonal* tangent) noexcept
{
  // the last node is the top drive's shaft, above the table
  for (int i = 0; i + 1 < nodes(); ++i) add_wall(i, residual, tangent);
}

void System::add_wall(int i, double* residual, BlockTridiagonal* tangent) noexcept
{
  NodeScratch& s = scratch_[i];
  forces_.contact[i] = 0.0;
  forces_.wall[i].setZero();
  if (i == 0) forces_.bit_moment.setZero();
  if (s.position.z() >= 0.0)
  {
    s.bristle.setZero();
    return;
  }
  const double radius = mesh_.nodes[i].contact_radius;
  s.closest = start_->well.locate(s.position, s.closest.segment);
  if (!static_ && mesh_.nodes[i].squeeze_film_damping > 0.0) add_squeeze_film(i, residual, tangent);
  if (wall_gap(s.closest, s.position, radius) >= 0.0)
  {
    s.bristle.setZero();
    return;
  }
  Matrix6d block;
  const WallForce f = wall_force(i, radius, tangent ? &block : nullptr);
  Eigen::Map<Vector6d> r(residual + 6 * i);
  r.head<3>() -= f.force;
  r.tail<3>() -= f.moment;
  s.bristle = f.bristle;
  forces_.contact[i] = f.normal_force;
  forces_.wall[i] = f.force;
  if (i == 0) forces_.bit_moment = f.moment;
  if (tangent) tangent->diagonal(i) -= block;
}

/// Damping of motion across the hole; across the hole, not across the part: a tilted bit that slides does not glide up on it.
void System::add_squeeze_film(int i, double* residual, BlockTridiagonal* tangent) noexcept
{
  const NodeScratch& s = scratch_[i];
  const double damping = mesh_.nodes[i].squeeze_film_damping;
  const Matrix3d across = Matrix3d::Identity() - s.closest.tangent * s.closest.tangent.transpose();
  Eigen::Map<Vector6d> r(residual + 6 * i);
  r.head<3>() += damping * (across * s.rate.head<3>());
  if (tangent) tangent->diagonal(i).topLeftCorner<3, 3>() += (stage_.dv_du * damping) * across;
}

WallForce System::wall_force(int i, double radius, Matrix6d* block) noexcept
{
  const NodeScratch& s = scratch_[i];
  if (static_)
  {
    Matrix6d unused;
    return sliding_wall_contact(s.closest, radius, s.position, sliding_of(friction_), contact_[i].law, block ? *block : unused);
  }
  ContactMotion motion;
  motion.position = s.position;
  motion.displacement = s.increment.head<3>();
  motion.rotation = s.increment.tail<3>();
  motion.velocity = s.rate.head<3>();
  motion.angular_velocity = s.rate.tail<3>();
  motion.velocity_coefficient = stage_.dv_du;
  if (i == 0)  // the bit turns with the motor
  {
    motion.rotation += bit_drive_.motor_turn * s.normal_start;
    motion.angular_velocity += bit_drive_.motor_speed * s.normal_start;
  }
  const Vector3d& bristle = start_->nodes[i].bristle;
  return block ? wall_contact(s.closest, radius, motion, bristle, contact_[i], *block)
               : wall_contact(s.closest, radius, motion, bristle, contact_[i]);
}

void System::add_stuck_point(double* residual, BlockTridiagonal* tangent) noexcept
{
  const StuckPointState& held = start_->stuck_point;
  const NodeScratch& s = scratch_[held.node];
  Eigen::Map<Vector6d> r(residual + 6 * held.node);
  const Vector3d& n = s.normal_start;
  r.head<3>() += stuck_point_stiffness * (s.position - held.position);
  r.tail<3>() += stuck_point_torsion * (start_->nodes[held.node].spin_angle + s.spin - held.spin_angle) * n;
  if (!tangent) return;
  auto d = tangent->diagonal(held.node);
  d.topLeftCorner<3, 3>().diagonal().array() += stuck_point_stiffness;
  d.bottomRightCorner<3, 3>() += stuck_point_torsion * n * n.transpose();
}

}  // namespace drill_rig_sim
