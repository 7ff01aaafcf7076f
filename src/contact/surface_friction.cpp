#include "drill_rig_sim/contact/surface_friction.h"

#include "drill_rig_sim/contact/friction_law.h"

namespace drill_rig_sim
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

SurfaceFriction surface_friction(double normal_force, double kinetic, const SurfaceMotion& motion, const Vector2d& bristle, const WallLaw& law,
                                 SurfaceSlopes* slopes) noexcept
{
  SurfaceFriction f;
  const double c = motion.velocity_coefficient;
  const double stiffness = law.tangential_stiffness + c * law.tangential_damping;
  const Vector2d slip = bristle + motion.displacement;
  const Vector2d trial = law.tangential_stiffness * slip + law.tangential_damping * motion.velocity;
  const double size = trial.norm(), speed = motion.velocity.norm();
  f.force = -trial;
  f.bristle = slip;
  if (slopes)
  {
    *slopes = SurfaceSlopes();
    slopes->by_displacement.diagonal().setConstant(-stiffness);
  }
  if (size <= kinetic * normal_force) return f;  // friction is never below kinetic
  const FrictionCoefficient mu = stribeck_friction(kinetic, law.static_ratio, law.stribeck_speed, speed, law.stribeck_curve);
  const double limit = mu.value * normal_force;
  if (size <= limit) return f;

  f.slipping = true;
  const Vector2d direction = trial / size;
  f.force = -limit * direction;
  f.bristle = slipping_bristle(law, motion.time, bristle, Vector2d((limit / law.tangential_stiffness) * direction));
  if (!slopes) return f;
  slopes->by_normal_force = -mu.value * direction;
  // -d (limit q/|q|)
  slopes->by_displacement = (-limit / size * stiffness) * (Matrix2d::Identity() - direction * direction.transpose());
  if (speed > 0.0) slopes->by_displacement -= (mu.slope * normal_force * c / speed) * direction * motion.velocity.transpose();
  return f;
}

}  // namespace drill_rig_sim
