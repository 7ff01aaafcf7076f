// SPDX-License-Identifier: BSD-3-Clause
// The bit on the bottom: the implicit law's root, its derivatives, steady drilling.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "drill_rig_sim/contact/bit_bottom.h"

namespace drill_rig_sim::test_contact_bit_bottom
{
namespace
{
const ContactLaw bottom{1e9, 1.5, 1.0};
const RockBreaking bohai{8.6e-9 * 14.3, 1.0, 0.0};

double central(const std::function<double(double)>& f, double x, double h)
{
  return (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h);
}

void expect_solution(const ContactLaw& law, double approach, double rate, const RockBreaking& rock, double step)
{
  const BottomForce f = bit_bottom_force(law, approach, rate, rock, step);
  const double delta = approach - step * f.speed;
  const double expected =
      delta > 0.0 ? law.stiffness * std::pow(delta, law.exponent) * std::max(0.0, 1.0 + law.damping * (rate - f.speed)) : 0.0;
  // The root is exact to rounding in F; put back through the law that rounding is seen through its slope.
  const double slope = 1.0 + rock_breaking_speed(rock, f.value).slope * (step * 1.5 * expected / delta + law.damping * expected);
  EXPECT_NEAR(f.value, expected, 1e-13 * expected * slope);
  EXPECT_EQ(f.penetration, delta);
  EXPECT_EQ(f.advance, step * f.speed);

  const double k = central([&](double x) { return bit_bottom_force(law, x, rate, rock, step).value; }, approach, 1e-4 * approach);
  EXPECT_NEAR(f.stiffness, k, 1e-6 * std::abs(k));
  const double c = central([&](double x) { return bit_bottom_force(law, approach, x, rock, step).value; }, rate, 1e-4);
  EXPECT_NEAR(f.damping, c, 1e-6 * std::abs(c));
}

TEST(BitBottom, OffBottomIsZero)
{
  for (double approach : {0.0, -1e-6, -1.0})
  {
    const BottomForce f = bit_bottom_force(bottom, approach, 1.0, bohai, 0.005);
    EXPECT_EQ(f.value, 0.0);
    EXPECT_EQ(f.stiffness, 0.0);
    EXPECT_EQ(f.speed, 0.0);
    EXPECT_EQ(f.penetration, approach);
  }
}

// v(F) by hand: from the threshold on, 2 um/s and newton.
TEST(BitBottom, RockBreaksByTheForceAboveItsThreshold)
{
  const RockBreaking rock{2e-6, 1.0, 5e3};
  EXPECT_EQ(rock_breaking_speed(rock, 4e3).value, 0.0);
  EXPECT_EQ(rock_breaking_speed(rock, 5e3).slope, 0.0);
  EXPECT_NEAR(rock_breaking_speed(rock, 6e3).value, 2e-3, 1e-17);
  EXPECT_NEAR(rock_breaking_speed({2e-6, 2.0, 5e3}, 6e3).value, 2.0, 1e-14);
  EXPECT_NEAR(rock_breaking_speed({2e-6, 2.0, 5e3}, 6e3).slope, 4e-3, 1e-17);
}

TEST(BitBottom, NoJumpAtFirstTouch)
{
  EXPECT_LT(bit_bottom_force(bottom, 1e-9, 0.1, bohai, 0.005).value, 1e-3);
}

TEST(BitBottom, FirmRockIsHuntCrossley)
{
  const BottomForce f = bit_bottom_force(bottom, 2e-3, 0.01, RockBreaking{}, 0.005);
  EXPECT_NEAR(f.value, 1e9 * std::pow(2e-3, 1.5) * 1.01, 1e-8 * f.value);
  EXPECT_NEAR(f.stiffness, 1.5e9 * std::sqrt(2e-3) * 1.01, 1e-8 * f.stiffness);
  EXPECT_NEAR(f.damping, 1e9 * std::pow(2e-3, 1.5), 1e-8 * f.damping);
  EXPECT_EQ(f.advance, 0.0);
}

TEST(BitBottom, ImplicitAdvanceAndItsDerivatives)
{
  expect_solution(bottom, 1.8e-3, 9e-3, bohai, 0.005);
  expect_solution(bottom, 1.8e-3, -0.05, bohai, 0.002);
  expect_solution(bottom, 5e-2, 1.0, bohai, 0.05);                  // far too deep: the rock gives way at once
  expect_solution(bottom, 1.8e-3, 9e-3, {3e-11, 1.7, 2e4}, 0.005);  // threshold, convex
  expect_solution(bottom, 1.8e-3, 9e-3, {3e-6, 0.6, 2e4}, 0.005);   // concave: unbounded slope at the threshold
  expect_solution(bottom, 1e-3, 0.0, {1.0, 1.0, 0.0}, 0.005);       // soft as mud: the advance takes nearly all
  expect_solution({1e9, 1.0, 0.5}, 1e-4, 0.01, bohai, 0.005);       // linear spring
  expect_solution({1e9, 2.2, 0.5}, 5e-3, 0.01, bohai, 0.005);
}

TEST(BitBottom, BelowTheThresholdTheRockStays)
{
  const RockBreaking rock{1e-7, 1.0, 1e5};
  const BottomForce f = bit_bottom_force(bottom, 1.8e-3, 0.0, rock, 0.005);
  EXPECT_EQ(f.speed, 0.0);
  EXPECT_NEAR(f.value, 1e9 * std::pow(1.8e-3, 1.5), 1e-8 * f.value);

  // continuous across it
  const double at = std::pow(1e5 / 1e9, 1.0 / 1.5);
  EXPECT_NEAR(bit_bottom_force(bottom, at * (1 + 1e-9), 0.0, rock, 0.005).value,
              bit_bottom_force(bottom, at * (1 - 1e-9), 0.0, rock, 0.005).value, 1e-3);
}

TEST(BitBottom, FedAtConstantSpeedTheRockLawSetsTheWeight)
{
  // The bit is fed at v; the bottom recedes: in steady state v(F) = feed and F = k delta^e exactly.
  const double feed = 9.08e-3;
  const double h = 0.005;
  double bit = 0.0;
  double floor = 0.0;
  BottomForce f;
  for (int i = 0; i < 4000; ++i)
  {
    bit += feed * h;
    f = bit_bottom_force(bottom, bit - floor, feed, bohai, h);
    floor += f.advance;
  }
  EXPECT_NEAR(f.speed, feed, 1e-12 * feed);
  EXPECT_NEAR(f.value, feed / bohai.coefficient, 1e-9 * f.value);
  EXPECT_NEAR(f.value, 1e9 * std::pow(f.penetration, 1.5), 1e-9 * f.value);
}

TEST(BitBottom, ElasticBounceRestoresTheSpeed)
{
  const ContactLaw elastic{1e9, 1.5, 0.0};
  const double mass = 500.0;
  const double h = 1e-6;
  double x = -1e-4;
  double v = 0.2;
  for (int i = 0; i < 100000 && (v > 0.0 || x > -1e-4); ++i)
  {
    x += 0.5 * h * v;
    v -= h / mass * bit_bottom_force(elastic, x, v, RockBreaking{}, 0.0).value;
    x += 0.5 * h * v;
  }
  EXPECT_NEAR(v, -0.2, 1e-6);
}

}  // namespace
}  // namespace drill_rig_sim::test_contact_bit_bottom
