// SPDX-License-Identifier: BSD-3-Clause
// Chains of beam elements against closed forms: large deflection, roll-up, P-delta, buckling, torsion, shear, a bend in space.
#include <gtest/gtest.h>

#include <cmath>

#include "beam_problems.h"

namespace test_string_beam_chain
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double kLength = 10.0;        // of every chain [m]
constexpr double kBending = 1e6;        // E I [N m2]
constexpr double kInextensible = 1e13;  // E A that stretches nothing [N]

BeamChain slender_cantilever(int count, double axial = kInextensible)
{
  return BeamChain::cantilever(count, section_of(kLength / count, axial, kBending, 1e6));
}

/// Distance of the chain's tip from the elastica's, over L.
double elastica_error(int count, double load)
{
  // stretch below 1e-6; more would make Newton's steps needlessly small
  BeamChain chain = slender_cantilever(count, 1e6 * load * kBending / (kLength * kLength));
  load_in_steps(chain, 20, [&](BeamChain& c, double part) { c.tip().force.y() = part * load * kBending / (kLength * kLength); });
  const Elastica exact = elastica(load);
  const Vector3d& tip = chain.tip().position;
  return std::hypot(tip.y() / kLength - exact.drop, 1.0 - tip.x() / kLength - exact.shortening);
}

/// Distance of the rolled-up tip from the root, over L.
double roll_up_gap(int count)
{
  BeamChain chain = slender_cantilever(count, 1e4 * kBending / (kLength * kLength));  // there is no axial force
  load_in_steps(chain, 16, [&](BeamChain& c, double part) { c.tip().moment.z() = part * 2.0 * pi * kBending / kLength; });
  return chain.tip().position.norm() / kLength;
}

/// Tip deflection of a column with a small lateral tip force, over the closed form; axial force + tension.
double p_delta_ratio(int count, double axial, bool tension)
{
  const double u = kLength * std::sqrt(axial / kBending);
  const double lateral = 1e-3;  // small: deflections of 1e-7 L
  BeamChain chain = slender_cantilever(count);
  chain.tip().force = Vector3d(tension ? axial : -axial, lateral, 0.0);
  EXPECT_TRUE(chain.solve());
  const double factor = tension ? 3.0 * (u - std::tanh(u)) / (u * u * u) : 3.0 * (std::tan(u) - u) / (u * u * u);
  return chain.tip().position.y() / (factor * lateral * std::pow(kLength, 3) / (3.0 * kBending));
}

/// Euler load of the pinned column over pi^2 E I/L^2.
double buckling_ratio(int count)
{
  const double euler = pi * pi * StraightColumn::bending / (StraightColumn::length * StraightColumn::length);
  const StraightColumn column{StraightColumn::pinned, StraightColumn::sliding};
  return critical_load([&](double force) { return column.loaded(find_beam(ElementKind::automatic), count, force); }, 0,
                       0.5 * euler, 2.0 * euler) /
         euler;
}
}  // namespace

// The reference itself against Mattiasson's table (1981), five figures.
TEST(BeamChain, elasticaReferenceMatchesMattiassonsTable)
{
  const double table[4][3] = {
      {1.0, 0.30172, 0.05643}, {2.0, 0.49346, 0.16064}, {5.0, 0.71379, 0.38763}, {10.0, 0.81061, 0.55500}};
  for (const auto& row : table)
  {
    EXPECT_NEAR(elastica(row[0]).drop, row[1], 6e-6);
    EXPECT_NEAR(elastica(row[0]).shortening, row[2], 6e-6);
  }
}

// Element tilts a leave an energy error a^2/12: second order in the mesh. At load 10 the root curves by 4.4/L, so with 32
// elements a = 0.07 there and the tip is good to about 4e-4 of the curvature.
TEST(BeamChain, cantileverUnderTipForceFollowsTheElastica)
{
  for (double load : {0.5, 1.0, 2.0, 5.0, 10.0})
  {
    const double coarse = elastica_error(16, load), fine = elastica_error(32, load);
    EXPECT_LT(fine, 1e-3) << load;
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2) << load;
  }
}

TEST(BeamChain, tipMomentRollsUpAFullCircleAtSecondOrder)
{
  const double coarse = roll_up_gap(16), middle = roll_up_gap(32), fine = roll_up_gap(64);
  EXPECT_LT(fine, 2e-3);
  EXPECT_NEAR(std::log2(coarse / middle), 2.0, 0.1);
  EXPECT_NEAR(std::log2(middle / fine), 2.0, 0.05);
}

// The cubic with its consistent geometric stiffness errs by (P/P_e)^2 (l/L)^4: with 8 elements below 1e-4 up to 0.8 of the
// cantilever's buckling load pi^2 E I/(4 L^2); in tension u = 5 is a boundary layer of L/5.
TEST(BeamChain, axialForceSoftensAndStiffensBending)
{
  const double critical = 0.25 * pi * pi * kBending / (kLength * kLength);
  for (double share : {0.1, 0.5, 0.8}) EXPECT_NEAR(p_delta_ratio(8, share * critical, false), 1.0, 1e-4) << share;
  for (double u : {1.0, 2.0, 5.0}) EXPECT_NEAR(p_delta_ratio(8, u * u * kBending / (kLength * kLength), true), 1.0, 2e-3) << u;
  // one element a column: still P-delta, to a part in a hundred at half the buckling load
  EXPECT_NEAR(p_delta_ratio(1, 0.5 * critical, false), 1.0, 1e-2);
}

// One cubic element over a half wave has 12 E I/L^2 (its two end rotations are all it has), 21.6 % high: a half wave needs two.
TEST(BeamChain, pinnedColumnBucklesAtEulersLoad)
{
  EXPECT_NEAR(buckling_ratio(1), 12.0 / (pi * pi), 1e-6);
  EXPECT_NEAR(buckling_ratio(2), 1.0, 1e-2);
  EXPECT_NEAR(buckling_ratio(4), 1.0, 1e-3);
  EXPECT_NEAR(buckling_ratio(8), 1.0, 1e-4);
}

TEST(BeamChain, torsionIsExact)
{
  const double torsion = 7e5, torque = 3e4;
  BeamChain chain = BeamChain::cantilever(5, section_of(2.0, 1e9, kBending, torsion));
  chain.tip().moment.x() = torque;
  ASSERT_TRUE(chain.solve());
  EXPECT_NEAR(twist_between(chain.nodes[0].orientation, chain.tip().orientation), torque * kLength / torsion, 1e-12);
  for (const BeamForces& f : chain.forces) EXPECT_NEAR(f.torque, torque, 1e-8 * torque);
}

TEST(BeamChain, stretchIsExact)
{
  BeamChain chain = BeamChain::cantilever(5, section_of(2.0, 1e9, kBending, 1e6));
  chain.tip().force.x() = 4e5;
  ASSERT_TRUE(chain.solve());
  EXPECT_NEAR(chain.tip().position.x() - kLength, 4e5 * kLength / 1e9, 1e-12);
}

// Timoshenko, L/D = 2.5: shear is a fifth of the deflection. Linear range (1e-6 L); the element is exact for end loads.
TEST(BeamChain, shortCantileverShears)
{
  const double diameter = 0.2, bore = 0.08, length = 0.5, young = 206e9, nu = 0.3, force = 100.0;
  const BeamSection pipe = tube_section(length, diameter, bore, young, nu);
  BeamChain chain = BeamChain::cantilever(1, pipe);
  chain.tip().force.y() = force;
  ASSERT_TRUE(chain.solve());
  const double area = pi / 4.0 * (diameter * diameter - bore * bore);
  const double inertia = pi / 64.0 * (std::pow(diameter, 4) - std::pow(bore, 4));
  const double m2 = bore * bore / (diameter * diameter);
  const double kappa = 6.0 * (1.0 + nu) * (1.0 + m2) * (1.0 + m2) /
                       ((7.0 + 6.0 * nu) * (1.0 + m2) * (1.0 + m2) + (20.0 + 12.0 * nu) * m2);  // Cowper 1966, hollow circle
  const double bending = force * std::pow(length, 3) / (3.0 * young * inertia);
  const double shearing = force * length / (kappa * young / (2.0 * (1.0 + nu)) * area);
  EXPECT_GT(shearing, 0.1 * bending);
  EXPECT_NEAR(chain.tip().position.y(), bending + shearing, 1e-6 * bending);
  EXPECT_NEAR(x_axis(chain.tip().orientation).y(), force * length * length / (2.0 * young * inertia), 1e-6 * bending / length);
}

// Consistent end moments of the spread load make the tip of the linear cantilever exact with one element: w L^4/(8 E I).
TEST(BeamChain, weightBendsTheCantilever)
{
  BeamChain chain = slender_cantilever(1);
  const double load = 10.0;
  chain.elements[0].load.z() = -load;
  ASSERT_TRUE(chain.solve());
  EXPECT_NEAR(chain.tip().position.z(), -load * std::pow(kLength, 3) / (8.0 * kBending),
              1e-6 * load * std::pow(kLength, 3) / kBending);
}

// Converged tips on which three other codes and a shooting solution agree to 1e-4 of the deflection.
TEST(BeamChain, bendInSpaceReachesTheConvergedTip)
{
  EXPECT_LT((bend_45_tip(bend_45(64), 300.0) - Vector3d(22.2447, 58.7789, 40.1924)).norm(), 1e-4 * 43.0);
  EXPECT_LT((bend_45_tip(bend_45(64), 450.0) - Vector3d(18.5081, 52.2383, 48.5035)).norm(), 1e-4 * 53.0);
  EXPECT_LT((bend_45_tip(bend_45(64), 600.0) - Vector3d(15.6847, 47.1501, 53.4755)).norm(), 1e-4 * 60.0);
}
}  // namespace test_string_beam_chain
