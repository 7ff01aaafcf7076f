// The beam element's forces are the gradient of its energy, its tangent the derivative of its forces.
#include <gtest/gtest.h>

#include <random>

#include "beam_ends.h"

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
    const BeamDamping moving{time, dv_du, Vector3d(g(generator), g(generator), g(generator)),
                             Vector3d(g(generator), g(generator), g(generator)), Vector3d(g(generator), g(generator), g(generator))};
    auto damped = [&](int k, double h)
    {
      BeamDamping damping = moving;
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
          (stacked(forces(moved(s, k, h), damped(k, h), load)) - stacked(forces(moved(s, k, -h), damped(k, -h), load))) / (2.0 * h);
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
      const BeamEnds m{s.x1 + time * v1, s.x2 + time * v2, rotation_from_vector(time * w1) * s.q1, rotation_from_vector(time * w2) * s.q2};
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
}

TEST(BeamElement, forcesAndMomentsBalance)
{
  std::mt19937 generator(4);
  for (int i = 0; i < 20; ++i)
  {
    const BeamEnds s = random_ends(generator, 0.1, 0.3);
    const BeamForces f = forces(s);
    const Vector3d rest = f.moment_upper + f.moment_lower + (s.x2 - s.x1).cross(f.force);
    EXPECT_LT(rest.norm(), 1e-9 * (f.force.norm() * 9.5 + f.moment_upper.norm()));
  }
}

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
