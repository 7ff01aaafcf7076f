// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/contact/surface_friction.h"

#include "drill_rig_sim/contact/one_lane_friction.h"

namespace drill_rig_sim
{
SurfaceFriction surface_friction(double normal_force, double kinetic, const SurfaceMotion& motion, const Eigen::Vector2d& bristle,
                                 const WallLaw& law, SurfaceSlopes* slopes) noexcept
{
  using one_lane::V2;
  const one_lane::Rubbing rubbing = rubbing_of(law, kinetic);
  const V2 velocity = one_lane::from(motion.velocity), before = one_lane::from(bristle),
           stretched = before + one_lane::from(motion.displacement);
  const V2 trial = mul_add(rubbing.stiffness, stretched, rubbing.damping * velocity);
  const one_lane::Rubbed<V2> r = one_lane::rubbed(
      rubbing, normal_force, trial, stretched, [&] { return velocity; }, [&] { return before; }, motion.time);
  if (slopes)
  {
    const one_lane::RubbedSlopes by = one_lane::slopes_of(rubbing, normal_force, r, velocity, motion.velocity_coefficient);
    slopes->by_displacement << by.first_row.x, by.first_row.y, by.second_row.x, by.second_row.y;
    slopes->by_normal_force = one_lane::to_eigen(by.by_normal_force);
  }
  return {one_lane::to_eigen(r.force), one_lane::to_eigen(r.bristle), r.slipping};
}

}  // namespace drill_rig_sim
