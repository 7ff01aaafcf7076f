// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "well_fixtures.h"

namespace drill_rig_sim::test_well_locate
{
namespace
{
constexpr double bit_radius = 0.1556;

Wellbore drilled_on(const WellSpec& spec, double metres)
{
  Wellbore hole(spec, {}, bit_radius);
  HelixDriller bit(hole.end_direction(), 10.3e-3, 30e-6, 45e-6);
  while (hole.drilled_path_length() < metres) hole.extend(bit.next(), hole.end_direction());
  return hole;
}

// The nearest point of the axis by distances alone: a sweep of the whole hole, then golden section about the best of it.
class BruteForce
{
public:
  explicit BruteForce(const Wellbore& hole) : hole_(hole)
  {
    for (const double md : depths(-1.0, hole.hole_depth() + 1.0, 0.5)) sweep_.push_back(hole.at(md));
  }

  WellNode nearest(const Eigen::Vector3d& point) const
  {
    const WellNode* best = &sweep_.front();
    for (const WellNode& node : sweep_)
      if ((node.position - point).squaredNorm() < (best->position - point).squaredNorm()) best = &node;
    const auto distance2 = [&](double md) { return (hole_.at(md).position - point).squaredNorm(); };
    double low = best->md - 0.6, high = best->md + 0.6;
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double at_a = distance2(a), at_b = distance2(b);
    while (high - low > 1e-7)
    {
      if (at_a < at_b)
      {
        high = b, b = a, at_b = at_a, a = high - golden * (high - low), at_a = distance2(a);
      }
      else
      {
        low = a, a = b, at_a = at_b, b = low + golden * (high - low), at_b = distance2(b);
      }
    }
    return hole_.at(0.5 * (low + high));
  }

private:
  const Wellbore& hole_;
  std::vector<WellNode> sweep_;
};

class LocateIn : public testing::TestWithParam<WellSpec>
{
};

// Near its minimum the squared distance (of size 0.1 m2, known to 1e-13 m2 at coordinates of 1 km) is flat to md differences of
// 1e-6 m and less, where the distance itself does not change. At P alone, where the newly drilled interval begins a little
// sideways and turned, the plane rule and the least distance may choose differently: by less than radius times turn, 0.6 m *
// 3e-4.
TEST_P(LocateIn, AgreesWithBruteForceWithinTwoRadii)
{
  const Wellbore hole = drilled_on(GetParam(), 0.35);
  const double end = hole.node(hole.node_count() - 1).md;
  const BruteForce force(hole);
  std::mt19937 random(7);
  double worst = 0.0;
  for (int i = 0; i < 10000; ++i)
  {
    const Eigen::Vector3d point = point_near(hole, 4.0 * bit_radius, random);
    const ClosestPoint closest = hole.locate(point, -1);
    const WellNode expected = force.nearest(point);
    const bool at_kink = std::abs(closest.md - end) < 1e-3;
    ASSERT_NEAR(closest.md, expected.md, at_kink ? 2e-4 : 3e-6) << i;
    ASSERT_NEAR((closest.centre - point).norm(), (expected.position - point).norm(), at_kink ? 6e-5 : 1e-10) << i;
    if (!at_kink) worst = std::max(worst, std::abs(closest.md - expected.md));
  }
  std::printf("largest difference in md %.2g m\n", worst);
}

// A hint from anywhere gives the same answer as none.
TEST_P(LocateIn, WrongHintsAreHarmless)
{
  const Wellbore hole = drilled_on(GetParam(), 0.35);
  std::mt19937 random(11);
  for (int i = 0; i < 3000; ++i)
  {
    const Eigen::Vector3d point = point_near(hole, 3.0 * bit_radius, random);
    const int hint = static_cast<int>(random() % static_cast<unsigned>(hole.node_count() + 5));
    ASSERT_NEAR(hole.locate(point, hint).md, hole.locate(point, -1).md, 1e-7) << i;
  }
}

// The same of a measured depth.
TEST_P(LocateIn, WrongHintsOfADepthAreHarmless)
{
  const Wellbore hole = drilled_on(GetParam(), 0.35);
  std::mt19937 random(17);
  std::uniform_real_distribution<double> depth(-20.0, hole.hole_depth() + 1.0);
  for (int i = 0; i < 3000; ++i)
  {
    const double md = depth(random);
    const int wrong = static_cast<int>(random() % static_cast<unsigned>(hole.node_count() + 5)) - 2;
    int hint = wrong;
    const WellNode node = hole.at(md, hint), plain = hole.at(md);
    ASSERT_NEAR((node.position - plain.position).norm(), 0.0, 1e-9) << md;
    ASSERT_EQ(hole.at(md, hint).position, node.position) << md;
    const HoleWall wall = hole.wall_at(md, wrong);
    ASSERT_NEAR(wall.radius, plain.radius, 1e-9) << md;
    ASSERT_NEAR(wall.friction, plain.friction, 1e-9) << md;
    ASSERT_NEAR(wall.section, plain.section, 1e-9) << md;
  }
}

// Read off the chord of the point's segment: a ledge is a short piece of the hole, so it is found to a share of its length.
TEST_P(LocateIn, RadiusNearAPointIsTheHoles)
{
  const Wellbore hole = drilled_on(GetParam(), 0.35);
  std::mt19937 random(13);
  for (int i = 0; i < 3000; ++i)
  {
    const Eigen::Vector3d point = point_near(hole, 2.0 * bit_radius, random);
    const ClosestPoint closest = hole.locate(point, -1);
    ASSERT_NEAR(hole.radius_near(point, closest.segment), closest.radius, 1e-3 * closest.radius) << i;
    ASSERT_EQ(hole.radius_near(point, -1), closest.radius) << i;
    ASSERT_LT((hole.tangent_near(point, closest.segment) - closest.tangent).norm(), 1e-3) << i;
    ASSERT_EQ(hole.tangent_near(point, -1), closest.tangent) << i;
  }
}

// From 30 m above the rotary table to the bottom in millimetres: one centre line, md and radius without jumps.
TEST_P(LocateIn, SiteMovesContinuouslyFromTheTopDriveToTheBottom)
{
  const Wellbore hole = drilled_on(GetParam(), 0.35);
  ClosestPoint before = hole.locate(hole.at(-30.0).position, -1);
  EXPECT_EQ(before.segment, 0);
  for (const double md : depths(-30.0, hole.hole_depth(), 0.001))
  {
    const ClosestPoint closest = hole.locate(hole.at(md).position, before.segment);
    ASSERT_NEAR(closest.md, md, 1e-7);
    ASSERT_LE((closest.centre - before.centre).norm(), 0.001 + 2.0 * 30e-6) << md;
    before = closest;
  }
}

TEST_P(LocateIn, FootIsPerpendicularAndNewtonIsShort)
{
  const Wellbore hole = drilled_on(GetParam(), 0.35);
  std::mt19937 random(8);
  int iterations = 0;
  constexpr int points = 10000;
  for (int i = 0; i < points; ++i)
  {
    const Eigen::Vector3d point = point_near(hole, 4.0 * bit_radius, random);
    const ClosestPoint cold = hole.locate(point, -1);
    ASSERT_NEAR((point - cold.centre).dot(cold.tangent), 0.0, 1e-11);
    ASSERT_NEAR(cold.tangent.norm(), 1.0, 1e-14);
    const ClosestPoint warm = hole.locate(point, std::max(cold.segment + i % 3 - 1, 0));
    ASSERT_NEAR(warm.md, cold.md, 1e-7);
    iterations += warm.iterations;
  }
  std::printf("mean Newton iterations %.3f\n", static_cast<double>(iterations) / points);
  EXPECT_LE(iterations, 3 * points);
}

INSTANTIATE_TEST_SUITE_P(Wells, LocateIn, testing::Values(bohai_well(), crooked_well(), straight_well(300.0, 0.4, 1.0)));

TEST(WellLocate, MdGradientIsTheDerivative)
{
  const Wellbore hole = drilled_on(crooked_well(), 0.35);
  std::mt19937 random(9);
  for (int i = 0; i < 1000; ++i)
  {
    const Eigen::Vector3d point = point_near(hole, 4.0 * bit_radius, random);
    const ClosestPoint closest = hole.locate(point, -1);
    constexpr double h = 1e-4;
    Eigen::Vector3d difference;
    bool one_segment = true;
    for (int k = 0; k < 3; ++k)
    {
      const ClosestPoint plus = hole.locate(point + h * Eigen::Vector3d::Unit(k), closest.segment);
      const ClosestPoint minus = hole.locate(point - h * Eigen::Vector3d::Unit(k), closest.segment);
      one_segment = one_segment && plus.segment == minus.segment;
      difference[k] = (plus.md - minus.md) / (2.0 * h);
    }
    if (!one_segment) continue;
    ASSERT_LT((difference - closest.md_gradient).norm(), 1e-6) << closest.md;
  }
}

// Along the axis, inside the millimetre between two sections as well as outside.
TEST(WellLocate, SlopesAreDerivatives)
{
  const Wellbore hole = drilled_on(crooked_well(), 0.35);
  for (double md : {-3.0, 17.0, 500.0003, 500.0007, 1234.5, 1599.9995, 1600.13, 1600.34})
  {
    const ClosestPoint closest = hole.locate(hole.at(md).position, -1);
    constexpr double h = 1e-4;
    const WellNode plus = hole.at(md + h), minus = hole.at(md - h);
    EXPECT_LT(((plus.position - minus.position) / (2.0 * h) - closest.centre_slope).norm(), 1e-8) << md;
    EXPECT_NEAR((plus.radius - minus.radius) / (2.0 * h), closest.radius_slope, 1e-7) << md;
    EXPECT_NEAR(closest.radius, hole.at(md).radius, 1e-7) << md;
    EXPECT_NEAR(closest.friction, hole.at(md).friction, 1e-7) << md;
  }
}
// From anywhere and with any hint: a radius and a friction that the hole has somewhere, not one that its slope in a millimetre of
// ledge would reach metres away.
TEST(WellLocate, RadiusAndFrictionAreOnesOfTheHole)
{
  WellSpec spec;
  spec.survey = {{0.0, 0.0, 0.0}, {60.0, 6.0 * degree, 2.0 * degree}};
  spec.hole_depth = 60.0;
  spec.sections = {{30.0, 0.3204, 0.2}, {60.0, 0.2159, 0.3}};
  const Wellbore hole(spec, TrajectorySpec(), 0.1);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> depth(-20.0, 80.0), near(-0.3, 0.3), far(-200.0, 200.0);
  for (int k = 0; k < 20000; ++k)
  {
    const bool close = k % 2 == 0;
    auto& off = close ? near : far;
    const Eigen::Vector3d point = hole.at(depth(random)).position + Eigen::Vector3d(off(random), off(random), off(random));
    const ClosestPoint closest = hole.locate(point, k % (hole.node_count() + 8) - 4);
    ASSERT_GE(closest.radius, 0.1 - 1e-12) << point.transpose();  // the bit's
    ASSERT_LE(closest.radius, 0.1602 + 1e-12) << point.transpose();
    ASSERT_GE(closest.friction, 0.2 - 1e-12);
    ASSERT_LE(closest.friction, 0.3 + 1e-12);
  }
}
}  // namespace
}  // namespace drill_rig_sim::test_well_locate
