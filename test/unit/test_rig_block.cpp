// SPDX-License-Identifier: BSD-3-Clause
// What hinders the block: friction of its rail, its stops; and what the dead line shows of the sheaves' friction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/hoisting.h"

namespace drill_rig_sim::test_rig_block
{
// 3 % of 17.5 t: 0.03 * 9.80665 * 17500 = 5148.49 N, held over 1.03 mm; c = sqrt(5e6 * 17500) = 295804 N s/m, c/k = 59.2 ms.
TEST(Rail, FrictionByHand)
{
  const HoistingSpec spec;
  const BristleForce held = rail_bristle(spec, 2e-4).at(1e-4, 1e-3, 0.01);
  EXPECT_NEAR(held.force, -(5e6 * 3e-4 + 295.804), 1e-3);
  EXPECT_NEAR(held.next, 3e-4, 1e-15);
  EXPECT_EQ(held.by_move, -5e6);
  EXPECT_NEAR(held.by_speed, -295804.0, 0.1);
  const BristleForce up = rail_bristle(spec, 2e-4).at(3e-3, 0.3, 0.01);
  EXPECT_NEAR(up.force, -5148.49, 0.01);
  EXPECT_NEAR(up.next, 2e-4 + (1.029698e-3 - 2e-4) * 0.01 / 0.0691608, 1e-9);
  EXPECT_EQ(up.by_move, 0.0);
  EXPECT_EQ(up.by_speed, 0.0);
  EXPECT_NEAR(rail_bristle(spec, 0.0).at(-3e-3, -0.3, 0.01).force, 5148.49, 0.01);
}

// 34 m up with 407 kN: L_0 = 180 m / (1 + 40.7e3/4e7) = 179.817 m, k = 100 * 4e7 / L_0 = 22.2448 MN/m, c = 0.06 sqrt(k 17500) =
// 37435 N s/m.
TEST(LineDamper, byHand)
{
  const HoistingSpec spec;
  const LinePull pull = line_pull(spec, 34.0, line_length_for(spec, 34.0, 407e3));
  const LineDamper damper = line_damper(spec, pull, -0.1, 0.02);
  EXPECT_NEAR(damper.force, 0.12 * 37435.0, 1.0);
  EXPECT_NEAR(damper.damping, 37435.0, 1.0);
  EXPECT_EQ(line_damper(spec, pull, 0.3, 0.3).force, 0.0) << "the block goes as the drum does";
  const LineDamper pushing = line_damper(spec, pull, 11.0, 0.0);
  EXPECT_EQ(pushing.force, -pull.hook_force) << "lines do not push";
  EXPECT_EQ(pushing.damping, 0.0);
  const LineDamper slack = line_damper(spec, line_pull(spec, 34.1, line_length_for(spec, 34.0, 407e3)), -1.0, 0.0);
  EXPECT_EQ(slack.force, 0.0);
  EXPECT_EQ(slack.damping, 0.0);
}

// The field's figure (model.md, "Hoisting has losses"): 66 t up against down, 40 kN.
TEST(Rail, MakesFortyKilonewtonsOfSixtySixTons)
{
  HoistingSpec spec;
  spec.block_mass = 66e3;
  const double down = rail_bristle(spec, 0.0).at(-1.0, -0.1, 1.0).force, up = rail_bristle(spec, 0.0).at(1.0, 0.1, 1.0).force;
  EXPECT_NEAR(down - up, 40e3, 0.05 * 40e3);
}

TEST(Rail, NoFrictionHoldsNothing)
{
  HoistingSpec spec;
  spec.rail_friction = 0.0;
  const BristleForce f = rail_bristle(spec, 0.0).at(1e-3, 0.1, 0.01);
  EXPECT_EQ(f.force, 0.0);
  EXPECT_EQ(f.by_move, 0.0);
}

// A block on a spring K under Coulomb friction R loses 4 R/K of its amplitude a cycle once it slides both ways, and rests where
// the friction holds it (any book on vibration). The bristle adds its own give: R/k on either side of each turn.
TEST(Rail, EndsABounceLinearly)
{
  const HoistingSpec spec;
  const double line = 1.2e7, mass = spec.block_mass, h = 1e-4, most = 5148.49;
  double x = 0.02, v = 0.0, z = 0.0, last = x, peak = x;
  int cycles = 0;
  for (int i = 0; i < 100000; ++i)
  {
    // implicit Euler of the block, Newton on its increment
    double u = h * v;
    BristleForce rail;
    for (int k = 0; k < 20; ++k)
    {
      rail = rail_bristle(spec, z).at(u, u / h, h);
      const double r = mass * (u / h - v) / h + line * (x + u) - rail.force;
      u -= r / (mass / (h * h) + line - rail.by_move - rail.by_speed / h);
    }
    const double before = v;
    x += u;
    v = u / h;
    z = rail.next;
    if (before > 0.0 && v <= 0.0 && peak > 5e-3)
    {
      if (cycles++ > 0)
      {
        EXPECT_NEAR(last - x, 4.0 * most / line, 0.35 * 4.0 * most / line) << cycles;
      }
      peak = last = x;
    }
  }
  EXPECT_GE(cycles, 4);
  EXPECT_LT(std::abs(x), most / line);
  EXPECT_LT(std::abs(v), 1e-6);
}

// k p (1 + d dp/dt), 1e8 * 0.01 * (1 + 2 * 0.3) = 1.6 MN; never a pull; nothing between the stops.
TEST(Stop, ByHand)
{
  const HoistingSpec spec;
  const double low = spec.lowest_block_height - 0.02, high = spec.highest_block_height + 0.02;
  EXPECT_NEAR(stop_force(spec, low - 0.01, -0.3).force, 1.6e6, 1e-3);
  EXPECT_NEAR(stop_force(spec, high + 0.01, 0.3).force, -1.6e6, 1e-3);
  EXPECT_NEAR(stop_force(spec, high + 0.01, 0.0).energy, 0.5 * 1e8 * 1e-4, 1e-6);
  EXPECT_EQ(stop_force(spec, high + 0.01, -0.6).force, 0.0);
  EXPECT_NEAR(stop_force(spec, high + 0.01, -0.6).energy, 0.5 * 1e8 * 1e-4, 1e-6);
  for (const double height : {spec.lowest_block_height, 20.0, spec.highest_block_height})
  {
    EXPECT_EQ(stop_force(spec, height, 1.0).force, 0.0);
    EXPECT_EQ(stop_force(spec, height, 1.0).energy, 0.0);
  }
}

TEST(Stop, TangentByDifferences)
{
  const HoistingSpec spec;
  for (const double height : {spec.lowest_block_height - 0.04, spec.highest_block_height + 0.03})
    for (const double velocity : {-0.2, 0.0, 0.3})
    {
      const StopForce f = stop_force(spec, height, velocity);
      const double e = 1e-6;
      const double k = -(stop_force(spec, height + e, velocity).force - stop_force(spec, height - e, velocity).force) / (2.0 * e);
      const double c = -(stop_force(spec, height, velocity + e).force - stop_force(spec, height, velocity - e).force) / (2.0 * e);
      EXPECT_NEAR(f.stiffness, k, 1e-6 * k);
      EXPECT_NEAR(f.damping, c, 1e-6 * c);
    }
}

TEST(DeadLine, SheaveTheoryByHand)
{
  // Ten lines, e = 0.98: 1 - e^10 = 0.1829272, lowering reads 10 * 0.02 / 0.1829272 = 1.0933314 of the load,
  // hoisting that times e^9 = 0.8337478.
  EXPECT_NEAR(dead_line_hook_load(400e3, -1.0, 5, 0.98), 400e3 * 1.0933314, 0.1);
  EXPECT_NEAR(dead_line_hook_load(400e3, 1.0, 5, 0.98), 400e3 * 1.0933314 * 0.8337478, 0.1);
  EXPECT_DOUBLE_EQ(dead_line_hook_load(400e3, 0.0, 5, 0.98), 400e3);
  EXPECT_DOUBLE_EQ(dead_line_hook_load(400e3, 1.0, 5, 1.0), 400e3);
}

TEST(DeadLine, AgreesWithTheFastLineFactor)
{
  // API RP 9B, efficiency of the block with N lines and S = N sheaves of factor K: (K^N - 1) / (K^N N (K - 1)); the published
  // table gives 0.811 for ten lines on roller bearings, K = 1.04. The dead line is the fast line's tension over K^N.
  const double k = 1.04;
  const double kn = std::pow(k, 10);
  const double efficiency = (kn - 1.0) / (kn * 10.0 * (k - 1.0));
  EXPECT_NEAR(efficiency, 0.811, 5e-4);
  const double fast_line = 400e3 / (10.0 * efficiency);
  EXPECT_NEAR(dead_line_hook_load(400e3, 1.0, 5, 1.0 / k), 10.0 * fast_line / kn, 1e-6);
}

// 1 cm of travel from rest to full friction, 2 cm from one way to the other; then it stays.
TEST(DeadLine, FrictionTurnsOverTwoCentimetres)
{
  double slip = sheave_slip(0.0, 0.004);
  EXPECT_DOUBLE_EQ(slip, 0.4);
  slip = sheave_slip(slip, 0.5);
  EXPECT_EQ(slip, 1.0);
  for (int i = 0; i < 20; ++i) slip = sheave_slip(slip, -0.001);
  EXPECT_NEAR(slip, -1.0, 1e-12);
  EXPECT_EQ(sheave_slip(slip, 0.0), slip);
  double last = dead_line_hook_load(1.0, -1.0, 5, 0.98);
  for (int i = -999; i <= 1000; ++i)
  {
    const double now = dead_line_hook_load(1.0, 1e-3 * i, 5, 0.98);
    EXPECT_LT(now, last);
    EXPECT_GT(now, last - 1e-3);
    last = now;
  }
}
}  // namespace drill_rig_sim::test_rig_block
