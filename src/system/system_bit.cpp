// The bit on the bottom: weight, torque, and the velocity at which the rock gives way.
#include <cmath>

#include "drill_rig_sim/contact/bit_bottom.h"
#include "drill_rig_sim/contact/bit_torque.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/rig/mud_motor.h"
#include "drill_rig_sim/system/system.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

void System::add_bit(double* residual, BlockTridiagonal* tangent) noexcept
{
  const BitSpec& bit = *scene_.string.front().bit;
  const NodeScratch& s = scratch_[0];
  const BitState& start = start_->bit;
  const Vector3d down = start_->well.bottom_normal();
  const Vector3d to_bottom = start_->well.bottom_position() - s.position;
  const Vector3d& n = s.normal_start;
  forces_.bit_speed = static_ ? 0.0 : s.rate.tail<3>().dot(n) + bit_drive_.motor_speed;

  const FormationLayer& rock = formation_.at(-start_->well.bottom_position().z());
  RockBreaking breaking;
  if (!static_) breaking = {drilling_coefficient(rock, bit_drive_.drilling_speed), rock.weight_exponent, rock.threshold};
  const double rock_time = static_ ? 0.0 : bit_drive_.rock_time;
  const double approach = mesh_.bit_radius - to_bottom.dot(down) - (static_ ? 0.0 : bit_drive_.bottom_moved);
  const double rate = static_ ? 0.0 : s.rate.head<3>().dot(down);
  const BottomForce bottom = bit_bottom_force(bit.bottom, approach, rate, breaking, rock_time);
  bottom_ = bottom;

  BitTorque torque;
  if (static_)
    torque.value = bottom.value > 0.0 ? scene_.start.torque_on_bit : 0.0;
  else if (bottom.value > 0.0)
    torque = bit_torque(bit_torque_limit(bit.torque, bit.diameter, bottom.value, forces_.bit_speed, rock), bit_bristle_, start.twist,
                        s.spin + bit_drive_.motor_turn, forces_.bit_speed, stage_.dv_du);

  Eigen::Map<Vector6d> r(residual);
  r.head<3>() += bottom.value * down;
  r.tail<3>() += torque.value * n;
  r[2] += standard_gravity * (mesh_.bit_mass - scene_.mud.density * mesh_.bit_displaced * s.immersed);
  if (tangent && bottom.value > 0.0)
  {
    const double stiffness = bottom.stiffness + (static_ ? 0.0 : stage_.dv_du * bottom.damping);
    auto d = tangent->diagonal(0);
    d.topLeftCorner<3, 3>() += stiffness * down * down.transpose();
    d.bottomLeftCorner<3, 3>() += (torque.force_slope * stiffness) * n * down.transpose();
    d.bottomRightCorner<3, 3>() += torque.spin_slope * n * n.transpose();
  }

  forces_.wob = bottom.value;
  forces_.bit_torque = torque.value;
  forces_.bit_force = forces_.wall[0] - bottom.value * down;
  forces_.bit_moment -= torque.value * n;  // add_walls() left the gauge's share
  Vector3d outward = s.position - s.closest.centre;
  const double offset = std::sqrt(outward.squaredNorm() + wall_contact_smoothing * wall_contact_smoothing);  // as the wall's law has it
  forces_.rock_force = bottom.value * down;
  if (forces_.contact[0] > 0.0) forces_.rock_force += (forces_.contact[0] / offset) * outward;
  if (static_) return;

  bit_end_ = start;
  bit_end_.twist = torque.twist;
  bit_end_.turned += bit_drive_.motor_turn;
  if (motor_)
  {
    bit_end_.motor_speed = advance_mud_motor(start.motor_speed, steady_motor_speed(), stage_.time);
    bit_end_.stalled = mud_motor_stalled(start_->flow, motor_->stall_torque, torque.value);
  }
}

Vector3d System::rock_velocity(const SystemState& state) const noexcept
{
  return rock_velocity_at(state.well, x_axis(state.nodes[0].orientation));
}

Vector3d System::rock_velocity() const noexcept
{
  return rock_velocity_at(start_->well, scratch_[0].normal);
}

Vector3d System::rock_velocity_at(const Wellbore& well, const Vector3d& bit_axis) const noexcept
{
  if (forces_.wob <= 0.0) return Vector3d::Zero();
  const FormationLayer& rock = formation_.at(-well.bottom_position().z());
  return rock_breaking_velocity(rock, forces_.rock_force, forces_.bit_speed, bit_axis, scene_.string.front().bit->side_cutting);
}

double System::steady_motor_speed() const noexcept
{
  if (!motor_) return 0.0;
  return mud_motor_steady_speed(start_->flow, motor_->displacement_per_rev, motor_->stall_torque, forces_.bit_torque);
}

}  // namespace drill_rig_sim
