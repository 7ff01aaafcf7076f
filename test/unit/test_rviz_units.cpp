// SPDX-License-Identifier: BSD-3-Clause
// Units of the driller's console against figures from tables, and there and back.
#include <gtest/gtest.h>

#include <cmath>

#include "rviz/console/quantities.h"
#include "rviz/console/units.h"

namespace test_rviz_units
{
using namespace drill_rig_sim::console;

namespace
{
void expect_oilfield(double shown, double si, Dimension dimension, const std::string& name)
{
  EXPECT_NEAR(shown, to_shown(si, dimension, UnitSystem::oilfield), 1e-4 * shown) << name;
  EXPECT_EQ(name, unit_of(dimension, UnitSystem::oilfield).name);
}
}  // namespace

// 1 lbf = 4.44822 N, 1 ft = 0.3048 m, 1 psi = 6894.76 Pa, 1 US gal = 3.785412 L, 1 ppg = 119.826 kg/m3
TEST(ConsoleUnits, OilfieldAsInTables)
{
  expect_oilfield(224.809, 1e6, Dimension::force, "klbf");
  expect_oilfield(7.37562, 1e4, Dimension::torque, "kft.lbf");
  expect_oilfield(90.0, 3.0 * M_PI, Dimension::rotation, "rpm");
  expect_oilfield(118.110, 36.0 / 3600.0, Dimension::penetration, "ft/h");
  expect_oilfield(1450.377, 1e7, Dimension::pressure, "psi");
  expect_oilfield(14.50377, 1e8, Dimension::specific_energy, "ksi");
  expect_oilfield(475.510, 0.03, Dimension::flow, "gpm");
  expect_oilfield(3280.84, 1000.0, Dimension::length, "ft");
  expect_oilfield(8.5, 0.2159, Dimension::diameter, "in");
  expect_oilfield(1.55000, 1e-3, Dimension::area, "in2");
  expect_oilfield(196.850, 1.0, Dimension::speed, "ft/min");
  expect_oilfield(10.0, 1198.264, Dimension::density, "ppg");
  expect_oilfield(68.5218, 1e6, Dimension::force_per_length, "klbf/ft");
  expect_oilfield(180.0, M_PI, Dimension::angle, "deg");
  expect_oilfield(212.0, 100.0, Dimension::temperature, "degF");
  expect_oilfield(32.0, 0.0, Dimension::temperature, "degF");
}

TEST(ConsoleUnits, MetricAsOnARig)
{
  EXPECT_DOUBLE_EQ(1000.0, to_shown(1e6, Dimension::force, UnitSystem::si));
  EXPECT_DOUBLE_EQ(1800.0, to_shown(0.03, Dimension::flow, UnitSystem::si));
  EXPECT_DOUBLE_EQ(36.0, to_shown(0.01, Dimension::penetration, UnitSystem::si));
  EXPECT_STREQ("MPa", unit_of(Dimension::pressure, UnitSystem::si).name);
}

TEST(ConsoleUnits, ThereAndBack)
{
  for (int n = 0; n < static_cast<int>(Dimension::count); ++n)
    for (const UnitSystem system : {UnitSystem::si, UnitSystem::oilfield})
    {
      const auto dimension = static_cast<Dimension>(n);
      EXPECT_NEAR(1.2345, to_si(to_shown(1.2345, dimension, system), dimension, system), 1e-12) << n;
    }
}

TEST(ConsoleUnits, Texts)
{
  EXPECT_EQ("262.3", number_text(262345.0, Dimension::force, UnitSystem::si));
  EXPECT_EQ("0.0", number_text(-20.0, Dimension::force, UnitSystem::si)) << "no -0.0";
  EXPECT_EQ("-", number_text(missing, Dimension::force, UnitSystem::si));
  EXPECT_EQ("-", number_text(std::numeric_limits<double>::infinity(), Dimension::force, UnitSystem::si));
}

TEST(ConsoleUnits, ErrorsBehindANumber)
{
  EXPECT_EQ("±2.3", error_text(2345.0, Dimension::force, UnitSystem::si));
  EXPECT_EQ("±0.5", error_text(2345.0, Dimension::force, UnitSystem::oilfield));
  EXPECT_EQ("±0.1", error_text(20.0, Dimension::force, UnitSystem::si)) << "no error is 0 that is not shown";
  EXPECT_EQ("±1", error_text(0.0, Dimension::pressure, UnitSystem::oilfield));
  EXPECT_EQ("", error_text(missing, Dimension::force, UnitSystem::si));
}

TEST(ConsoleQuantities, TheTableIsInOrder)
{
  for (std::size_t n = 0; n < quantity_count; ++n)
  {
    EXPECT_EQ(n, index_of(quantities()[n].quantity));
    EXPECT_EQ(quantities()[n].quantity, quantity_of(quantities()[n].key));
    EXPECT_GT(quantities()[n].usual, 0.0);
  }
  EXPECT_EQ(Quantity::count, quantity_of("hook"));
}

// Teale 1965 by hand: 100 kN, 5 kN m, 120 rpm, 10 m/h, 8.5 in: A = 0.036610 m2, F/A = 2.7315 MPa, T w/(A v) = 62832 W / (0.036610
// m2 * 2.7778e-3 m/s) = 617.85 MPa
TEST(ConsoleQuantities, SpecificEnergyByHand)
{
  EXPECT_NEAR(620.58e6, specific_energy(100e3, 5e3, 4.0 * M_PI, 10.0 / 3600.0, 0.2159), 0.05e6);
  EXPECT_TRUE(std::isnan(specific_energy(100e3, 5e3, 12.0, 0.0, 0.2159))) << "nothing is drilled";
  EXPECT_TRUE(std::isnan(specific_energy(100e3, 5e3, 12.0, 0.01, 0.0))) << "no bit's diameter";
}
}  // namespace test_rviz_units
