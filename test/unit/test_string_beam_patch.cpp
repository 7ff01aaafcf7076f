// SPDX-License-Identifier: BSD-3-Clause
// Patches: stretch, torsion and pure bending of every kind of beam element, exact on any mesh where theory predicts it.
#include <gtest/gtest.h>

#include <cmath>

#include "beam_ends.h"
#include "beam_kinds.h"
#include "beam_problems.h"

namespace test_string_beam_patch
{
using namespace drill_rig_sim;
using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
/// Five elements of unequal lengths, clamped at the first node, 10 m in all; vertical.
BeamChain uneven_cantilever(const BeamKind& kind)
{
  const double lengths[] = {1.0, 3.0, 2.5, 0.5, 3.0};
  BeamChain chain = BeamChain::cantilever(5, kPipe);
  chain.kind = &kind;
  chain.attitude = downwards();
  for (int e = 0; e < 5; ++e)
  {
    chain.elements[e].section = section_of(lengths[e], 1e9, 1e6, 7e5, 4e8);
    chain.nodes[e + 1].position.x() = chain.nodes[e].position.x() + lengths[e];
  }
  return chain;
}

/// Angle between the ends of one corotational element under a moment alone: each end tilts by half of it against the chord, so
/// dU/d angle = k11 sin(angle/2) + k12 (sin(angle/2) - sin(angle)).
double cubic_in_pure_bending(const BeamSection& s, double moment)
{
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 60; ++k)
  {
    const double angle = 0.5 * (low + high), half = std::sin(0.5 * angle);
    (s.bending_near * half + s.bending_far * (half - std::sin(angle)) < moment ? low : high) = angle;
  }
  return low;
}
}  // namespace

TEST(BeamPatch, stretchIsExact)
{
  for (const BeamKind& kind : beam_table())
  {
    BeamChain chain = uneven_cantilever(kind);
    chain.tip().force.x() = 4e5;
    ASSERT_TRUE(chain.solve()) << kind.name;
    EXPECT_NEAR(chain.tip().position.x(), 10.0 * (1.0 + 4e5 / 1e9), 1e-12) << kind.name;
    for (const BeamForces& f : chain.forces) EXPECT_NEAR(f.tension, 4e5, 1e-3) << kind.name;
  }
}

TEST(BeamPatch, torsionIsExact)
{
  for (const BeamKind& kind : beam_table())
  {
    BeamChain chain = uneven_cantilever(kind);
    chain.tip().moment.x() = 3e4;
    ASSERT_TRUE(chain.solve()) << kind.name;
    EXPECT_NEAR(twist_between(chain.nodes[0].orientation, chain.tip().orientation), 3e4 * 10.0 / 7e5, 1e-12) << kind.name;
    for (const BeamForces& f : chain.forces) EXPECT_NEAR(f.torque, 3e4, 1e-6) << kind.name;
  }
}

// By 90 degrees in all, 27 in the longest element. Elements of constant curvature are exact; the cubic holds its tilts for small.
TEST(BeamPatch, pureBendingIsExactForConstantCurvature)
{
  const double angle = 0.5 * pi, radius = 10.0 / angle;
  for (const BeamKind* kind : {&kExact, &kVector})
  {
    BeamChain chain = uneven_cantilever(*kind);
    load_in_steps(chain, 4, [&](BeamChain& c, double part) { c.tip().moment.z() = part * 1e6 * angle / 10.0; });
    double along = 0.0;
    for (std::size_t i = 1; i < chain.nodes.size(); ++i)
    {
      along += chain.elements[i - 1].section.length;
      EXPECT_NEAR(turned_about_z(chain), angle, 1e-12) << kind->name;
      const Vector3d from = x_axis(chain.nodes[i - 1].orientation), to = x_axis(chain.nodes[i].orientation);
      EXPECT_NEAR(std::acos(from.dot(to)), chain.elements[i - 1].section.length / radius, 1e-9) << kind->name;
      // chord of the arc replaced by its length: linear interpolation holds the strain, not the arc
      const double middle = (along - 0.5 * chain.elements[i - 1].section.length) / radius;
      const Vector3d chord = chain.nodes[i].position - chain.nodes[i - 1].position;
      EXPECT_NEAR(std::atan2(chord.y(), chord.x()), middle, 1e-12) << kind->name;
      EXPECT_NEAR(chord.norm(), chain.elements[i - 1].section.length, 1e-12) << kind->name;
    }
  }
  BeamChain chain = uneven_cantilever(kCorotational);
  load_in_steps(chain, 4, [&](BeamChain& c, double part) { c.tip().moment.z() = part * 1e6 * angle / 10.0; });
  double expected = 0.0;
  for (const auto& e : chain.elements) expected += cubic_in_pure_bending(e.section, 1e6 * angle / 10.0);
  EXPECT_NEAR(turned_about_z(chain), expected, 1e-9);
  EXPECT_NEAR(expected, angle, 0.05);
}

// Dead lateral tip load 5 E I/L^2 on a cantilever: all are of second order in the element's length.
}  // namespace test_string_beam_patch
