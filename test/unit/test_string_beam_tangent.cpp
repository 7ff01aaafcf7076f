// SPDX-License-Identifier: BSD-3-Clause
// The beam element's forces are the gradient of its energy, its tangent the derivative of its forces.
#include <gtest/gtest.h>

#include <random>

#include "beam_ends.h"

namespace test_string_beam_tangent
{
using namespace drill_rig_sim;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
const BeamSection kPipe = tube_section(9.5, 0.127, 0.1086, 206e9, 0.3);

/// Anywhere, after many turns.
BeamEnds random_ends(std::mt19937& generator, double tilt, double twist)
{
  std::normal_distribution<double> g;
  const Vector3d common(g(generator), g(generator), g(generator));
  return drill_rig_sim::random_ends(generator, kPipe.length, tilt, twist, 50.0 * g(generator), rotation_from_vector(common));
}

BeamForces forces(const BeamEnds& s, const BeamDamping& damping = {}, const Vector3d& load = Vector3d::Zero())
{
  BeamStrain strain;
  return beam_forces(kPipe, pose_of(s), damping, load, strain);
}

double energy(const BeamEnds& s)
{
  const BeamPose p = pose_of(s);
  BeamStrain e;
  beam_forces(kPipe, p, {}, Vector3d::Zero(), e);
  const Vector3d chord = (p.lower_position - p.upper_position).normalized();
  const Vector3d a1 = p.upper_normal - chord, a2 = p.lower_normal - chord;
  return 0.5 * kPipe.axial * kPipe.length * e.stretch * e.stretch + 0.5 * kPipe.torsion * e.twist * e.twist +
         0.5 * kPipe.bending_near * (a1.squaredNorm() + a2.squaredNorm()) + kPipe.bending_far * a1.dot(a2);
}
}  // namespace

TEST(BeamElement, forcesAreTheGradientOfTheEnergy)
{
  std::mt19937 generator(1);
  for (int i = 0; i < 50; ++i)
  {
    const BeamEnds s = random_ends(generator, 0.1, 0.3);
    const auto f = stacked(forces(s));
    for (int k = 0; k < 12; ++k)
    {
      const double h = 1e-5;
      const double slope = (energy(moved(s, k, h)) - energy(moved(s, k, -h))) / (2.0 * h);
      EXPECT_NEAR(f[k], slope, 1e-6 * f.norm()) << "component " << k;
    }
  }
}

TEST(BeamElement, tangentIsTheDerivativeOfTheForces)
{
  std::mt19937 generator(2);
  for (int i = 0; i < 50; ++i)
  {
    const BeamEnds s = random_ends(generator, 0.1, 0.3);
    const double time = 0.005, dv_du = 140.0;  // [s], [1/s]
    std::normal_distribution<double> g;
    auto random_vector = [&] { return Vector3d(g(generator), g(generator), g(generator)); };
    const BeamDamping moving{
        time, dv_du, random_vector(), random_vector(), random_vector(), 20.0 * random_vector(), 20.0 * random_vector()};
    auto damped = [&](int k, double h)
    {
      BeamDamping damping = moving;
      const BeamEnds m = moved(s, k, h);
      damping.upper_turning += m.q1 * (s.q1.conjugate() * moving.upper_spin) - moving.upper_spin;
      damping.lower_turning += m.q2 * (s.q2.conjugate() * moving.lower_spin) - moving.lower_spin;
      const Vector3d rate = dv_du * h * Vector3d::Unit(k % 3);
      if (k < 3) damping.velocity -= rate;
      if (k >= 3 && k < 6) damping.upper_turning += rate;
      if (k >= 6 && k < 9) damping.velocity += rate;
      if (k >= 9) damping.lower_turning += rate;
      return damping;
    };
    const Vector3d load(100.0, -200.0, -2500.0);
    BeamStrain strain;
    BeamTangent t;
    beam_forces(kPipe, pose_of(s), damped(0, 0.0), load, strain, t);
    const Matrix12d k_matrix = stacked(t);
    for (int k = 0; k < 12; ++k)
    {
      const double h = 1e-6;
      const Vector12d column =
          (stacked(forces(moved(s, k, h), damped(k, h), load)) - stacked(forces(moved(s, k, -h), damped(k, -h), load))) /
          (2.0 * h);
      EXPECT_LT((column - k_matrix.col(k)).norm(), 1e-6 * k_matrix.norm()) << "column " << k;
      // rotations on their own: axial stiffness must not hide an error in the bending terms
      EXPECT_LT((column - k_matrix.col(k)).tail<3>().norm(), 1e-5 * t.lower_lower.norm()) << "column " << k;
    }
  }
}

// The strain's rate is its change per time along a motion with constant rates of the ends.
TEST(BeamElement, dampingForcesAreThoseOfTheStrainsRate)
{
  std::mt19937 generator(5);
  std::normal_distribution<double> g;
  auto random_vector = [&] { return Vector3d(g(generator), g(generator), g(generator)); };
  for (int i = 0; i < 20; ++i)
  {
    const BeamEnds s = random_ends(generator, 0.1, 0.3);
    const Vector3d v1 = random_vector(), v2 = random_vector(), w1 = random_vector(), w2 = random_vector();
    auto strain_after = [&](double time)
    {
      const BeamEnds m{s.x1 + time * v1, s.x2 + time * v2, rotation_from_vector(time * w1) * s.q1,
                       rotation_from_vector(time * w2) * s.q2};
      BeamStrain strain;
      beam_forces(kPipe, pose_of(m), {}, Vector3d::Zero(), strain);
      return strain;
    };
    const double h = 1e-5, time = 1e-3;
    const BeamStrain before = strain_after(-h), after = strain_after(h);
    const BeamDamping damping{time, 0.0, v2 - v1, w1, w2};
    const BeamForces damped = forces(s, damping), elastic = forces(s);
    const double tension = kPipe.axial * time * (after.stretch - before.stretch) / (2.0 * h);
    const double torque = kPipe.torsion * time * (after.twist - before.twist) / (2.0 * h);
    EXPECT_NEAR(damped.tension - elastic.tension, tension, 1e-6 * std::abs(tension) + 1.0);
    EXPECT_NEAR(damped.torque - elastic.torque, torque, 1e-6 * std::abs(torque) + 1e-3);
  }
}

// Kelvin and Voigt: with the strains' gradient at a straight element at rest the damping matrix is the stiffness times the time,
// so that every small motion at w is damped by w time/2 of critical.
TEST(BeamElement, dampingOfAStraightElementIsItsStiffnessTimesTheTime)
{
  std::mt19937 generator(6);
  const BeamEnds s = random_ends(generator, 0.0, 0.0);
  const double time = 0.003, dv_du = 50.0;
  BeamStrain strain;
  BeamTangent at_rest, in_motion;
  const BeamEnds unloaded{s.x1, s.x1 + kPipe.length * (s.x2 - s.x1).normalized(), s.q1, s.q2};
  beam_forces(kPipe, pose_of(unloaded), {}, Vector3d::Zero(), strain, at_rest);
  BeamDamping damping;
  damping.time = time;
  damping.dv_du = dv_du;
  beam_forces(kPipe, pose_of(unloaded), damping, Vector3d::Zero(), strain, in_motion);
  const Matrix12d stiffness = stacked(at_rest), more = stacked(in_motion) - stiffness;
  const Eigen::MatrixXd rest = more - time * dv_du * stiffness;
  EXPECT_LT(rest.norm(), 1e-9 * more.norm());
  for (const int k : {3, 9})
  {
    const Matrix3d of_turn = rest.block<3, 3>(k, k), whole = more.block<3, 3>(k, k);
    EXPECT_LT(of_turn.norm(), 1e-9 * whole.norm());
  }
}

// The bend's rates are those of the ends' tilts in axes that turn with the element and spin with its ends; damping takes their
// power.
TEST(BeamElement, bendingDampingTakesThePowerOfTheTiltsInAxesThatSpin)
{
  std::mt19937 generator(7);
  std::normal_distribution<double> g;
  auto random_vector = [&] { return Vector3d(g(generator), g(generator), g(generator)); };
  double largest = 0.0;
  for (int i = 0; i < 20; ++i)
  {
    const double tilt = 1e-3;
    const BeamEnds s = random_ends(generator, tilt, 1e-3);
    const Vector3d e = (s.x2 - s.x1).normalized(), common = random_vector();
    const double spin = 20.0 * g(generator);
    const Vector3d v = (common + spin * e).cross(s.x2 - s.x1);
    // a rigid motion, and on top of it each end's own: a bit of tilt, and the spin about its own normal
    const Vector3d w1 = common + spin * x_axis(s.q1) + 0.01 * random_vector(),
                   w2 = common + spin * x_axis(s.q2) + 0.01 * random_vector();
    auto tilts_after = [&](double time)
    {
      const Quaterniond back = rotation_from_vector(time * (common + spin * e)).conjugate();
      const Vector3d n1 = rotation_from_vector(time * w1) * x_axis(s.q1), n2 = rotation_from_vector(time * w2) * x_axis(s.q2);
      Eigen::Matrix<double, 6, 1> a;
      a << back * n1 - e, back * n2 - e;
      return a;
    };
    const double h = 1e-6, time = 1e-3;
    const Eigen::Matrix<double, 6, 1> rate = (tilts_after(h) - tilts_after(-h)) / (2.0 * h);
    const Vector3d a1 = rate.head<3>(), a2 = rate.tail<3>();
    const double expected =
        time * (kPipe.bending_near * (a1.squaredNorm() + a2.squaredNorm()) + 2.0 * kPipe.bending_far * a1.dot(a2));
    BeamSection bare = kPipe;
    bare.axial = bare.torsion = 0.0;
    BeamStrain strain;
    const BeamDamping damping{time, 0.0, v, w1, w2};
    const BeamForces with = beam_forces(bare, pose_of(s), damping, Vector3d::Zero(), strain);
    const BeamForces without = beam_forces(bare, pose_of(s), {}, Vector3d::Zero(), strain);
    const double power = (with.force - without.force).dot(v) + (with.moment_upper - without.moment_upper).dot(w1) +
                         (with.moment_lower - without.moment_lower).dot(w2);
    const double own = (w1 - common - spin * e).squaredNorm() + (w2 - common - spin * e).squaredNorm();
    EXPECT_NEAR(power, expected, 5.0 * tilt * time * kPipe.bending_near * own);
    largest = std::max(largest, power / (time * kPipe.bending_near * own));
  }
  EXPECT_GT(largest, 0.5);
}

TEST(BeamElement, rigidMotionAndCommonSpinCostNothing)
{
  std::mt19937 generator(3);
  const BeamEnds s = random_ends(generator, 0.05, 0.1);
  BeamEnds turned = s;
  const Quaterniond q = rotation_from_vector(Vector3d(1.0, 2.0, -0.5));
  turned.x1 = q * s.x1 + Vector3d(1.0, 2.0, 3.0);
  turned.x2 = q * s.x2 + Vector3d(1.0, 2.0, 3.0);
  turned.q1 = q * s.q1;
  turned.q2 = q * s.q2;
  EXPECT_NEAR(energy(turned), energy(s), 1e-9 * energy(s));
  BeamEnds spun = s;
  spun.q1 = s.q1 * rotation_from_vector(Vector3d(2.5, 0.0, 0.0));
  spun.q2 = s.q2 * rotation_from_vector(Vector3d(2.5, 0.0, 0.0));
  const BeamPose a = pose_of(s), b = pose_of(spun);
  EXPECT_LT((a.upper_normal - b.upper_normal).norm(), 1e-14);
  EXPECT_NEAR(forces(spun).moment_upper.norm(), forces(s).moment_upper.norm(), 1e-6 * forces(s).moment_upper.norm());
  // and nothing is damped when it turns with its bend, about whatever axis
  const Vector3d w(3.0, -20.0, 7.0);
  const BeamDamping rigid{0.01, 0.0, w.cross(s.x2 - s.x1), w, w};
  EXPECT_LT((stacked(forces(s, rigid)) - stacked(forces(s))).norm(), 1e-12 * kPipe.axial);
}

// Bent to k and spinning at W, each section about its own normal: c E I k^2 W^2 L, the loss of a rotating shaft.
TEST(BeamElement, spinningInABendCostsWhatARotatingShaftLoses)
{
  const double curvature = 5.8e-3, spin = 18.85, time = 1e-4;  // 10 deg/30 m, 180 rpm
  const double half = 0.5 * curvature * kPipe.length;
  BeamEnds s;
  s.x1 = Vector3d::Zero();
  s.x2 = Vector3d(kPipe.length * std::sin(half) / half, 0.0, 0.0);
  s.q1 = rotation_from_vector(Vector3d(0.0, 0.0, half));
  s.q2 = rotation_from_vector(Vector3d(0.0, 0.0, -half));
  const BeamDamping damping{time, 0.0, Vector3d::Zero(), spin * x_axis(s.q1), spin * x_axis(s.q2)};
  const BeamForces with = forces(s, damping), without = forces(s);
  const double power = (with.moment_upper - without.moment_upper).dot(damping.upper_turning) +
                       (with.moment_lower - without.moment_lower).dot(damping.lower_turning);
  const double expected = time * kPipe.bending * curvature * curvature * spin * spin * kPipe.length;
  EXPECT_NEAR(power, expected, 1e-3 * expected);
}

TEST(BeamElement, forcesAndMomentsBalance)
{
  std::mt19937 generator(4);
  for (int i = 0; i < 20; ++i)
  {
    const BeamEnds s = random_ends(generator, 0.1, 0.3);
    const BeamForces f =
        forces(s, {0.01, 0.0, s.q1 * Vector3d(1.0, 2.0, -0.5), s.q2 * Vector3d(0.3, -1.0, 2.0), Vector3d(-1.0, 0.5, 3.0)});
    const Vector3d rest = f.moment_upper + f.moment_lower + (s.x2 - s.x1).cross(f.force);
    EXPECT_LT(rest.norm(), 1e-9 * (f.force.norm() * 9.5 + f.moment_upper.norm()));
  }
}
}  // namespace test_string_beam_tangent
