// SPDX-License-Identifier: BSD-3-Clause
// Blades that cut what the blade before left: weights by hand, and the ground's memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/contact/bit_cut.h"
#include "drill_rig_sim/contact/cut_ground.h"
#include "drill_rig_sim/math/units.h"

namespace test_contact_bit_cut
{
using namespace drill_rig_sim;

namespace
{
constexpr int kBlades = 5;
constexpr double kSector = 2.0 * pi / kBlades;
constexpr double kCell = kSector / CutGround::cells;
const BitCutLaw kLaw{1e7, 2e4};  // [N/m], [N]

FormationLayer rock(double drillability, double threshold)
{
  FormationLayer layer;
  layer.drillability = drillability;
  layer.threshold = threshold;
  return layer;
}

/// Turns and sinks the bit in steps of `step` [rad], by a height that is a function of the angle.
template <class Height>
double turn(CutGround& ground, double from, double to, double step, const Height& height)
{
  double lowered = 0.0;
  for (long k = 1; k <= std::lround((to - from) / step); ++k)
    lowered += cut(ground, kBlades, from + k * step, height(from + k * step));
  return lowered;
}
}  // namespace

// In steady drilling a blade cuts v t_n = v 2 pi/(n N), and the mean law's weight is F_0 + v/(K N), whatever the speed.
TEST(BitCut, itsMeanIsTheMeanLaw)
{
  BitTorqueSpec spec;
  spec.model = BitTorqueModel::regenerative;
  spec.blades = kBlades;
  spec.wear_weight = 2e3;
  const FormationLayer layer = rock(1.3e-7, 5e3);
  for (const double speed : {3.0, 12.0})
  {
    const double v = on_axis_rop(layer, speed, 25e3);
    const CutWeight weight = cut_weight(bit_cut_law(spec, layer), v * kSector / speed, 0.0, 5e3);
    EXPECT_NEAR(weight.weight(), 25e3, 1e-9);
    EXPECT_NEAR(weight.flats, 5e3, 1e-9);
    // and the torque that of the drag bit: a W_c/(2 zeta) + mu gamma (a/2) W_f
    const CutArms arms = cut_arms(spec, 0.2, layer);
    EXPECT_NEAR(arms.cutters * weight.cutters + arms.flats * spec.wear_weight, 0.1 * 20e3 / 1.2 + 0.6 * 0.05 * 2e3, 1e-9);
    EXPECT_NEAR(bit_torque_limit(spec, 0.2, 25e3, speed, layer).value, 0.1 * 20e3 / 1.2 + 0.6 * 0.05 * 2e3, 1e-9);
  }
}

TEST(BitCut, theCutsTorqueIsItsEnergy)
{
  BitTorqueSpec spec;
  spec.cutting_energy = 60e6;
  const FormationLayer layer = rock(2e-8, 0.0);
  // epsilon a^2 d/2 with d = 2 pi K W_c
  EXPECT_NEAR(cut_arms(spec, 0.2, layer).cutters * 3e4, 60e6 * 0.01 * 2.0 * pi * 2e-8 * 3e4 / 2.0, 1e-9);
}

TEST(BitCut, withoutContactThereIsNoWeight)
{
  EXPECT_EQ(cut_weight(kLaw, 0.0, 0.0, 2e4).weight(), 0.0);
  EXPECT_EQ(cut_weight(kLaw, -1e-3, 1e-3, 2e4).weight(), 0.0);
  EXPECT_EQ(resting_cut_weight(kLaw, -1e-3).weight(), 0.0);
}

// All of it on the way down, none on the way up, anything between at rest.
TEST(BitCut, theFlatsCarryOnTheWayDownAlone)
{
  const double depth = 1e-3;
  EXPECT_EQ(cut_weight(kLaw, depth, 1e-5, 2e4).flats, 2e4);
  EXPECT_EQ(cut_weight(kLaw, depth, -2.0 * flats_height, 2e4).flats, 0.0);
  EXPECT_NEAR(cut_weight(kLaw, depth, -0.25 * flats_height, 2e4).flats, 1.5e4, 1e-9);
  EXPECT_NEAR(cut_weight(kLaw, depth, 0.25 * flats_height, 0.0).flats, 0.5e4, 1e-9);
  EXPECT_NEAR(cut_weight(kLaw, 0.5 * flats_height, 1e-3, 0.0).flats, 1e4, 1e-9) << "as much as the depth lets them";
  EXPECT_EQ(resting_cut_weight(kLaw, depth).weight(), 1e4 + 2e4);
}

TEST(BitCut, slopesAreTheDerivatives)
{
  constexpr double h = 1e-9;
  struct
  {
    double depth, sunk, flats;
  } const cases[] = {{1e-3, 1e-5, 2e4},  {1e-3, -2e-5, 2e4}, {5e-5, 1e-4, 0.0},
                     {5e-5, -4e-5, 1e4}, {1e-3, -1e-3, 2e4}, {-1e-3, 0.0, 0.0}};
  for (const auto& c : cases)
  {
    const CutWeight at = cut_weight(kLaw, c.depth, c.sunk, c.flats);
    const CutWeight deeper = cut_weight(kLaw, c.depth + h, c.sunk, c.flats),
                    lower = cut_weight(kLaw, c.depth, c.sunk + h, c.flats);
    const CutWeight shallower = cut_weight(kLaw, c.depth - h, c.sunk, c.flats),
                    higher = cut_weight(kLaw, c.depth, c.sunk - h, c.flats);
    EXPECT_NEAR(at.cutters_by_depth, (deeper.cutters - shallower.cutters) / (2.0 * h), 10.0);
    EXPECT_NEAR(at.flats_by_depth, (deeper.flats - shallower.flats) / (2.0 * h), 10.0);
    EXPECT_NEAR(at.flats_by_height, (lower.flats - higher.flats) / (2.0 * h), 10.0);
  }
}

// A bit that sinks evenly finds the height of 2 pi/n ago, once the first sector is cut, and the bottom's mean follows it half a
// sector behind.
TEST(CutGround, aHelixIsSeenASectorLater)
{
  CutGround ground;
  const double pitch = 1e-3;  // [m/rad]
  const auto height = [&](double angle) { return pitch * angle; };
  for (const double step : {0.37 * kCell, 11.3 * kCell})
  {
    ground = {};
    const double end = step * std::floor(3.3 * kSector / step);
    const double lowered = turn(ground, 0.0, end, step, height);
    for (const double ahead : {1e-6, 0.4 * kCell, 7.7 * kCell})
    {
      EXPECT_NEAR(ground_ahead(ground, kBlades, end + ahead).value, height(end + ahead - kSector), 1e-12);
      EXPECT_NEAR(ground_ahead(ground, kBlades, end + ahead).slope, pitch, 1e-9);
    }
    EXPECT_NEAR(lowered, ground.mean, 1e-15);
    EXPECT_NEAR(ground.mean, height(end - 0.5 * (kSector - kCell)), 1e-2 * pitch * kCell) << "each cell counts to the next";
  }
}

// What comes round is the wave that the blade before cut: linear between cells, (2 pi k/256)^2/8 of the amplitude at most, k
// waves a sector.
TEST(CutGround, aWaveComesRound)
{
  CutGround ground;
  const double waves = 3.0, amplitude = 1e-4;
  const auto height = [&](double angle) { return 1e-3 * angle + amplitude * std::sin(waves * 2.0 * pi * angle / kSector); };
  const double step = 0.9 * kCell, end = step * std::floor(2.4 * kSector / step);
  turn(ground, 0.0, end, step, height);
  const double error = 2.0 * amplitude * std::pow(waves * 2.0 * pi / CutGround::cells, 2) / 8.0;
  for (double ahead = 0.1 * kCell; ahead < 0.9 * kSector; ahead += 0.7 * kCell)
  {
    const GroundHeight rock = ground_ahead(ground, kBlades, end + ahead);
    EXPECT_NEAR(rock.value, height(end + ahead - kSector), error);
  }
}

TEST(CutGround, slopeIsTheDerivative)
{
  CutGround ground;
  turn(ground, 0.0, 2.0 * kSector, 0.9 * kCell, [](double angle) { return 1e-3 * angle + 1e-4 * std::sin(9.0 * angle); });
  constexpr double h = 1e-7;
  for (double at = ground.front + 0.3 * kCell; at < ground.front + kSector; at += 5.17 * kCell)
    EXPECT_NEAR(ground_ahead(ground, kBlades, at).slope,
                (ground_ahead(ground, kBlades, at + h).value - ground_ahead(ground, kBlades, at - h).value) / (2.0 * h), 1e-7);
}

// A bit above all that is left cuts nothing; the rock does not grow back.
TEST(CutGround, aJumpLeavesTheRockAsItWas)
{
  CutGround ground;
  turn(ground, 0.0, 2.0 * kSector, 0.9 * kCell, [](double angle) { return 1e-3 * angle; });
  const double mean = ground.mean, front = ground.front;
  const auto before = ground.heights;
  turn(ground, front, front + 2.5 * kSector, 0.9 * kCell, [](double) { return -1.0; });
  EXPECT_NEAR(ground.mean, mean, 1e-3 * kCell);
  for (int i = 0; i < CutGround::cells; ++i) EXPECT_NEAR(ground.heights[i], before[i], 1.01 * 1e-3 * kSector) << i;
  EXPECT_GE(*std::min_element(ground.heights.begin(), ground.heights.end()), *std::min_element(before.begin(), before.end()));
}

TEST(CutGround, aBitThatTurnsBackCutsNothing)
{
  CutGround ground;
  turn(ground, 0.0, 2.0 * kSector, 0.9 * kCell, [](double angle) { return 1e-3 * angle; });
  const double front = ground.front, stands_on = ground_ahead(ground, kBlades, front).value;
  const auto before = ground.heights;
  EXPECT_EQ(cut(ground, kBlades, front - 0.5 * kSector, 1.0), 0.0);
  EXPECT_EQ(ground.heights, before);
  EXPECT_EQ(ground_ahead(ground, kBlades, front - 0.5 * kSector).value, stands_on);
  EXPECT_EQ(ground_ahead(ground, kBlades, front - 0.5 * kSector).slope, 0.0);
}

// Far from the start, and with more than a sector in a step, the ring stays a ring.
TEST(CutGround, manyTurnsAndLongSteps)
{
  CutGround ground;
  const double far = 1e5 * 2.0 * pi;
  ground.angle = ground.front = far;
  turn(ground, far, far + 3.0 * kSector, 0.9 * kCell, [&](double angle) { return 1e-3 * (angle - far); });
  const double end = ground.front;
  EXPECT_NEAR(ground_ahead(ground, kBlades, end + 0.5 * kCell).value, 1e-3 * (end + 0.5 * kCell - kSector - far), 1e-10);
  cut(ground, kBlades, end + 3.0 * kSector, 1e-3 * (end + 3.0 * kSector - far));
  EXPECT_NEAR(ground_ahead(ground, kBlades, ground.front + 0.5 * kCell).value,
              1e-3 * (ground.front + 0.5 * kCell - kSector - far), 1e-10);
}
}  // namespace test_contact_bit_cut
