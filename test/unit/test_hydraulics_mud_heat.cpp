// SPDX-License-Identifier: BSD-3-Clause
// Heat of mud and rock: Holmes and Swift's closed form, the exact flux into rock, no heat lost, rest, any step and flow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "drill_rig_sim/hydraulics/mud_heat.h"
#include "drill_rig_sim/math/units.h"

namespace test_hydraulics_mud_heat
{
using namespace drill_rig_sim;

namespace
{
/// Cells of one length with pipe in a hole.
struct Column
{
  HeatMud mud;
  std::vector<HeatCell> cells;
  HeatState state;

  Column(const MudTemperatureSpec& spec, double density, double depth, std::size_t count, double hole, double pipe)
  {
    mud = {spec, rock_grid(spec), density};
    for (std::size_t i = 0; i < count; ++i)
    {
      HeatCell cell;
      cell.length = depth / static_cast<double>(count);
      cell.hole_radius = 0.5 * hole;
      cell.ground = ground_temperature(spec, (static_cast<double>(i) + 0.5) * cell.length);
      cell.bore_volume = 0.5 * pi * pipe * pipe / 4.0 * cell.length;
      cell.annulus_volume = 0.25 * pi * (hole * hole - pipe * pipe) * cell.length;
      cell.steel = 30.0 * cell.length;
      cell.pipe_surface = pi * pipe * cell.length;
      cells.push_back(cell);
      for (auto* along : {&state.bore, &state.annulus, &state.bore_mean, &state.annulus_mean}) along->push_back(cell.ground);
      for (std::size_t k = 0; k < rock_rings; ++k) state.rock.push_back(cell.ground);
    }
  }
  void advance(double flow, double step, double bit_power = 0.0)
  {
    advance_heat(mud, cells.data(), cells.size(), cells.size(), {flow, bit_power, step}, state);
  }
  double stored() const { return stored_heat(mud, cells.data(), cells.size(), state); }
  double from_ground() const { return heat_from_ground(mud, cells.data(), cells.size(), state); }
};

/// Holmes and Swift, J. Pet. Tech. 22 (1970) 670-674: bore G x + T_s - G A + K_1 e^(C_1 x) + K_2 e^(C_2 x), of pipe of radius r_p
/// with the coefficient h_p in a hole of radius r with U towards rock of the temperature T_s + G x.
struct HolmesAndSwift
{
  double surface, gradient, depth, a, c[2], k[2];

  HolmesAndSwift(const MudTemperatureSpec& spec, double carried, double pipe, double hole, double length)
      : surface(spec.surface), gradient(spec.gradient), depth(length)
  {
    a = carried / (pi * pipe * spec.pipe_coefficient);
    const double b = hole * spec.wall_coefficient / (pipe * spec.pipe_coefficient), root = std::sqrt(1.0 + 4.0 / b);
    c[0] = 0.5 * b / a * (1.0 + root);
    c[1] = 0.5 * b / a * (1.0 - root);
    // bore(0) = inlet, annulus(depth) = bore(depth), annulus = bore + a d bore/dx
    const double sum = spec.inlet - surface + gradient * a;
    const double e[2] = {c[0] * std::exp(c[0] * depth), c[1] * std::exp(c[1] * depth)};
    k[0] = (-gradient - sum * e[1]) / (e[0] - e[1]);
    k[1] = sum - k[0];
  }
  double bore(double x) const { return gradient * (x - a) + surface + k[0] * std::exp(c[0] * x) + k[1] * std::exp(c[1] * x); }
  double annulus(double x) const
  {
    return gradient * x + surface + k[0] * (1.0 + a * c[0]) * std::exp(c[0] * x) + k[1] * (1.0 + a * c[1]) * std::exp(c[1] * x);
  }
};

constexpr double foot = 0.3048, inch = 0.0254, fahrenheit = 5.0 / 9.0, btu = 1055.056, pound = 0.45359237;

double celsius(double degrees)
{
  return (degrees - 32.0) * fahrenheit;
}

/// The data of their example; rock that conducts so well that its wall keeps the ground's temperature.
MudTemperatureSpec example()
{
  MudTemperatureSpec spec;
  spec.inlet = celsius(75.0);
  spec.surface = celsius(59.5);
  spec.gradient = 0.0127 * fahrenheit / foot;
  spec.heat_capacity = 0.4 * btu / (pound * fahrenheit);
  spec.pipe_coefficient = 30.0 * btu / (3600.0 * foot * foot * fahrenheit);
  spec.wall_coefficient = 1.0 * btu / (3600.0 * foot * foot * fahrenheit);
  spec.rock_conductivity = 1e6;
  return spec;
}

constexpr double example_depth = 15000.0 * foot, example_pipe = 6.625 * inch, example_hole = 8.375 * inch;
constexpr double example_flow = 210.0 * 0.158987295 / 3600.0, example_density = 10.0 * 119.8264;

/// Largest difference from their solution at the cells' outlets [K].
double error_of(std::size_t cells)
{
  Column column(example(), example_density, example_depth, cells, example_hole, example_pipe);
  for (int k = 0; k < 300; ++k) column.advance(example_flow, 1e5);
  const HolmesAndSwift exact(example(), column.mud.capacity() * example_flow, example_pipe, example_hole, example_depth);
  double most = 0.0;
  for (std::size_t i = 0; i < cells; ++i)
  {
    const double top = static_cast<double>(i) * column.cells[i].length, foot_of = top + column.cells[i].length;
    most = std::max(most, std::abs(column.state.bore[i] - exact.bore(foot_of)));
    most = std::max(most, std::abs(column.state.annulus[i] - exact.annulus(top)));
  }
  return most;
}

/// Modified Bessel functions give the exact wall temperature in Laplace's space; Stehfest's inversion with ten terms.
double wall_of_constant_flux(double time)
{
  const double weights[] = {1.0 / 12.0, -385.0 / 12.0,   1279.0,           -46871.0 / 3.0, 505465.0 / 6.0,
                            -236957.5,  1127735.0 / 3.0, -1020215.0 / 3.0, 164062.5,       -32812.5};
  double sum = 0.0;
  for (int k = 1; k <= 10; ++k)
  {
    const double s = k * std::log(2.0) / time, root = std::sqrt(s);
    sum += weights[k - 1] * std::cyl_bessel_k(0.0, root) / (s * root * std::cyl_bessel_k(1.0, root));
  }
  return sum * std::log(2.0) / time;
}
}  // namespace

TEST(MudHeat, steadyCirculationIsHolmesAndSwifts)
{
  const HolmesAndSwift exact(example(), example_density * example().heat_capacity * example_flow, example_pipe, example_hole,
                             example_depth);
  EXPECT_NEAR(exact.bore(0.0), example().inlet, 1e-9);
  EXPECT_NEAR(exact.bore(example_depth), exact.annulus(example_depth), 1e-9);
  EXPECT_NEAR(exact.bore(example_depth), celsius(204.26), 0.01);
  EXPECT_NEAR(exact.annulus(0.0), celsius(79.04), 0.01);
  EXPECT_LT(error_of(200), 0.03);
}

TEST(MudHeat, errorFallsWithTheSquareOfTheCellsLength)
{
  const double coarse = error_of(50), middle = error_of(100), fine = error_of(200);
  EXPECT_NEAR(coarse / middle, 4.0, 0.2);
  EXPECT_NEAR(middle / fine, 4.0, 0.1);
}

TEST(MudHeat, wallOfRockFollowsTheExactFlux)
{
  // van Everdingen and Hurst, Trans. AIME 186 (1949), table I
  EXPECT_NEAR(wall_of_constant_flux(1.0), 0.802, 0.002);
  EXPECT_NEAR(wall_of_constant_flux(10.0), 1.651, 0.003);
  EXPECT_NEAR(wall_of_constant_flux(100.0), 2.723, 0.004);
  MudTemperatureSpec spec;
  spec.surface = spec.gradient = 0.0;
  spec.wall_coefficient = 1e9;
  spec.heat_capacity = 1e-6;  // mud that stores nothing
  constexpr double power = 100.0, radius = 0.1;
  Column column(spec, 1.0, 1.0, 1, 2.0 * radius, 0.0);
  column.cells[0].bore_volume = column.cells[0].steel = 0.0;
  column.cells[0].annulus_power = power;
  double time = 0.0;
  for (double next = 0.05; next < 1500.0; next *= 2.0)
  {
    const double until = next * radius * radius / spec.rock_diffusivity;
    for (const double step = (until - time) / 200.0; time + 0.5 * step < until; time += step) column.advance(0.0, step);
    const double wall = 2.0 * pi * spec.rock_conductivity / power * column.state.annulus[0];
    EXPECT_NEAR(wall / wall_of_constant_flux(next), 1.0, next < 0.4 ? 0.03 : 0.015) << "t_D " << next;
  }
}

TEST(MudHeat, isNeitherLostNorMade)
{
  MudTemperatureSpec spec;
  Column column(spec, 1200.0, 3000.0, 150, 0.2159, 0.127);
  for (HeatCell& cell : column.cells)
  {
    cell.bore_power = 900.0;
    cell.annulus_power = 150.0;
  }
  const double power = 150.0 * (900.0 + 150.0) + 2e5;
  double before = column.stored(), carried = 0.0;
  for (int k = 0; k < 2000; ++k)
  {
    const double flow = k < 1000 ? 0.03 : 0.01, step = k % 2 ? 1.0 : 7.0;
    column.advance(flow, step, 2e5);
    const double out = column.mud.capacity() * flow * (column.state.annulus[0] - spec.inlet);
    const double now = column.stored(), flowed = step * (power + column.from_ground() - out);
    carried += std::abs(step * out);
    EXPECT_NEAR(now - before, flowed, 1e-12 * now) << k;
    before = now;
  }
  EXPECT_GT(carried, 1e9);
}

TEST(MudHeat, comesToTheGroundsAtRest)
{
  MudTemperatureSpec spec;
  Column column(spec, 1200.0, 3000.0, 150, 0.2159, 0.127);
  for (int k = 0; k < 600; ++k) column.advance(0.03, 60.0);
  const double circulating = column.state.annulus.back(), ground = column.cells.back().ground;
  EXPECT_LT(circulating, ground - 20.0);
  for (int k = 0; k < 60; ++k) column.advance(0.0, 60.0);
  const double hour = column.state.annulus.back();
  EXPECT_GT(hour, circulating + 5.0);
  EXPECT_LT(hour, ground - 1.0) << "the rock around the hole is cold too";
  for (int k = 0; k < 1000; ++k) column.advance(0.0, 1e5);
  for (std::size_t i = 0; i < column.cells.size(); ++i)
  {
    EXPECT_NEAR(column.state.bore[i], column.cells[i].ground, 0.02);
    EXPECT_NEAR(column.state.annulus_mean[i], column.cells[i].ground, 0.02);
  }
}

TEST(MudHeat, staysBetweenWhatItIsMadeOfAtAnyFlowAndStep)
{
  MudTemperatureSpec spec;
  spec.inlet = 20.0;
  spec.surface = 20.0;
  const double warmest = ground_temperature(spec, 3000.0);
  for (const double flow : {0.0, 1e-9, 1e-6, 1e-4, 1e-3, 0.01, 1.0})
    for (const double step : {1e-3, 1.0, 1e3, 1e9})
      for (const double coefficient : {0.0, 1.0, 1e4})
      {
        spec.pipe_coefficient = spec.wall_coefficient = coefficient;
        Column column(spec, 1200.0, 3000.0, 40, 0.2159, 0.127);
        for (int k = 0; k < 20; ++k) column.advance(flow, step);
        for (const auto* along :
             {&column.state.bore, &column.state.annulus, &column.state.bore_mean, &column.state.annulus_mean, &column.state.rock})
          for (const double t : *along)
            EXPECT_TRUE(t >= 20.0 - 1e-9 && t <= warmest + 1e-9) << t << " at " << flow << ", " << step << ", " << coefficient;
      }
}

TEST(MudHeat, mudBelowTheBitRests)
{
  MudTemperatureSpec spec;
  Column column(spec, 1200.0, 3000.0, 100, 0.2159, 0.127);
  for (std::size_t i = 60; i < 100; ++i) column.cells[i].bore_volume = column.cells[i].steel = column.cells[i].pipe_surface = 0.0;
  for (int k = 0; k < 300; ++k) advance_heat(column.mud, column.cells.data(), 100, 60, {0.03, 0.0, 60.0}, column.state);
  EXPECT_LT(column.state.annulus[59], column.cells[59].ground - 5.0);
  for (std::size_t i = 60; i < 100; ++i) EXPECT_NEAR(column.state.annulus[i], column.cells[i].ground, 1e-9);
}

TEST(MudHeat, aStringThatIsRunInFindsTheMudOfTheHole)
{
  MudTemperatureSpec spec;
  Column column(spec, 1200.0, 3000.0, 100, 0.2159, 0.127);
  for (int k = 0; k < 60; ++k) column.advance(0.03, 60.0);  // the bit at the bottom
  for (std::size_t i = 60; i < 100; ++i) column.cells[i].bore_volume = column.cells[i].steel = column.cells[i].pipe_surface = 0.0;
  for (int k = 0; k < 600; ++k) advance_heat(column.mud, column.cells.data(), 100, 60, {0.0, 0.0, 60.0}, column.state);  // pulled
  EXPECT_GT(column.state.annulus[99], column.state.annulus[59]);
  for (std::size_t i = 60; i < 100; ++i)
  {
    EXPECT_EQ(column.state.annulus[i], column.state.bore[i]);
    EXPECT_EQ(column.state.annulus_mean[i], column.state.bore_mean[i]);
  }
}

TEST(MudHeat, aCellWithoutMudAndHeatKeepsItsTemperature)
{
  MudTemperatureSpec spec;
  spec.pipe_coefficient = spec.wall_coefficient = 0.0;
  Column column(spec, 1200.0, 300.0, 3, 0.2159, 0.127);
  column.cells[1].annulus_volume = 0.0;
  column.state.annulus[1] = 40.0;
  column.advance(0.0, 60.0);
  EXPECT_EQ(40.0, column.state.annulus[1]);
}
}  // namespace test_hydraulics_mud_heat
