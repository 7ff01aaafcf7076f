// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_FIXTURES_H
#define DRILL_RIG_SIM_CONTACT_FIXTURES_H

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "drill_rig_sim/contact/wall_contact.h"
#include "drill_rig_sim/math/units.h"

/// Holes located in closed form, one stage of a contact, its tangent by differences, and a block on a slope.
namespace drill_rig_sim
{
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Eigen::Vector3d;

/// A straight hole along t with linear taper, located in closed form.
struct StraightHole
{
  Vector3d origin = Vector3d::Zero();
  Vector3d tangent = -Vector3d::UnitZ();
  double radius = 0.1;
  double radius_slope = 0.0;
  double friction = 0.3;

  ClosestPoint locate(const Vector3d& p) const
  {
    ClosestPoint closest;
    closest.md = (p - origin).dot(tangent);
    closest.centre = origin + closest.md * tangent;
    closest.tangent = closest.centre_slope = closest.md_gradient = tangent;
    closest.radius = radius + radius_slope * closest.md;
    closest.radius_slope = radius_slope;
    closest.friction = friction;
    return closest;
  }
};

/// A hole along a circular arc about the origin in the x-z plane, located in closed form.
struct ArcHole
{
  double curvature_radius = 5.0;  // far sharper than any well: curvature terms must show
  double radius = 0.1;
  double friction = 0.3;

  ClosestPoint locate(const Vector3d& p) const
  {
    const double angle = std::atan2(-p.z(), p.x());
    const Vector3d outward(std::cos(angle), 0.0, -std::sin(angle));
    ClosestPoint closest;
    closest.md = angle * curvature_radius;
    closest.centre = curvature_radius * outward;
    closest.tangent = closest.centre_slope = Vector3d(-std::sin(angle), 0.0, -std::cos(angle));
    // c'' = -outward / Rc
    closest.md_gradient = closest.tangent / (1.0 + (p - closest.centre).dot(outward) / curvature_radius);
    closest.radius = radius;
    closest.friction = friction;
    return closest;
  }
};

/// A straight hole that leans across both axes.
inline StraightHole leaning_hole()
{
  StraightHole hole;
  hole.tangent = Vector3d(0.3, -0.2, -1.0).normalized();
  return hole;
}

/// Places where a section of 0.08 m radius is pressed 1.5 mm into a wall of 0.1 m radius.
inline Vector3d at_the_wall(const StraightHole& hole)
{
  return 2.0 * hole.tangent + 0.0215 * hole.tangent.cross(Vector3d::UnitY()).normalized();
}

inline Vector3d at_the_wall(const ArcHole& arc)
{
  return arc.locate({4.0, 0.0, -3.0}).centre + 0.0215 * Vector3d(0.48, 0.8, -0.36);
}

/// The defaults' law where 320 kg rest on the wall.
inline WallLaw usual_law()
{
  return {ContactLaw(), 0.05, 1.2, 5e6, 2e4};
}

/// One stage from a fixed start of the step: everything as a function of u = (x, r).
struct ContactStage
{
  Vector3d start = Vector3d::Zero();
  Vector3d velocity_0 = Vector3d::Zero();
  Vector3d angular_velocity_0 = Vector3d::Zero();
  Vector3d bristle = Vector3d::Zero();
  double coefficient = 200.0;
  double radius = 0.08;
  WallLaw law = usual_law();

  ContactMotion motion(const Vector6d& u) const
  {
    ContactMotion m;
    m.displacement = u.head<3>();
    m.rotation = u.tail<3>();
    m.position = start + m.displacement;
    m.velocity = coefficient * m.displacement + velocity_0;
    m.angular_velocity = coefficient * m.rotation + angular_velocity_0;
    m.velocity_coefficient = coefficient;
    m.time = 1.0 / coefficient;
    return m;
  }
};

inline Vector6d wrench(const WallForce& f)
{
  Vector6d w;
  w << f.force, f.moment;
  return w;
}

/// Central differences of fourth order.
inline Matrix6d difference(const std::function<Vector6d(const Vector6d&)>& f, const Vector6d& u, double step)
{
  Matrix6d out;
  for (int j = 0; j < 6; ++j)
  {
    const Vector6d e = step * Vector6d::Unit(j);
    out.col(j) = (8.0 * (f(u + e) - f(u - e)) - (f(u + 2.0 * e) - f(u - 2.0 * e))) / (12.0 * step);
  }
  return out;
}

template <class Hole>
void expect_tangent(const Hole& hole, const ContactStage& stage, const Vector6d& u, bool slipping, double step = 1e-6)
{
  const auto force = [&](const Vector6d& v)
  {
    const ContactMotion m = stage.motion(v);
    return wrench(wall_contact(hole.locate(m.position), stage.radius, m, stage.bristle, stage.law));
  };
  const ContactMotion m = stage.motion(u);
  Matrix6d tangent;
  const WallForce f = wall_contact(hole.locate(m.position), stage.radius, m, stage.bristle, stage.law, tangent);
  ASSERT_GT(f.normal_force, 0.0);
  ASSERT_EQ(f.slipping, slipping);
  EXPECT_EQ(wrench(f), force(u));  // with and without tangent: the same numbers
  const Matrix6d numeric = difference(force, u, step);
  EXPECT_LT((tangent - numeric).norm(), 1e-6 * numeric.norm()) << tangent << "\n\n" << numeric;
}

inline ContactStage touching_stage(const Vector3d& where)
{
  ContactStage stage;
  stage.start = where;
  stage.velocity_0 << 0.02, -0.05, 0.03;
  stage.angular_velocity_0 << 0.3, 0.2, -5.0;
  return stage;
}

/// A block on the low side of a straight hole inclined by I, one axial and one normal degree of freedom, implicit Euler with the
/// contact's own tangent; returns the axial displacement, + down the hole.
class BlockOnSlope
{
public:
  BlockOnSlope(double inclination, double friction) : inclination_(inclination)
  {
    hole_.tangent << std::sin(inclination), 0.0, -std::cos(inclination);
    hole_.friction = friction;
    low_side_ << -std::cos(inclination), 0.0, -std::sin(inclination);
    position_ = 0.02 * low_side_;
  }

  /// `push` presses the block on the low side, on top of its weight [N].
  void step(double h, double push = 0.0)
  {
    const Vector3d gravity = Vector3d(0.0, 0.0, -mass_ * standard_gravity) + push * low_side_;
    Vector6d u = Vector6d::Zero();
    ContactStage stage;
    stage.start = position_;
    stage.bristle = bristle_;
    stage.coefficient = 1.0 / h;
    stage.law = law_;
    WallForce f;
    Matrix6d tangent;
    for (int i = 0; i < 30; ++i)
    {
      const ContactMotion m = stage.motion(u);
      f = wall_contact(hole_.locate(m.position), stage.radius, m, bristle_, law_, tangent);
      const Vector3d residual = mass_ / h * (m.velocity - velocity_) - f.force - gravity;
      const Eigen::Matrix3d k = mass_ / (h * h) * Eigen::Matrix3d::Identity() - tangent.topLeftCorner<3, 3>();
      const Vector3d du = -k.inverse() * residual;
      u.head<3>() += du;
      if (du.norm() < 1e-15)
      {
        break;
      }
    }
    position_ += u.head<3>();
    velocity_ = u.head<3>() / h;
    bristle_ = f.bristle;
    force_ = f;
  }

  void throw_down(double speed) { velocity_ += speed * hole_.tangent; }
  double travel() const { return position_.dot(hole_.tangent); }
  double speed() const { return velocity_.dot(hole_.tangent); }
  const WallForce& force() const { return force_; }
  WallLaw& law() { return law_; }

private:
  double inclination_;
  double mass_ = 300.0;
  StraightHole hole_;
  WallLaw law_ = usual_law();
  Vector3d low_side_;
  Vector3d position_;
  Vector3d velocity_ = Vector3d::Zero();
  Vector3d bristle_ = Vector3d::Zero();
  WallForce force_;
};

}  // namespace drill_rig_sim

#endif
