// SPDX-License-Identifier: BSD-3-Clause
// Torque on bit: both limits against hand figures, the bristle's return mapping, tangents.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iterator>

#include "drill_rig_sim/contact/bit_torque.h"

namespace drill_rig_sim::test_contact_bit_torque
{
namespace
{
double central(const std::function<double(double)>& f, double x, double h)
{
  return (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h);
}

FormationLayer rock_with(double speed_exponent)
{
  FormationLayer rock;
  rock.drillability = 8.6e-9;
  rock.speed_exponent = speed_exponent;
  return rock;
}

BitTorqueSpec drag_bit()
{
  BitTorqueSpec spec;
  spec.model = BitTorqueModel::detournay;
  spec.cutting_energy = 60e6;
  spec.wear_weight = 2e4;
  return spec;
}

void expect_slopes(const BitTorqueSpec& spec, double force, double speed, const FormationLayer& rock)
{
  const TorqueLimit limit = bit_torque_limit(spec, 0.3112, force, speed, rock);
  const double f = central([&](double x) { return bit_torque_limit(spec, 0.3112, x, speed, rock).value; }, force, 1e-3 * force);
  const double n = central([&](double x) { return bit_torque_limit(spec, 0.3112, force, x, rock).value; }, std::abs(speed), 1e-3);
  EXPECT_NEAR(limit.force_slope, f, 1e-6 * std::abs(f));
  EXPECT_NEAR(limit.speed_slope, n, 1e-6 * std::abs(n) + 1e-9);
}

// Each row has the limit of its kind: of a face that rubs, or of a drag bit.
TEST(BitTorqueLimit, ListOfLaws)
{
  const FormationLayer rock = rock_with(1.0);
  for (int law = 0; law < static_cast<int>(std::size(bit_laws)); ++law)
  {
    BitTorqueSpec spec = drag_bit();
    spec.model = static_cast<BitTorqueModel>(law);
    const bool drag = traits_of(spec.model).drag;
    EXPECT_FALSE(traits_of(spec.model).by_cut && !drag) << bit_laws[law].word;
    const TorqueLimit limit = bit_torque_limit(spec, 0.3112, 74e3, 4.0, rock);
    const TorqueLimit expected =
        drag ? detournay_bit_torque(spec, 0.3112, 74e3, 4.0, rock) : stribeck_bit_torque(spec, 0.3112, 74e3, 4.0);
    EXPECT_EQ(limit.value, expected.value) << bit_laws[law].word;
    EXPECT_EQ(limit.force_slope, expected.force_slope) << bit_laws[law].word;
  }
  EXPECT_STREQ(traits_of(BitTorqueModel::regenerative).word, "regenerative");
}

TEST(BitTorqueLimit, StribeckFallsWithSpeed)
{
  const BitTorqueSpec spec;
  const FormationLayer rock;
  EXPECT_NEAR(stribeck_bit_torque(spec, 0.3112, 74e3, 0.0).value, 0.6 * 74e3 * 0.3112 / 3.0, 1e-9);
  EXPECT_NEAR(stribeck_bit_torque(spec, 0.3112, 74e3, 1e3).value, 0.4 * 74e3 * 0.3112 / 3.0, 1e-9);
  EXPECT_EQ(stribeck_bit_torque(spec, 0.3112, 74e3, 4.0).value, stribeck_bit_torque(spec, 0.3112, 74e3, -4.0).value);
  EXPECT_EQ(stribeck_bit_torque(spec, 0.3112, 0.0, 4.0).value, 0.0);
  expect_slopes(spec, 74e3, 4.0, rock);
  expect_slopes(spec, 74e3, -4.0, rock);
}

TEST(BitTorqueLimit, DetournayCutsAndRubs)
{
  // d = 2 pi v/N = 2 pi K F = 3.9986 mm for beta = 1, whatever the speed; cutting 60e6 0.1556^2 d/2, rubbing 0.3 0.1556 20 kN
  const double d = 2.0 * pi * 8.6e-9 * 74e3;
  const double expected = 60e6 * 0.1556 * 0.1556 * d / 2.0 + 0.6 * 0.1556 / 2.0 * 20e3;
  EXPECT_NEAR(detournay_bit_torque(drag_bit(), 0.3112, 74e3, 14.0, rock_with(1.0)).value, expected, 1e-9);
  EXPECT_NEAR(detournay_bit_torque(drag_bit(), 0.3112, 74e3, 0.0, rock_with(1.0)).value, expected, 1e-9);
  EXPECT_NEAR(expected, 3838.0, 1.0);

  // beta = 1/2: d = 2 pi v/N by the rock law at 9 rad/s
  const double v = 8.6e-9 * 74e3 * std::sqrt(9.0);
  const double slower = 60e6 * 0.1556 * 0.1556 * (2.0 * pi * v / 9.0) / 2.0 + 0.6 * 0.1556 / 2.0 * 20e3;
  EXPECT_NEAR(detournay_bit_torque(drag_bit(), 0.3112, 74e3, 9.0, rock_with(0.5)).value, slower, 1e-9);

  expect_slopes(drag_bit(), 74e3, 14.0, rock_with(1.0));
  expect_slopes(drag_bit(), 74e3, 14.0, rock_with(0.7));
  expect_slopes(drag_bit(), 74e3, -14.0, rock_with(0.7));
  expect_slopes(drag_bit(), 10e3, 14.0, rock_with(0.7));
}

// quick.yaml's rock: 10 kN cut 1.3e-7 2 pi 10 kN = 8.168 mm a turn. That is W = zeta epsilon a d with epsilon = 18.9 MPa, and
// T = epsilon a^2 d/2 = a W/(2 zeta).
TEST(BitTorqueLimit, DetournayWithoutAnEnergyTakesTheRocksOwn)
{
  BitTorqueSpec spec;
  spec.model = BitTorqueModel::detournay;
  FormationLayer rock;
  rock.drillability = 1.3e-7;
  const double diameter = 0.2159, a = 0.5 * diameter;
  EXPECT_NEAR(implied_inclination(diameter, 1.3e-7, 18.9e6), 0.6, 1e-3);
  const double own = 1.0 / (2.0 * pi * a * 0.6 * 1.3e-7);
  EXPECT_NEAR(own, 18.9e6, 0.02e6);
  EXPECT_NEAR(detournay_bit_torque(spec, diameter, 10e3, 9.0, rock).value, 0.5 * own * a * a * 2.0 * pi * 1.3e-7 * 10e3, 1e-6);
  EXPECT_NEAR(detournay_bit_torque(spec, diameter, 10e3, 9.0, rock).value, 899.6, 0.1);
  expect_slopes(spec, 10e3, 9.0, rock);

  // the threshold's weight does not cut; where the flats carry it, it rubs
  rock.threshold = spec.wear_weight = 4e3;
  EXPECT_NEAR(detournay_bit_torque(spec, diameter, 10e3, 9.0, rock).value, a * (6e3 / 1.2 + 0.5 * 0.6 * 4e3), 1e-9);
  expect_slopes(spec, 10e3, 9.0, rock);
  expect_slopes(spec, 3e3, 9.0, rock);
}

TEST(BitTorqueLimit, DetournayIsFiniteAtRest)
{
  const TorqueLimit at_rest = detournay_bit_torque(drag_bit(), 0.3112, 74e3, 0.0, rock_with(0.0));
  EXPECT_LT(detournay_bit_torque(drag_bit(), 0.3112, 74e3, 1.05, rock_with(0.0)).value, at_rest.value)
      << "it falls from 1 rad/s on";
  EXPECT_TRUE(std::isfinite(at_rest.value));
  EXPECT_EQ(at_rest.value, detournay_bit_torque(drag_bit(), 0.3112, 74e3, 1.0, rock_with(0.0)).value);
  EXPECT_EQ(detournay_bit_torque(drag_bit(), 0.3112, -5.0, 1.0, rock_with(1.0)).value, 0.0);
}

TEST(BitTorque, SticksElasticallyAndHoldsForever)
{
  const TorqueLimit limit{5000.0, 0.06, -10.0};
  BitTorque t = bit_torque(limit, 5e5, 0.0, 0.004, 0.0, 200.0);
  EXPECT_FALSE(t.slipping);
  EXPECT_DOUBLE_EQ(t.value, 2000.0);
  EXPECT_DOUBLE_EQ(t.spin_slope, 5e5);
  for (int i = 0; i < 100000; ++i)
  {
    t = bit_torque(limit, 5e5, t.twist, 0.0, 0.0, 200.0);
  }
  EXPECT_DOUBLE_EQ(t.value, 2000.0);
}

TEST(BitTorque, SlipsAtTheLimitInBothDirections)
{
  const TorqueLimit limit{5000.0, 0.06, -10.0};
  const BitTorque t = bit_torque(limit, 5e5, 0.008, 0.07, 14.0, 200.0);
  EXPECT_TRUE(t.slipping);
  EXPECT_EQ(t.value, 5000.0);
  EXPECT_DOUBLE_EQ(t.twist, 0.01);
  EXPECT_EQ(t.force_slope, 0.06);
  const BitTorque back = bit_torque(limit, 5e5, 0.008, -0.07, -14.0, 200.0);
  EXPECT_EQ(back.value, -5000.0);
  EXPECT_EQ(back.force_slope, -0.06);
  EXPECT_EQ(back.spin_slope, t.spin_slope);  // odd in the motion
}

TEST(BitTorque, TangentOfTheWholeLaw)
{
  // torque as a function of the housing's spin in the step, and of the weight
  const BitTorqueSpec spec;
  const FormationLayer rock;
  const double h = 0.005;
  const double motor = 9.0;
  const auto at = [&](double sigma, double force)
  {
    const double speed = sigma / h + motor;
    return bit_torque(bit_torque_limit(spec, 0.3112, force, speed, rock), 5e5, 0.002, sigma + h * motor, speed, 1.0 / h);
  };
  for (double sigma : {0.02, -0.0445, -0.09})
  {
    const BitTorque t = at(sigma, 74e3);
    const double s = central([&](double x) { return at(x, 74e3).value; }, sigma, 1e-6);
    const double f = central([&](double x) { return at(sigma, x).value; }, 74e3, 10.0);
    EXPECT_NEAR(t.spin_slope, s, 1e-6 * std::abs(s));
    EXPECT_NEAR(t.force_slope, f, 1e-6 * std::abs(f));
  }
  EXPECT_TRUE(at(0.02, 74e3).slipping);
  EXPECT_FALSE(at(-0.0445, 74e3).slipping);
}

TEST(BitTorque, NeverCreatesEnergy)
{
  const TorqueLimit limit{5000.0, 0.06, 0.0};
  double twist = 0.0;
  double taken_out = 0.0;
  for (int i = 0; i < 10000; ++i)
  {
    const double slip = 0.012 * std::sin(0.7 * i) + 0.005 * std::sin(0.31 * i);
    const BitTorque t = bit_torque(limit, 5e5, twist, slip, slip / 0.005, 200.0);
    taken_out += t.value * slip;
    twist = t.twist;
    ASSERT_GE(taken_out, 0.5 * 5e5 * twist * twist * (1.0 - 1e-12));
  }
}

TEST(BitTorque, BristleBreaksLooseAtAHundredthOfARadian)
{
  const BitTorqueSpec spec;
  const double k = bit_bristle_stiffness(spec, 0.3112);
  EXPECT_NEAR(k * 0.01, stribeck_bit_torque(spec, 0.3112, 300e3 * 0.3112, 0.0).value, 1e-6);
}

}  // namespace
}  // namespace drill_rig_sim::test_contact_bit_torque
