// SPDX-License-Identifier: BSD-3-Clause
// Structural damping of every kind of beam element: the power of the rates of its strains.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "beam_kinds.h"

namespace test_string_beam_damping
{
using namespace drill_rig_sim;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
/// Rates by difference of what each kind calls its bend, in the section's axes: c times their quadratic form [W].
double bending_power(const BeamKind& kind, const std::function<BeamEnds(double)>& after, double time)
{
  const double h = 1e-5;
  if (&kind == &kCorotational)
  {
    // the ends' angular velocities against the chord, across it
    const BeamEnds s = after(0.0), m = after(h), b = after(-h);
    const Vector3d e = (s.x2 - s.x1).normalized();
    const Vector3d chord = e.cross((m.x2 - m.x1).normalized() - (b.x2 - b.x1).normalized()) / (2.0 * h);
    auto across = [&](const Quaterniond& now, const Quaterniond& before)
    {
      const Vector3d w = vector_of(Matrix3d(now * before.conjugate())) / (2.0 * h);
      return Vector3d(w - e * e.dot(w) - chord);
    };
    const Vector3d upper = across(m.q1, b.q1), lower = across(m.q2, b.q2);
    return time * (kPipe.bending_near * (upper.squaredNorm() + lower.squaredNorm()) + 2.0 * kPipe.bending_far * upper.dot(lower));
  }
  auto bend = [&](double t)
  {
    const BeamEnds s = after(t);
    return Vector3d(&kind == &kExact ? vector_of(Matrix3d(s.q1.conjugate() * s.q2)) : vector_middle(s).turn);
  };
  const Vector3d rate = (bend(h) - bend(-h)) / (2.0 * h);
  return time * kPipe.bending / kPipe.length * (rate.y() * rate.y() + rate.z() * rate.z());
}
}  // namespace

TEST(BeamKinds, dampingTakesThePowerOfStretchTwistAndBending)
{
  for (const BeamKind& kind : beam_table())
  {
    std::mt19937 generator(5);
    std::normal_distribution<double> g;
    for (int i = 0; i < 20; ++i)
    {
      const BeamEnds s = any_ends(generator, 0.1);
      const double time = 0.01, h = 1e-5;
      BeamDamping damping;
      damping.time = time;
      damping.velocity = Vector3d(g(generator), g(generator), g(generator));
      damping.upper_turning = Vector3d(g(generator), g(generator), g(generator));
      damping.lower_turning = Vector3d(g(generator), g(generator), g(generator));
      const auto ends_after = [&](double t)
      {
        return BeamEnds{s.x1, s.x2 + t * damping.velocity, rotation_from_vector(t * damping.upper_turning) * s.q1,
                        rotation_from_vector(t * damping.lower_turning) * s.q2};
      };
      auto strain_after = [&](double t)
      {
        BeamStrain strain;
        kind.forces(kPipe, pose_of(ends_after(t)), {}, Vector3d::Zero(), strain);
        return strain;
      };
      const BeamStrain before = strain_after(-h), after = strain_after(h);
      const double stretch_rate = (after.stretch - before.stretch) / (2.0 * h),
                   twist_rate = (after.twist - before.twist) / (2.0 * h);
      const double bending = bending_power(kind, ends_after, time);
      const double expected =
          time * (kPipe.axial * kPipe.length * stretch_rate * stretch_rate + kPipe.torsion * twist_rate * twist_rate) + bending;
      const BeamForces still = forces(kind, s), damped = forces(kind, s, damping);
      const double power = (damped.force - still.force).dot(damping.velocity) +
                           (damped.moment_upper - still.moment_upper).dot(damping.upper_turning) +
                           (damped.moment_lower - still.moment_lower).dot(damping.lower_turning);
      EXPECT_NEAR(power, expected, 1e-6 * expected + 1e-4 * bending) << kind.name;
    }
  }
}
}  // namespace test_string_beam_damping
