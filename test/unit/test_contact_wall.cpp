// Wall contact: closed forms, consistent tangents, sticking without creep, competition of axial and circumferential friction.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <random>

#include "drill_rig_sim/contact/friction_law.h"
#include "drill_rig_sim/contact/normal_law.h"
#include "drill_rig_sim/contact/wall_contact.h"

namespace drill_rig_sim
{
namespace
{
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// A straight hole along t with linear taper, located in closed form.
struct StraightHole
{
  Vector3d origin = Vector3d::Zero();
  Vector3d tangent = -Vector3d::UnitZ();
  double radius = 0.1;
  double radius_slope = 0.0;
  double friction = 0.3;

  HoleSite locate(const Vector3d& p) const
  {
    HoleSite site;
    site.md = (p - origin).dot(tangent);
    site.centre = origin + site.md * tangent;
    site.tangent = site.centre_slope = site.md_gradient = tangent;
    site.radius = radius + radius_slope * site.md;
    site.radius_slope = radius_slope;
    site.friction = friction;
    return site;
  }
};

/// A hole along a circular arc about the origin in the x-z plane, located in closed form.
struct ArcHole
{
  double curvature_radius = 5.0;  // far sharper than any well: curvature terms must show
  double radius = 0.1;
  double friction = 0.3;

  HoleSite locate(const Vector3d& p) const
  {
    const double angle = std::atan2(-p.z(), p.x());
    const Vector3d outward(std::cos(angle), 0.0, -std::sin(angle));
    HoleSite site;
    site.md = angle * curvature_radius;
    site.centre = curvature_radius * outward;
    site.tangent = site.centre_slope = Vector3d(-std::sin(angle), 0.0, -std::cos(angle));
    // c'' = -outward / Rc
    site.md_gradient = site.tangent / (1.0 + (p - site.centre).dot(outward) / curvature_radius);
    site.radius = radius;
    site.friction = friction;
    return site;
  }
};

/// One stage from a fixed start of the step: everything as a function of u = (x, r).
struct Stage
{
  Vector3d start = Vector3d::Zero();
  Vector3d velocity_0 = Vector3d::Zero();
  Vector3d angular_velocity_0 = Vector3d::Zero();
  Vector3d bristle = Vector3d::Zero();
  double coefficient = 200.0;
  double radius = 0.08;
  ContactSpec law;

  ContactMotion motion(const Vector6d& u) const
  {
    ContactMotion m;
    m.displacement = u.head<3>();
    m.rotation = u.tail<3>();
    m.position = start + m.displacement;
    m.velocity = coefficient * m.displacement + velocity_0;
    m.angular_velocity = coefficient * m.rotation + angular_velocity_0;
    m.velocity_coefficient = coefficient;
    return m;
  }
};

Vector6d wrench(const WallForce& f)
{
  Vector6d w;
  w << f.force, f.moment;
  return w;
}

/// Central differences of fourth order.
Matrix6d difference(const std::function<Vector6d(const Vector6d&)>& f, const Vector6d& u, double step)
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
void expect_tangent(const Hole& hole, const Stage& stage, const Vector6d& u, bool slipping, double step = 1e-6)
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

Stage touching_stage(const Vector3d& where)
{
  Stage stage;
  stage.start = where;
  stage.velocity_0 << 0.02, -0.05, 0.03;
  stage.angular_velocity_0 << 0.3, 0.2, -5.0;
  return stage;
}

TEST(WallContact, ClearOfTheWallIsZero)
{
  StraightHole hole;
  Stage stage = touching_stage({0.01, 0.005, -3.0});
  const ContactMotion m = stage.motion(Vector6d::Zero());
  Matrix6d tangent = Matrix6d::Ones();
  const HoleSite site = hole.locate(m.position);
  const WallForce f = wall_contact(site, stage.radius, m, Vector3d(1e-3, 0, 0), stage.law, tangent);
  EXPECT_TRUE(wrench(f).isZero(0.0));
  EXPECT_TRUE(tangent.isZero(0.0));
  EXPECT_TRUE(f.bristle.isZero(0.0));
  EXPECT_EQ(f.normal_force, 0.0);
  EXPECT_NEAR(wall_gap(site, m.position, stage.radius), 0.02 - std::hypot(0.01, 0.005), 1e-12);
  EXPECT_EQ(f.penetration, -wall_gap(site, m.position, stage.radius));
}

TEST(WallContact, RestingOnTheWallFollowsHertz)
{
  StraightHole hole;
  Stage stage;
  stage.start << 0.0213, 0.0, -3.0;  // delta = 1.3 mm towards +x
  const ContactMotion m = stage.motion(Vector6d::Zero());
  const WallForce f = wall_contact(hole.locate(m.position), stage.radius, m, Vector3d::Zero(), stage.law);
  const double expected = 5e7 * std::pow(0.0013, 1.5);
  EXPECT_NEAR(f.force.x(), -expected, 1e-8 * expected);
  EXPECT_EQ(f.force.y(), 0.0);
  EXPECT_EQ(f.force.z(), 0.0);
  EXPECT_FALSE(f.slipping);
}

TEST(WallContact, DampingNeverPulls)
{
  StraightHole hole;
  Stage stage;
  stage.start << 0.0213, 0.0, -3.0;
  stage.velocity_0 << 2.0, 0.0, 0.0;
  const auto normal = [&]
  {
    const ContactMotion m = stage.motion(Vector6d::Zero());
    return wall_contact(hole.locate(m.position), stage.radius, m, Vector3d::Zero(), stage.law).normal_force;
  };
  const double elastic = 5e7 * std::pow(0.0013, 1.5);
  EXPECT_NEAR(normal(), elastic * (1.0 + 0.3 * 2.0), 1e-8 * elastic);
  stage.velocity_0 << -100.0, 0.0, 0.0;
  EXPECT_EQ(normal(), 0.0);
}

TEST(WallContact, TangentSticking)
{
  StraightHole hole;
  hole.tangent = Vector3d(0.3, -0.2, -1.0).normalized();
  const Vector3d side = hole.tangent.cross(Vector3d::UnitY()).normalized();
  Stage stage = touching_stage(2.0 * hole.tangent + 0.0215 * side);
  stage.bristle << 1e-5, -2e-5, 3e-5;
  Vector6d u;
  u << 2e-5, -4e-5, 3e-5, 1e-4, -2e-4, 3e-4;
  expect_tangent(hole, stage, u, false);

  ArcHole arc;
  const Vector3d at = arc.locate({4.0, 0.0, -3.0}).centre;
  stage.start = at + 0.0215 * Vector3d(0.48, 0.8, -0.36);
  expect_tangent(arc, stage, u, false);
}

TEST(WallContact, TangentSlipping)
{
  StraightHole hole;
  hole.tangent = Vector3d(0.3, -0.2, -1.0).normalized();
  hole.radius_slope = -0.004;  // taper; 0.1 m where the section stands
  hole.radius = 0.108;
  const Vector3d side = hole.tangent.cross(Vector3d::UnitY()).normalized();
  Stage stage = touching_stage(2.0 * hole.tangent + 0.0215 * side);
  stage.bristle << 4e-4, -2e-4, 3e-4;
  stage.law.stribeck_speed = 0.5;  // so that its slope counts
  Vector6d u;
  u << 2e-4, -4e-4, 3e-4, 1e-3, -2e-3, 3e-3;
  expect_tangent(hole, stage, u, true);

  ArcHole arc;
  const Vector3d at = arc.locate({4.0, 0.0, -3.0}).centre;
  stage.start = at + 0.0215 * Vector3d(0.48, 0.8, -0.36);
  expect_tangent(arc, stage, u, true);
  stage.law.law.exponent = 1.8;
  expect_tangent(arc, stage, u, true);
  arc.friction = 0.0;
  expect_tangent(arc, stage, u, true);
}

TEST(WallContact, TangentAtRandomStates)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  ArcHole arc;
  int sticking = 0;
  int slipping = 0;
  for (int i = 0; i < 200; ++i)
  {
    Stage stage;
    const double angle = 3.0 * uniform(random);
    const HoleSite site = arc.locate({4.0, 0.0, -3.0});
    const Vector3d across = site.tangent.cross(Vector3d::UnitY());
    stage.start =
        site.centre + (0.022 + 5e-4 * uniform(random)) * (std::cos(angle) * across + std::sin(angle) * Vector3d::UnitY());
    stage.velocity_0 = 0.3 * vector();
    stage.angular_velocity_0 = 5.0 * vector();
    stage.bristle = 3e-4 * vector();
    Vector6d u;
    u << 1e-4 * vector(), 1e-2 * vector();

    const ContactMotion m = stage.motion(u);
    const WallForce f = wall_contact(arc.locate(m.position), stage.radius, m, stage.bristle, stage.law);
    // away from the switch only: the kink itself has no derivative
    const double pull = stage.law.tangential_stiffness * f.bristle.norm();
    if (!f.slipping && pull > 0.95 * arc.friction * f.normal_force)
    {
      continue;
    }
    ++(f.slipping ? slipping : sticking);
    expect_tangent(arc, stage, u, f.slipping);
  }
  EXPECT_GT(sticking, 20);
  EXPECT_GT(slipping, 20);
}

TEST(WallContact, TangentWithZeroClearance)
{
  // gauge in its own hole, 0.1 mm off centre: friction is small, the normal direction turns fast
  StraightHole hole;
  Stage stage = touching_stage({8e-5, 6e-5, -1.0});
  stage.radius = hole.radius;
  stage.velocity_0 << 1e-3, 2e-3, 0.01;
  stage.law.tangential_stiffness = 1e4;
  stage.bristle << 1e-5, -2e-5, 2e-5;
  Vector6d u;
  u << 1e-6, 2e-6, -3e-5, 1e-5, 2e-5, -1e-3;
  expect_tangent(hole, stage, u, false, 1e-7);
  stage.law.tangential_stiffness = 5e6;
  expect_tangent(hole, stage, u, true, 1e-7);
}

TEST(WallContact, ZeroClearanceIsSmoothThroughTheCentre)
{
  StraightHole hole;
  hole.friction = 0.3;
  Stage stage;
  stage.radius = hole.radius;
  stage.start << 0.0, 0.0, -1.0;
  Matrix6d tangent;
  for (double x : {0.0, 1e-12, 1e-9, 1e-7, 1e-6, 1e-4})
  {
    stage.start.x() = x;
    const ContactMotion m = stage.motion(Vector6d::Zero());
    const WallForce f = wall_contact(hole.locate(m.position), stage.radius, m, Vector3d(0, 0, 1e-4), stage.law, tangent);
    ASSERT_TRUE(tangent.allFinite());
    ASSERT_TRUE(wrench(f).allFinite());
    // |F_n n| = k rho^(e-1) x
    const double rho = std::hypot(x, 1e-7);
    EXPECT_NEAR(f.force.x(), -5e7 * std::sqrt(rho) * x, 1e-9 * 5e7 * std::sqrt(rho) * x);
    EXPECT_LT(tangent.norm(), 1e6 + 3.0 * 5e7 * std::sqrt(rho));
  }
}

TEST(WallContact, RotationFreesTheAxialSlide)
{
  // steady slip: axial share of friction = v_a / |v|
  StraightHole hole;
  Stage stage;
  stage.start << 0.0214, 0.0, -3.0;
  stage.law.static_ratio = 1.0;
  const double axial = 0.02;
  const double spin = 53.0 * rpm;
  const double h = 0.005;
  stage.coefficient = 1.0 / h;
  Vector3d bristle = Vector3d::Zero();
  WallForce f;
  for (int i = 0; i < 200; ++i)
  {
    // runs down and turns clockwise looking down: right-hand about the tangent, -z
    Vector6d u;
    u << 0, 0, -axial * h, 0, 0, -spin * h;
    stage.start.z() = -3.0;
    ContactMotion m = stage.motion(u);
    f = wall_contact(hole.locate(m.position), stage.radius, m, bristle, stage.law);
    bristle = f.bristle;
  }
  const double around = spin * stage.radius;
  const double total = std::hypot(axial, around);
  EXPECT_TRUE(f.slipping);
  EXPECT_NEAR(f.force.z(), hole.friction * f.normal_force * axial / total,
              1e-9 * f.normal_force);  // upwards: against running down
  EXPECT_NEAR(f.moment.z(), hole.friction * f.normal_force * stage.radius * around / total, 1e-9 * f.normal_force);
  EXPECT_NEAR(f.friction_power, -hole.friction * f.normal_force * total, 1e-9 * f.normal_force);
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
    Stage stage;
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
  ContactSpec& law() { return law_; }

private:
  double inclination_;
  double mass_ = 300.0;
  StraightHole hole_;
  ContactSpec law_;
  Vector3d low_side_;
  Vector3d position_;
  Vector3d velocity_ = Vector3d::Zero();
  Vector3d bristle_ = Vector3d::Zero();
  WallForce force_;
};

TEST(WallFriction, HeldBlockDoesNotCreep)
{
  // 70 deg from the vertical, mu_s = 3.6 > cot 70 deg: held. The elastic set is m g cos I / k_b = 0.2 mm, plus what slips while
  // the block is let down on the wall from zero penetration. The bristle has no damping of its own: the scheme's rings it down.
  BlockOnSlope block(70.0 * degree, 3.0);
  for (int i = 0; i < 1000; ++i)
  {
    block.step(0.005);
  }
  const double set = block.travel();
  EXPECT_NEAR(set, 300.0 * standard_gravity * std::cos(70.0 * degree) / 5e6, 2e-4);
  for (int i = 0; i < 100000; ++i)
  {
    block.step(0.005);
  }
  EXPECT_NEAR(block.travel(), set, 1e-12);
  EXPECT_LT(std::abs(block.speed()), 1e-12);
  EXPECT_FALSE(block.force().slipping);
}

TEST(WallFriction, PulsatingLoadWithinTheLimitDoesNotCreep)
{
  // the normal load swings by half; friction never reaches its limit: each cycle must come back to the same place
  BlockOnSlope block(70.0 * degree, 3.0);
  const double weight = 300.0 * standard_gravity * std::sin(70.0 * degree);
  const auto cycle = [&]
  {
    for (int i = 0; i < 40; ++i)
    {
      block.step(0.005, 0.5 * weight * std::sin(2.0 * pi * i / 40.0));
    }
  };
  for (int i = 0; i < 50; ++i)
  {
    cycle();
  }
  const double set = block.travel();
  for (int i = 0; i < 1000; ++i)
  {
    cycle();
  }
  EXPECT_NEAR(block.travel(), set, 1e-12);
}

TEST(WallFriction, StoppingDistanceDoesNotDependOnTheStep)
{
  // v^2 / (2 g (mu sin I - cos I)), mu static = kinetic: Coulomb's stop, less by half a step's slide in implicit Euler
  const double inclination = 80.0 * degree;
  for (double h : {0.004, 0.001})
  {
    BlockOnSlope block(inclination, 0.5);
    block.law().static_ratio = 1.0;
    for (int i = 0; i * h < 1.0; ++i)
    {
      block.step(h);  // lets it settle on the wall
    }
    const double start = block.travel();
    block.throw_down(1.0);
    for (int i = 0; i * h < 3.0; ++i)
    {
      block.step(h);
    }
    const double deceleration = standard_gravity * (0.5 * std::sin(inclination) - std::cos(inclination));
    EXPECT_NEAR(block.travel() - start, 0.5 / deceleration - 0.5 * h, 1e-3);
    EXPECT_LT(std::abs(block.speed()), 1e-3);
  }
}

TEST(WallFriction, SlidingBlockAcceleratesByTheDifference)
{
  const double inclination = 20.0 * degree;
  BlockOnSlope block(inclination, 0.5);
  block.law().static_ratio = 1.0;
  const double h = 0.002;
  for (int i = 0; i < 500; ++i)
  {
    block.step(h);
  }
  const double before = block.speed();
  for (int i = 0; i < 500; ++i)
  {
    block.step(h);
  }
  const double expected = standard_gravity * (std::cos(inclination) - 0.5 * std::sin(inclination));
  EXPECT_NEAR((block.speed() - before) / (500 * h), expected, 1e-6 * expected);
  EXPECT_NEAR(block.force().normal_force, 300.0 * standard_gravity * std::sin(inclination), 1e-3);
}

TEST(WallFriction, NeverCreatesEnergy)
{
  // random displacements of the section: work done on the wall plus nothing >= energy stored in the bristle
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  StraightHole hole;
  Stage stage;
  stage.law.law.damping = 0.0;
  stage.start << 0.0214, 0.0, -3.0;
  const double h = 0.005;
  stage.coefficient = 1.0 / h;
  Vector3d bristle = Vector3d::Zero();
  double taken_out = 0.0;
  for (int i = 0; i < 20000; ++i)
  {
    Vector6d u;
    u << 0.0, 0.0, 2e-4 * normal(random), 0.0, 0.0, 2e-3 * normal(random);
    const ContactMotion m = stage.motion(u);
    const WallForce f = wall_contact(hole.locate(m.position), stage.radius, m, bristle, stage.law);
    taken_out -= f.friction_power * h;  // implicit: force at the end of the step times the step's slip
    bristle = f.bristle;
    ASSERT_GE(taken_out, 0.5 * stage.law.tangential_stiffness * bristle.squaredNorm() * (1.0 - 1e-12));
  }
  EXPECT_GT(taken_out, 0.0);
}

TEST(WallFriction, BristleNeverLeavesTheLimitOrThePlane)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  StraightHole hole;
  Stage stage;
  Vector3d bristle = Vector3d::Zero();
  for (int i = 0; i < 1000; ++i)
  {
    const double angle = 0.01 * i;
    stage.start << 0.0214 * std::cos(angle), 0.0214 * std::sin(angle), -3.0;
    Vector6d u;
    u << 0.0, 0.0, 3e-4 * normal(random), 0.0, 0.0, 5e-3 * normal(random);
    const ContactMotion m = stage.motion(u);
    const WallForce f = wall_contact(hole.locate(m.position), stage.radius, m, bristle, stage.law);
    bristle = f.bristle;
    EXPECT_NEAR(bristle.dot(Vector3d(std::cos(angle), std::sin(angle), 0.0)), 0.0, 1e-15);
    EXPECT_LE(stage.law.tangential_stiffness * bristle.norm(),
              hole.friction * stage.law.static_ratio * f.normal_force * (1.0 + 1e-12));
  }
}

TEST(WallContact, ElasticImpactRestoresTheSpeed)
{
  // c_d = 0: a mass thrown at the wall comes back as fast; explicit, fine steps
  StraightHole hole;
  hole.friction = 0.0;
  ContactSpec law;
  law.law.damping = 0.0;
  const double mass = 100.0;
  const double h = 1e-6;
  ContactMotion m;
  m.position << 0.0199, 0.0, 0.0;
  m.velocity << 0.5, 0.0, 0.0;
  for (int i = 0; i < 100000 && (m.velocity.x() > 0.0 || m.position.x() > 0.0199); ++i)
  {
    m.position += 0.5 * h * m.velocity;
    m.velocity += h / mass * wall_contact(hole.locate(m.position), 0.08, m, Vector3d::Zero(), law).force;
    m.position += 0.5 * h * m.velocity;
  }
  EXPECT_NEAR(m.velocity.x(), -0.5, 1e-6);
}

TEST(WallContact, DampedImpactFollowsHuntAndCrossley)
{
  // restitution 1 - 2/3 c_d v for small c_d v
  StraightHole hole;
  hole.friction = 0.0;
  ContactSpec law;
  const double mass = 100.0;
  const double h = 1e-6;
  const double speed = 0.05;
  ContactMotion m;
  m.position << 0.01999, 0.0, 0.0;
  m.velocity << speed, 0.0, 0.0;
  for (int i = 0; i < 200000 && (m.velocity.x() > 0.0 || m.position.x() > 0.01999); ++i)
  {
    m.position += 0.5 * h * m.velocity;
    m.velocity += h / mass * wall_contact(hole.locate(m.position), 0.08, m, Vector3d::Zero(), law).force;
    m.position += 0.5 * h * m.velocity;
  }
  // next term of the series is (c_d v)^2 = 2e-4
  EXPECT_NEAR(-m.velocity.x() / speed, 1.0 - 2.0 / 3.0 * law.law.damping * speed, 3e-4);
}

TEST(SlidingWallContact, ForcesAndTangent)
{
  ArcHole arc;
  const Vector3d where = arc.locate({4.0, 0.0, -3.0}).centre + 0.0215 * Vector3d(0.48, 0.8, -0.36);
  ContactLaw law;
  const SlidingMotion pull_out{-1.0, 0.0};
  const SlidingMotion rotate{0.0, 1.0};
  Matrix6d tangent;
  const HoleSite site = arc.locate(where);

  WallForce f = sliding_wall_contact(site, 0.08, where, pull_out, law, tangent);
  EXPECT_NEAR(f.force.dot(site.tangent), arc.friction * f.normal_force, 1e-9 * f.normal_force);
  f = sliding_wall_contact(site, 0.08, where, rotate, law, tangent);
  EXPECT_NEAR(f.force.dot(site.tangent), 0.0, 1e-9 * f.normal_force);
  EXPECT_NEAR(f.moment.dot(site.tangent), -arc.friction * f.normal_force * 0.08, 1e-9 * f.normal_force);

  // a straight hole: the tangent is complete there
  StraightHole hole;
  hole.tangent = Vector3d(0.3, -0.2, -1.0).normalized();
  const Vector3d start = 2.0 * hole.tangent + 0.0215 * hole.tangent.cross(Vector3d::UnitY()).normalized();
  for (const SlidingMotion& sliding : {pull_out, rotate, SlidingMotion{0.3, 7.0}, SlidingMotion{}})
  {
    const auto force = [&](const Vector6d& u)
    {
      const Vector3d p = start + u.head<3>();
      Matrix6d unused;
      return wrench(sliding_wall_contact(hole.locate(p), 0.08, p, sliding, law, unused));
    };
    sliding_wall_contact(hole.locate(start), 0.08, start, sliding, law, tangent);
    const Matrix6d numeric = difference(force, Vector6d::Zero(), 1e-6);
    EXPECT_LT((tangent - numeric).norm(), 1e-6 * numeric.norm());
  }
}

TEST(StribeckFriction, FallsFromStaticToKinetic)
{
  EXPECT_DOUBLE_EQ(stribeck_friction(0.3, 1.2, 0.05, 0.0).value, 0.36);
  EXPECT_DOUBLE_EQ(stribeck_friction(0.3, 1.2, 0.05, 0.0).slope, 0.0);
  EXPECT_NEAR(stribeck_friction(0.3, 1.2, 0.05, 0.5).value, 0.3, 1e-15);
  const double h = 1e-5;
  const double slope =
      (stribeck_friction(0.3, 1.2, 0.05, 0.04 + h).value - stribeck_friction(0.3, 1.2, 0.05, 0.04 - h).value) / (2.0 * h);
  EXPECT_NEAR(stribeck_friction(0.3, 1.2, 0.05, 0.04).slope, slope, 1e-6 * std::abs(slope));
}

}  // namespace
}  // namespace drill_rig_sim

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
