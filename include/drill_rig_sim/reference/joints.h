// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REFERENCE_JOINTS_H
#define DRILL_RIG_SIM_REFERENCE_JOINTS_H

#include <Eigen/Core>
#include <vector>

#include "drill_rig_sim/rig/rigid_body.h"

/// Ideal joints between two rigid bodies a and b: scalar constraints g = 0, two kinds of which make all joints of the rig.
///
///   point: g = e . (x_b + p_b - x_a - p_a)   e a direction of the world, p the joint's place seen from the body's centre
///   angle: g = u_a . w_b                     u, w unit vectors fixed in a and b: they stay at right angles
///
/// With (dx, dtheta) small changes of position and spatial orientation, dg = G (dx_a, dtheta_a, dx_b, dtheta_b), and because that
/// holds for rates too g' = G (v_a, w_a, v_b, w_b). A multiplier lambda puts the force and moment G^T lambda into the
/// balance of momentum, M v' + ... + G^T lambda = ...: lambda pulls the body against growing g.
///   point: G = (-e, -p_a x e, e, p_b x e);   angle: G = (0, c, 0, -c), c = u x w
/// A body index of -1 is the ground.
namespace drill_rig_sim
{
struct Constraint
{
  enum class Kind
  {
    point,
    angle
  };
  Kind kind = Kind::point;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< e, world axes (point only)
  Eigen::Vector3d on_a = Eigen::Vector3d::Zero();        ///< p_a or u, in a's own axes [m] or unit
  Eigen::Vector3d on_b = Eigen::Vector3d::Zero();        ///< p_b or w, in b's own axes
};

/// A joint is a list of constraints between the same two bodies.
struct Joint
{
  int a = -1;
  int b = -1;
  std::vector<Constraint> constraints;
};

using JointRow = Eigen::Matrix<double, 1, 12>;
using JointHessian = Eigen::Matrix<double, 12, 12>;

/// g [m] or [-].
double constraint_value(const Constraint& c, const BodyMotion& a, const BodyMotion& b) noexcept;
/// G, columns (x_a, theta_a, x_b, theta_b).
JointRow constraint_row(const Constraint& c, const BodyMotion& a, const BodyMotion& b) noexcept;
/// d(G^T lambda)/d(x_a, theta_a, x_b, theta_b) at lambda = 1. Not symmetric: rotations are spatial.
JointHessian constraint_hessian(const Constraint& c, const BodyMotion& a, const BodyMotion& b) noexcept;

/// All six: b is welded to a in the pose that they have now.
Joint fixed_joint(int a, const BodyMotion& pose_a, int b, const BodyMotion& pose_b);
/// b slides along the world's z axis without turning, as on a guide rail.
Joint guide_rail(int a, const BodyMotion& pose_a, int b, const BodyMotion& pose_b);
/// b turns about a's x axis, which is b's, at a place fixed in both: five constraints.
Joint revolute_joint(int a, const BodyMotion& pose_a, int b, const BodyMotion& pose_b);
/// b's place is held, b is free to turn: three constraints.
Joint ball_joint(int a, const BodyMotion& pose_a, int b, const BodyMotion& pose_b, const Eigen::Vector3d& place);

}  // namespace drill_rig_sim

#endif
