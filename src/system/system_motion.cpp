// Forces at a motion that somebody else integrates: the same laws as in an implicit stage, without inertia and rig.
#include <algorithm>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/system/system.h"

namespace drill_rig_sim
{
void System::evaluate_motion(const GivenMotion& motion, double* string, double* contact, BlockTridiagonal* string_tangent,
                             BlockTridiagonal* contact_tangent) noexcept
{
  profiler_.lap(Cost::other);
  ++work_.residuals;
  if (string_tangent) ++work_.tangents;
  std::fill(string, string + 6 * nodes(), 0.0);
  std::fill(contact, contact + 6 * nodes(), 0.0);
  stage_at(motion.time);
  for (int i = 0; i < nodes(); ++i) place(i, motion.nodes[i]);
  profiler_.lap(Cost::kinematics);
  if (string_tangent) string_tangent->diagonal(0).setZero();  // the elements write every other block
  add_elements(string, string_tangent);
  profiler_.lap(Cost::elements);
  add_mud_damping(string, string_tangent);
  profiler_.lap(Cost::inertia);
  if (contact_tangent) contact_tangent->set_zero();
  take_bit(motion);
  add_walls(contact, contact_tangent);
  profiler_.lap(Cost::contact);
  add_bit(contact, contact_tangent);
  profiler_.lap(Cost::bit);
  if (start_->stuck_point.node >= 0) add_stuck_point(contact, contact_tangent);
  profiler_.lap(Cost::rig);
}

Vector6d System::evaluate_bit_motion(const GivenMotion& motion) noexcept
{
  Vector6d out = Vector6d::Zero();
  take_bit(motion);
  add_wall(0, out.data(), nullptr);
  add_bit(out.data(), nullptr);
  return out;
}

void System::place(int i, const NodeMotion& motion) noexcept
{
  NodeScratch& s = scratch_[i];
  s.position = motion.position;
  s.orientation = motion.orientation;
  s.normal = x_axis(motion.orientation);
  s.normal_start = s.normal;  // the rates are split by the present normal
  s.increment = motion.moved;
  s.spin = motion.moved.tail<3>().dot(s.normal);
  s.tilt = motion.moved.tail<3>() - s.spin * s.normal;
  s.rate = motion.rate;
  s.acceleration.setZero();
}

/// From here on node 0 stands for the bit.
void System::take_bit(const GivenMotion& motion) noexcept
{
  place(0, motion.bit);
  const double speed = motion.bit.rate.tail<3>().dot(scratch_[0].normal) + motion.motor_speed;
  bit_drive_ = {motion.motor_speed, motion.motor_turn, speed, 0.0, motion.bottom_moved.dot(start_->well.bottom_normal())};
}

void System::note_rig(double hook_load, double meter_torque) noexcept
{
  forces_.hook_load = hook_load;
  forces_.meter_torque = meter_torque;
}

}  // namespace drill_rig_sim
