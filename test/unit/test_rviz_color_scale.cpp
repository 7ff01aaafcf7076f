// SPDX-License-Identifier: BSD-3-Clause
// Colours of the display against what its legend says: ends, order, ticks; a scale that does not flicker.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "rviz/picture/color_scale.h"
#include "rviz/picture/coloring.h"

namespace drill_rig_sim::test_rviz_color_scale
{
namespace
{
bool same(const Color& a, const Color& b)
{
  return a.r == b.r && a.g == b.g && a.b == b.b;
}
}  // namespace

TEST(ColorScale, beyondItsEndsIsTheEndsColor)
{
  const ColorScale scale(-10.0, 40.0);
  EXPECT_TRUE(same(scale.at(40.0), scale.at(1e9)));
  EXPECT_TRUE(same(scale.at(-10.0), scale.at(-1e9)));
  EXPECT_FALSE(same(scale.at(40.0), scale.at(20.0)));
}

// As one without the green receptors sees a colour: Viénot, Brettel and Mollon 1999, on linear RGB; here only what differs
// between colours.
std::array<double, 2> deuteranope(const Color& c)
{
  const double r = std::pow(c.r, 2.2), g = std::pow(c.g, 2.2), b = std::pow(c.b, 2.2);
  return {0.29275 * r + 0.70725 * g, -0.02234 * r + 0.02234 * g + b};  // red and green are one; blue
}

TEST(ColorScale, theColourBlindCanTellValuesApart)
{
  const auto differ = [](const Color& a, const Color& b)
  {
    const auto x = deuteranope(a), y = deuteranope(b);
    return std::hypot(std::pow(x[0], 1.0 / 2.2) - std::pow(y[0], 1.0 / 2.2),
                      std::pow(std::max(x[1], 0.0), 1.0 / 2.2) - std::pow(std::max(y[1], 0.0), 1.0 / 2.2));
  };
  const ColorScale one(0.0, 40.0), both(-40.0, 40.0);
  for (int a = 0; a <= 4; ++a)
    for (int b = 0; b < a; ++b)
    {
      EXPECT_GT(differ(one.at(10.0 * a), one.at(10.0 * b)), 0.1) << a << " " << b;
      EXPECT_GT(differ(both.at(20.0 * a - 40.0), both.at(20.0 * b - 40.0)), 0.1) << a << " " << b;
    }
}

TEST(ColorScale, orangeIsAboveZeroAndBlueBelow)
{
  const ColorScale scale(-10.0, 40.0);
  for (const double value : {10.0, 20.0, 40.0}) EXPECT_GT(scale.at(value).r, scale.at(value).b) << value;
  for (const double value : {-3.0, -5.0, -10.0}) EXPECT_GT(scale.at(value).b, scale.at(value).r) << value;
}

TEST(ColorScale, noNumberIsGrey)
{
  const Color c = ColorScale(0.0, 1.0).at(std::nan(""));
  EXPECT_TRUE(c.r == c.g && c.g == c.b);
}

TEST(ColorScale, senselessEndsMakeAScaleAllTheSame)
{
  for (const double high : {0.0, -3.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(1.0, ColorScale(0.0, high).high());
  EXPECT_EQ(0.0, ColorScale(5.0, 10.0).low());
}

TEST(ColorScale, ticksAreRoundAndReachFromEndToEnd)
{
  EXPECT_EQ((std::vector<double>{0.0, 10.0, 20.0, 30.0, 40.0, 50.0}), ColorScale(0.0, 50.0).ticks(6));
  EXPECT_EQ((std::vector<double>{-50.0, 0.0, 50.0, 100.0, 150.0, 200.0}), ColorScale(-50.0, 200.0).ticks(6));
  for (const double high : {0.3, 1.0, 7.0, 25.0, 123.0, 4e6})
    for (const int most : {2, 4, 6, 10})
    {
      const std::vector<double> ticks = ColorScale(-0.4 * high, high).ticks(most);
      EXPECT_GE(ticks.size(), 2u) << high << " " << most;
      EXPECT_LE(ticks.size(), static_cast<std::size_t>(most + 1)) << high << " " << most;
      EXPECT_GE(ticks.front(), -0.4 * high * 1.0001);
      EXPECT_LE(ticks.back(), high * 1.0001);
    }
}

TEST(RoundUp, isTheNextOfOneTwoTwoAndAHalfFive)
{
  EXPECT_DOUBLE_EQ(1.0, round_up(1.0));
  EXPECT_DOUBLE_EQ(2.0, round_up(1.01));
  EXPECT_DOUBLE_EQ(25.0, round_up(20.1));
  EXPECT_DOUBLE_EQ(0.05, round_up(0.03));
  EXPECT_DOUBLE_EQ(1000.0, round_up(501.0));
  EXPECT_DOUBLE_EQ(1.0, round_up(0.0));
  EXPECT_DOUBLE_EQ(1.0, round_up(std::nan("")));
}

TEST(SteadyRange, growsAtOnceAndShrinksLate)
{
  SteadyRange range;
  range.take({0.0, 3.0, -1.5}, 1.0);
  EXPECT_DOUBLE_EQ(5.0, range.scale().high());
  EXPECT_DOUBLE_EQ(-2.0, range.scale().low());
  range.take({80.0, -1.5}, 1.0);
  EXPECT_DOUBLE_EQ(100.0, range.scale().high());
  for (int i = 0; i < 50; ++i) range.take({3.0, -1.5}, 1.0);
  EXPECT_DOUBLE_EQ(100.0, range.scale().high());
  range.take({3.0, -1.5}, 1.0);
  EXPECT_DOUBLE_EQ(5.0, range.scale().high());
}

TEST(SteadyRange, cutsOffTheFewThatAreFarLarger)
{
  SteadyRange range;
  std::vector<double> values(100, 1.0);
  values[0] = 1000.0;
  range.take(values, 0.95);
  EXPECT_DOUBLE_EQ(1.0, range.scale().high());
}

TEST(Written, hasTheDigitsThatTellTicksApart)
{
  EXPECT_EQ("0", written(-0.0, 10.0));
  EXPECT_EQ("250", written(250.0, 50.0));
  EXPECT_EQ("0.4", written(0.4, 0.2));
  EXPECT_EQ("2.5", written(2.5, 2.5));
  EXPECT_EQ("0.05", written(0.05, 0.05));
}

TEST(SideForce, isThatOfAMetreHoweverFineTheMesh)
{
  StringData d;
  d.from_bit = {0.0, 1.0, 2.0, 12.0, 22.0};
  d.position.resize(d.from_bit.size());
  d.contact_force = {100.0, 200.0, 1100.0, 2000.0, 1000.0};  // 200 N/m
  for (const double force : side_force(d)) EXPECT_NEAR(200.0, force, 1e-9);
}

TEST(Coloring, eachIsItsOwnQuantityInItsUnit)
{
  StringData d;
  d.position.resize(2);
  d.from_bit = {0.0, 20.0};  // each node stands for 10 m
  d.tension = {2e3, 0.0};
  d.torque = {3e3, 0.0};
  d.bending_stress = {4e6, 0.0};
  d.contact_force = {50e3, 0.0};
  d.spin_speed = {2.0 * M_PI, 0.0};
  d.buckling = {0.7, 0.0};
  d.guided = {1, 0};
  const std::vector<double> expected{2.0, 3.0, 4.0, 5.0, 60.0, 0.7, 1.0};
  ASSERT_EQ(expected.size(), colorings().size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(expected[i], values_of(i, d).front(), 1e-12) << colorings()[i].name;
  // klbf, kft.lbf, ksi, klbf/ft, rpm: 1 lbf = 4.4482216 N, 1 ft = 0.3048 m, 1 psi = 6894.757 Pa
  const std::vector<double> oilfield{
      2.0 / 4.4482216, 3.0 / (4.4482216 * 0.3048), 4.0 / 6.894757, 5.0 / (4.4482216 / 0.3048), 60.0, 0.7, 1.0};
  for (std::size_t i = 0; i < oilfield.size(); ++i)
    EXPECT_NEAR(oilfield[i], values_of(i, d, UnitSystem::oilfield).front(), 1e-6) << colorings()[i].name;
}

// A vertical hole without contact: side forces of 1e-9 N/m would be a scale of ticks "0.000000000".
TEST(Coloring, whatIsOnlyRoundingHasNoScaleOfItsOwn)
{
  const Coloring& contact = colorings()[3];
  const ColorScale none = at_least(ColorScale(0.0, 2e-12), contact, UnitSystem::si);
  EXPECT_EQ(0.0, none.low());
  EXPECT_DOUBLE_EQ(0.01, none.high()) << "kN/m";
  EXPECT_DOUBLE_EQ(0.001, at_least(ColorScale(0.0, 2e-12), contact, UnitSystem::oilfield).high()) << "klbf/ft, round";
  const Coloring& tension = colorings()[0];
  EXPECT_EQ(0.0, at_least(ColorScale(-0.5, 500.0), tension, UnitSystem::si).low());
  EXPECT_EQ(-2.0, at_least(ColorScale(-2.0, 500.0), tension, UnitSystem::si).low());
  EXPECT_EQ(500.0, at_least(ColorScale(-2.0, 500.0), tension, UnitSystem::si).high());
}

}  // namespace drill_rig_sim::test_rviz_color_scale
