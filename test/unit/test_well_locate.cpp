#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "well_fixtures.h"

namespace drill_rig_sim
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

// The nearest point of the axis by sampling every millimetre near the best of a coarse sweep, refined by golden section.
WellNode nearest_by_force(const Wellbore& hole, const Eigen::Vector3d& point)
{
  const auto distance = [&](double md) { return (hole.at(md).position - point).norm(); };
  double best = 0.0;
  for (double md = -1.0; md < hole.hole_depth() + 1.0; md += 0.5)
    if (distance(md) < distance(best)) best = md;
  double low = best - 0.6, high = best + 0.6;
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  while (high - low > 1e-7)
  {
    const double a = high - golden * (high - low);
    const double b = low + golden * (high - low);
    (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
  }
  return hole.at(0.5 * (low + high));
}

class LocateIn : public testing::TestWithParam<WellSpec>
{
};

// Distances near a minimum d are flat: sampling finds md to about sqrt(1e-16 * 1600 m * d) = 1e-7 m, the distance to 1e-12 m.
TEST_P(LocateIn, AgreesWithBruteForceWithinTwoRadii)
{
  const Wellbore hole = drilled_on(GetParam(), 0.35);
  std::mt19937 random(7);
  for (int i = 0; i < 400; ++i)
  {
    const Eigen::Vector3d point = point_near(hole, 4.0 * bit_radius, random);
    const HoleSite site = hole.locate(point, -1);
    const WellNode force = nearest_by_force(hole, point);
    ASSERT_NEAR(site.md, force.md, 2e-4) << i;  // sideways step of the fresh end where it begins
    ASSERT_NEAR((site.centre - point).norm(), (force.position - point).norm(), 1e-7) << i;
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
    const HoleSite cold = hole.locate(point, -1);
    ASSERT_NEAR((point - cold.centre).dot(cold.tangent), 0.0, 1e-11);
    ASSERT_NEAR(cold.tangent.norm(), 1.0, 1e-14);
    const HoleSite warm = hole.locate(point, std::max(cold.segment + i % 3 - 1, 0));
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
    const HoleSite site = hole.locate(point, -1);
    constexpr double h = 1e-4;
    Eigen::Vector3d difference;
    bool one_segment = true;
    for (int k = 0; k < 3; ++k)
    {
      const HoleSite plus = hole.locate(point + h * Eigen::Vector3d::Unit(k), site.segment);
      const HoleSite minus = hole.locate(point - h * Eigen::Vector3d::Unit(k), site.segment);
      one_segment = one_segment && plus.segment == minus.segment;
      difference[k] = (plus.md - minus.md) / (2.0 * h);
    }
    if (!one_segment) continue;
    ASSERT_LT((difference - site.md_gradient).norm(), 1e-6) << site.md;
  }
}
}  // namespace
}  // namespace drill_rig_sim

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
