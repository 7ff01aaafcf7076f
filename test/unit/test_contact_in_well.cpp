// SPDX-License-Identifier: BSD-3-Clause
// Wall contact in a real, curved well: the tangent through the hole's own location, and the energy of a frictionless slide.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "drill_rig_sim/contact/wall_contact.h"
#include "well_fixtures.h"

namespace drill_rig_sim::test_contact_in_well
{
namespace
{
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double radius = 0.084;
constexpr double rate = 200.0;

Vector6d wrench_at(const Wellbore& well, const Vector3d& start, const Vector3d& bristle, const Vector6d& u, Matrix6d* tangent)
{
  ContactMotion m;
  m.displacement = u.head<3>();
  m.rotation = u.tail<3>();
  m.position = start + m.displacement;
  m.velocity = rate * m.displacement + Vector3d(0.01, -0.02, 0.03);
  m.angular_velocity = rate * m.rotation + Vector3d(0.1, 0.3, -0.2);
  m.velocity_coefficient = rate;
  const ClosestPoint closest = well.locate(m.position, -1);
  WallLaw law = wall_law(ContactSpec(), ContactLaw(), 1.0, 0.0);
  law.stribeck_speed = 0.05;
  law.tangential_damping = 1e3;  // of a section that moves at some 0.05 m/s: it may stick
  const WallForce f =
      tangent ? wall_contact(closest, radius, m, bristle, law, *tangent) : wall_contact(closest, radius, m, bristle, law);
  Vector6d out;
  out << f.force, f.moment;
  return out;
}

TEST(WallContactInWell, TangentInTheBuildSection)
{
  const Wellbore well(bohai_well(), TrajectorySpec{}, 0.1556);
  for (double md : {250.0, 431.7, 655.0, 725.0})
  {
    for (const Vector3d& bristle : {Vector3d(0, 0, 0), Vector3d(4e-4, -3e-4, 6e-4)})
    {
      const WellNode axis = well.at(md);
      const Vector3d side = axis.tangent.cross(Vector3d(0.3, 0.5, 0.1)).normalized();
      const Vector3d start = axis.position + (axis.radius - radius + 0.002) * side;
      Vector6d u;
      u << 2e-5, -3e-5, 1e-5, 1e-3, -2e-3, 2e-3;
      Matrix6d tangent;
      wrench_at(well, start, bristle, u, &tangent);

      Matrix6d numeric;
      const double h = 1e-5;  // 600 m from the origin a position has 13 digits after the metre: no finer
      for (int j = 0; j < 6; ++j)
      {
        const Vector6d e = h * Vector6d::Unit(j);
        const auto at = [&](double x) { return wrench_at(well, start, bristle, u + x * e, nullptr); };
        numeric.col(j) = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h);
      }
      EXPECT_LT((tangent - numeric).norm(), 1e-6 * numeric.norm()) << "md " << md;
    }
  }
}

TEST(WallContactInWell, FrictionlessSlideKeepsItsEnergy)
{
  // A ring let go on the low side at 450 m slides to 720 m; normal forces do no work along the hole. Undamped, velocity Verlet.
  WellSpec spec = bohai_well();
  for (HoleSection& section : spec.sections)
  {
    section.friction = 0.0;
  }
  const Wellbore well(spec, TrajectorySpec{}, 0.1556);
  WallLaw law = wall_law(ContactSpec(), ContactLaw(), 1.0, 0.0);
  law.law.damping = 0.0;
  const double mass = 300.0;
  const double h = 2e-4;

  const WellNode axis = well.at(450.0);
  const Vector3d low_side = (-Vector3d::UnitZ() + axis.tangent * axis.tangent.z()).normalized();
  ContactMotion m;
  m.position = axis.position + (axis.radius - radius) * low_side;
  ClosestPoint closest = well.locate(m.position, -1);
  WallForce wall;
  const auto energy = [&]
  {
    const double stored = law.law.stiffness * std::pow(std::max(0.0, wall.penetration), 2.5) / 2.5;
    return 0.5 * mass * m.velocity.squaredNorm() + mass * standard_gravity * m.position.z() + stored;
  };
  const double top = m.position.z();
  const double before = energy();
  while (closest.md < 720.0)
  {
    m.position += 0.5 * h * m.velocity;
    closest = well.locate(m.position, closest.segment);
    wall = wall_contact(closest, radius, m, Vector3d::Zero(), law);
    m.velocity += h * (wall.force / mass - standard_gravity * Vector3d::UnitZ());
    m.position += 0.5 * h * m.velocity;
  }
  wall = wall_contact(well.locate(m.position, -1), radius, m, Vector3d::Zero(), law);
  const double drop = mass * standard_gravity * (top - m.position.z());
  EXPECT_GT(drop, 100e3);  // some 190 m
  EXPECT_NEAR(energy(), before, 1e-4 * drop);
  EXPECT_NEAR(m.velocity.norm(), std::sqrt(2.0 * drop / mass), 0.01 * m.velocity.norm());
}

}  // namespace
}  // namespace drill_rig_sim::test_contact_in_well
