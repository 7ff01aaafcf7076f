// SPDX-License-Identifier: BSD-3-Clause
// Laws of cuttings: published slip and critical speeds, steady transport, no rock lost, a bed that grows and goes, its height and
// drag.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "drill_rig_sim/hydraulics/cuttings.h"
#include "drill_rig_sim/math/units.h"

namespace test_hydraulics_cuttings
{
using namespace drill_rig_sim;

namespace
{
constexpr double foot = 0.3048, inch = 0.0254, ppg = 119.8264, pound_per_100_feet2 = 0.4788026;
constexpr double hole = 0.2159, pipe = 0.127;
const Passage annulus = {hole, pipe, 0.0};
const double around = annulus.area(), whole = 0.25 * pi * hole * hole;

CuttingsFluid mud_with_cuttings()
{
  return {{5.0, 0.02, 1.0}, 1200.0, {}};
}

CuttingsCell cell_at(double inclination)
{
  return {annulus, 10.0, inclination};
}

double excess_speed(const CuttingsCell& cell, double flow, double rotation, double rop)
{
  return flow / around - critical_cuttings_speed(mud_with_cuttings(), cell, rop, rotation);
}

/// After hours of a feed, by steps of a second.
struct Fed
{
  CuttingsContent content;
  double out = 0.0;  // in the last second [m3]

  Fed(const CuttingsCell& cell, double flow, double rotation, double feed, CuttingsContent begin = {}, int seconds = 40000)
      : content(begin)
  {
    for (int k = 0; k < seconds; ++k) out = advance_cell(mud_with_cuttings(), cell, {flow, rotation, 1.0}, feed, content);
  }
};
}  // namespace

// Lapeyrouse, Formulas and Calculations for Drilling, Production and Workover: cuttings slip velocity, method 2.
TEST(CuttingsSlip, isLapeyrousesExample)
{
  const double n = 3.32 * std::log10(36.0 / 23.0), k = 23.0 / std::pow(511.0, n) * pound_per_100_feet2;
  const double speed = 102.0 * foot / 60.0;
  const double viscosity = apparent_viscosity({0.0, k, n}, {12.25 * inch, 5.0 * inch, 0.0}, speed);
  EXPECT_NEAR(viscosity, 0.063, 0.001);
  CuttingsFluid fluid{{0.0, k, n}, 11.0 * ppg, {}};
  fluid.cuttings.density = 22.0 * ppg;
  fluid.cuttings.size = 0.25 * inch;
  const double slip = slip_speed(fluid, viscosity);
  EXPECT_NEAR(slip / foot * 60.0, 24.55, 0.25);
  EXPECT_NEAR((speed - slip) / foot * 60.0, 77.45, 0.25) << "net rise";
}

// Moore's three laws by their constants in field units: 82.87 d^2 dr/mu, 1.54 sqrt(d dr/rho) (in, lb/gal, cP, ft/s).
TEST(CuttingsSlip, isMooresInThickAndThinMud)
{
  CuttingsFluid fluid{{}, 10.0 * ppg, {}};
  fluid.cuttings.density = 21.0 * ppg;
  fluid.cuttings.size = 0.25 * inch;
  EXPECT_NEAR(slip_speed(fluid, 10.0) / foot, 82.87 * 0.0625 * 11.0 / 1e4, 1e-3 * 82.87 * 0.0625 * 11.0 / 1e4);
  EXPECT_NEAR(slip_speed(fluid, 1e-5) / foot, 1.54 * std::sqrt(0.25 * 1.1), 0.005);
  double last = slip_speed(fluid, 1e-5);
  for (double viscosity = 1e-5; viscosity < 10.0; viscosity *= 1.01)
  {
    const double now = slip_speed(fluid, viscosity);
    EXPECT_LE(now, last);
    EXPECT_GT(now, 0.98 * last) << "no jump";
    last = now;
  }
}

TEST(CuttingsSlip, growsWithInclinationAndFallsWithRotation)
{
  EXPECT_EQ(slip_factor(0.0, 0.0, 12.0 * ppg), 1.0);
  EXPECT_NEAR(slip_factor(45.0 * degree, 0.0, 12.0 * ppg), 3.0, 1e-12) << "1 + 2 I/45";
  EXPECT_NEAR(slip_factor(90.0 * degree, 0.0, 12.0 * ppg), 3.0, 1e-12);
  EXPECT_NEAR(slip_factor(60.0 * degree, -150.0 * rpm, 12.0 * ppg), 2.5, 1e-12);
  EXPECT_EQ(slip_factor(60.0 * degree, 900.0 * rpm, 12.0 * ppg), 1.0);
}

// Larsen's speed of cuttings for 50 ft/h in a hole of 5 in with pipe of 2 3/8 in, 1.29 ft/s; the slip of rock as light as the mud
// is none.
TEST(CuttingsNeed, isLarsens)
{
  CuttingsFluid fluid = mud_with_cuttings();
  fluid.cuttings.density = fluid.density * (1.0 + 1e-12);
  const CuttingsCell cell{{5.0 * inch, 2.375 * inch, 0.0}, 10.0, 60.0 * degree};
  const double rop = 50.0 * foot / 3600.0, open = 1.0 - std::pow(2.375 / 5.0, 2);
  const double speed = critical_cuttings_speed(fluid, cell, rop, 0.0);
  EXPECT_NEAR(speed / foot, 1.0 / (open * (0.64 + 18.16 / 50.0)), 1e-3);
  EXPECT_NEAR(carried_share(speed, open), 0.0001778 * 50.0 + 0.00505, 1e-5) << "his concentration at that speed";
  EXPECT_NEAR(carried_share(speed, open), rop / (open * speed), 3e-5) << "what comes is what goes, but for his rounding";
  EXPECT_EQ(carried_share(0.0, open), 0.0);
  EXPECT_EQ(carried_share(5.0, open), most_carried);
}

TEST(CuttingsNeed, growsWithPenetrationAndFallsWithRotation)
{
  const CuttingsFluid fluid = mud_with_cuttings();
  double last = 0.0;
  for (const double rop : {5.0, 10.0, 20.0, 40.0})
  {
    const double speed = critical_cuttings_speed(fluid, cell_at(1.0), rop / 3600.0, 0.0);
    const double slip = slip_speed(fluid, apparent_viscosity(fluid.curve, annulus, speed));
    const double rise = speed - slip_factor(1.0, 0.0, fluid.density) * slip, share = rop / 3600.0 * whole / (around * rise);
    EXPECT_NEAR(carried_share(rise, around / whole), share, 2e-3 * share);
    EXPECT_GT(speed, last);
    EXPECT_LT(critical_cuttings_speed(fluid, cell_at(1.0), rop / 3600.0, 12.0), speed);
    last = speed;
  }
}

// Steady: what comes in goes out at the cuttings' own speed.
TEST(CuttingsCell, holdsFeedOverTransportInAVerticalHole)
{
  const CuttingsFluid fluid = mud_with_cuttings();
  const double flow = 0.03, feed = 2e-4, speed = flow / around;
  const Fed fed(cell_at(0.0), flow, 0.0, feed);
  EXPECT_NEAR(fed.out, feed, 1e-12);
  EXPECT_EQ(fed.content.bed, 0.0);
  const double rise = speed - slip_speed(fluid, apparent_viscosity(fluid.curve, annulus, speed));
  EXPECT_NEAR(fed.content.suspended / 10.0, feed / rise, 1e-9 * feed / rise);
}

TEST(CuttingsCell, losesNoRock)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double in = 0.0, out = 0.0;
  CuttingsContent content;
  for (int k = 0; k < 20000; ++k)
  {
    const double feed = share(random) < 0.5 ? 1e-3 * share(random) : 0.0;
    in += feed;
    out += advance_cell(mud_with_cuttings(), cell_at(1.5 * share(random)),
                        {share(random) < 0.3 ? 0.0 : 0.04 * share(random), 12.0 * share(random), 1.0}, feed, content);
    ASSERT_GE(content.suspended, 0.0);
    ASSERT_GE(content.bed, 0.0);
    ASSERT_LE(content.suspended + content.bed, (1.0 - 0.4) * around * 10.0 * (1.0 + 1e-12));
  }
  EXPECT_GT(content.bed, 0.0);
  EXPECT_NEAR(out + content.suspended + content.bed, in, 1e-12 * in);
}

TEST(CuttingsBed, growsUntilTheFlowIsCriticalAndGoesAboveThat)
{
  const CuttingsCell cell = cell_at(75.0 * degree);
  const double rop = 15.0 / 3600.0, feed = rop * whole, low = 0.015, high = 0.035;
  ASSERT_LT(excess_speed(cell, low, 0.0, rop), 0.0);
  ASSERT_GT(excess_speed(cell, high, 0.0, rop), 0.0);
  const Fed settled(cell, low, 0.0, feed);
  EXPECT_NEAR(settled.out, feed, 1e-9) << "steady";
  const CuttingsFluid fluid = mud_with_cuttings();
  const double open = open_area(fluid, cell, settled.content.bed), speed = low / open;
  EXPECT_LT(open, 0.9 * around);
  const double rise = speed - slip_factor(cell.inclination, 0.0, fluid.density) *
                                  slip_speed(fluid, apparent_viscosity(fluid.curve, annulus, speed));
  EXPECT_NEAR(rise, foot * whole / open / (0.64 + 18.16 / (rop / foot * 3600.0)), 1e-3) << "Larsen's in the open area";

  EXPECT_EQ(Fed(cell, high, 0.0, feed).content.bed, 0.0) << "none forms";
  EXPECT_EQ(Fed(cell, high, 0.0, feed, settled.content).content.bed, 0.0) << "and what is there goes";
  EXPECT_GT(Fed(cell, 0.6 * low, 0.0, feed).content.bed, settled.content.bed) << "less flow";
  EXPECT_LT(Fed(cell, low, 120.0 * rpm, feed).content.bed, settled.content.bed) << "rotation";
  EXPECT_GT(Fed(cell, low, 0.0, 2.0 * feed).content.bed, settled.content.bed) << "faster drilling";
  EXPECT_EQ(Fed(cell_at(20.0 * degree), low, 0.0, feed).content.bed, 0.0) << "none in a steep hole";
}

TEST(CuttingsBed, takesAllThatRestsWithThePump)
{
  const Fed rested(cell_at(60.0 * degree), 0.0, 0.0, 0.0, {0.002, 0.0});
  EXPECT_NEAR(rested.content.bed, 0.002, 1e-9);
  const Fed steep(cell_at(0.0), 0.0, 0.0, 0.0, {0.002, 0.0});
  EXPECT_EQ(steep.content.suspended, 0.002) << "in a steep hole it stays where it is";
}

TEST(CuttingsBed, heightIsThatOfItsSection)
{
  for (double height = 0.001; height < hole; height += 0.003)
    EXPECT_NEAR(bed_height(annulus, bed_section(annulus, height)), height, 1e-5);
  EXPECT_NEAR(bed_section(annulus, hole), around, 1e-15);
  EXPECT_NEAR(bed_section({hole, 0.0, 0.0}, 0.5 * hole), 0.5 * whole, 1e-15);
  EXPECT_EQ(bed_height(annulus, 0.0), 0.0);
}

TEST(CuttingsBed, dragIsItsPressureOnWhatItCovers)
{
  const CuttingsFluid fluid = mud_with_cuttings();
  const double weight = standard_gravity * 1400.0 * 0.6;
  for (const double height : {0.01, 0.05, 0.12, 0.2})
  {
    double sum = 0.0;
    constexpr int parts = 20000;
    for (int k = 0; k < parts; ++k)
    {
      const double angle = 2.0 * pi * (k + 0.5) / parts, up = 0.5 * pipe * (1.0 - std::cos(angle));
      sum += std::max(0.0, height - up) * 0.5 * pipe * 2.0 * pi / parts;
    }
    EXPECT_NEAR(bed_drag(fluid, pipe, height), 0.5 * weight * sum, 1e-6 * weight) << height;
  }
  EXPECT_EQ(bed_drag(fluid, pipe, 0.0), 0.0);
}
}  // namespace test_hydraulics_cuttings
