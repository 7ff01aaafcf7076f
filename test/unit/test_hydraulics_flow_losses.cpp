// SPDX-License-Identifier: BSD-3-Clause
// Losses of muds with a rheology: published examples, exact limits, continuity from laminar to turbulent flow, eccentric pipe,
// nozzles, clinging.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "drill_rig_sim/hydraulics/flow_losses.h"
#include "drill_rig_sim/math/units.h"

namespace test_hydraulics_flow_losses
{
using namespace drill_rig_sim;

namespace
{
constexpr double psi = 6894.757, foot = 0.3048, inch = 0.0254, gpm = 6.30902e-5, ppg = 119.8264, pound_per_100_feet2 = 0.4788026;

const Passage drill_pipe = {4.276 * inch, 0.0, 0.0}, open_hole = {8.5 * inch, 5.0 * inch, 0.0};
const Rheology newtonian = {0.0, 0.02, 1.0}, bingham = {8.0, 0.02, 1.0}, thinning = {0.0, 0.6, 0.6}, yielding = {1.5, 0.14, 0.78};

/// API RP 13D (2006) in its own units, a bore's alpha 0 and an annulus's 1: stress of laminar flow [lbf/100 ft2], Reynolds
/// number, gradient [psi/ft].
struct Api
{
  double laminar, reynolds, gradient;

  Api(const Rheology& mud, double density, const Passage& passage, double speed)
  {
    const double alpha = passage.inner > 0.0 ? 1.0 : 0.0, n = mud.index, v = speed / foot * 60.0, d = passage.gap() / inch,
                 rho = density / ppg;
    const double g = ((3.0 - alpha) * n + 1.0) / ((4.0 - alpha) * n) * (1.0 + 0.5 * alpha);
    const double yield = mud.yield_stress / pound_per_100_feet2, k = mud.consistency / pound_per_100_feet2;
    laminar = std::pow((4.0 - alpha) / (3.0 - alpha), n) * yield + k * std::pow(1.6 * g * v / d, n);
    reynolds = rho * v * v / (19.36 * laminar);
    const double critical = 3470.0 - 1370.0 * n, f_laminar = 16.0 / reynolds,
                 f_transitional = 16.0 * reynolds / (critical * critical);
    const double f_turbulent = (std::log10(n) + 3.93) / 50.0 / std::pow(reynolds, (1.75 - std::log10(n)) / 7.0);
    const double f_intermediate = std::pow(std::pow(f_transitional, -8.0) + std::pow(f_turbulent, -8.0), -1.0 / 8.0);
    const double f = std::pow(std::pow(f_intermediate, 12.0) + std::pow(f_laminar, 12.0), 1.0 / 12.0);
    gradient = 1.076e-5 * rho * v * v * f / d;
  }
};

double speed_of(double flow, const Passage& passage)
{
  return flow / passage.area();
}
}  // namespace

// Hagen and Poiseuille: 32 mu V/d^2; a slot of H = (D_h - D)/2: 12 mu V/H^2.
TEST(FlowLosses, newtonianLaminarFlowIsHagenPoiseuilles)
{
  const Passage bore = {0.1, 0.0, 0.0}, annulus = {0.2, 0.1, 0.0};
  for (const double v : {1e-6, 1e-3, 0.01})
  {
    EXPECT_NEAR(pressure_gradient(newtonian, 1000.0, bore, v), 32.0 * 0.02 * v / 0.01, 1e-12 * v);
    EXPECT_NEAR(pressure_gradient(newtonian, 1000.0, annulus, v), 12.0 * 0.02 * v / 0.0025, 1e-11 * v);
  }
  EXPECT_EQ(pressure_gradient(newtonian, 1000.0, bore, 0.0), 0.0);
}

// The concentric annulus's own solution (Lamb, Hydrodynamics, art. 331): 32 mu V/(D_h^2 + D^2 - (D_h^2 - D^2)/ln(D_h/D)).
TEST(FlowLosses, slotIsNearTheNewtonianAnnulus)
{
  for (const auto& [ratio, error] : {std::pair{0.3, 0.023}, std::pair{0.5, 0.0075}, std::pair{0.7, 0.002}})
  {
    const double exact = 32.0 * 0.02 / (1.0 + ratio * ratio - (1.0 - ratio * ratio) / -std::log(ratio));
    EXPECT_NEAR(pressure_gradient(newtonian, 0.0, {1.0, ratio, 0.0}, 1.0) / exact, 1.0 + error, 0.002) << ratio;
  }
}

// Blasius: f = 0.0791/Re^0.25; API RP 13D's a and b of n = 1 are 0.0786 and 0.25.
TEST(FlowLosses, newtonianTurbulentFlowIsNearBlasius)
{
  const double v = 3.0, re = 1000.0 * v * 0.1 / 0.002,
               gradient = pressure_gradient({0.0, 0.002, 1.0}, 1000.0, {0.1, 0.0, 0.0}, v);
  EXPECT_NEAR(gradient, 2.0 * 0.0791 / std::pow(re, 0.25) * 1000.0 * v * v / 0.1, 0.01 * gradient);
}

// Brine of 1 cP, 600 gal/min in 4.276 in, Re 478,600. Prandtl and Karman's smooth pipe, 1/sqrt(f) = 4 log10(Re sqrt(f)) - 0.4,
// loses a tenth more than API RP 13D's fit.
TEST(FlowLosses, thinBrineLosesATenthLessThanPrandtls)
{
  const Passage pipe = {4.276 * inch, 0.0, 0.0};
  const double rho = 9.0 * ppg, v = speed_of(600.0 * gpm, pipe), re = rho * v * pipe.outer / 0.001;
  EXPECT_NEAR(re, 478600.0, 200.0);
  double f = 0.003;
  for (int k = 0; k < 20; ++k) f = 1.0 / std::pow(4.0 * std::log10(re * std::sqrt(f)) - 0.4, 2);
  EXPECT_NEAR(pressure_gradient({0.0, 0.001, 1.0}, rho, pipe, v), 0.9 * 2.0 * f * rho * v * v / pipe.outer, 10.0);
}

// tau_w = 4/3 tau_y + 8 mu V/d - tau_y^4/(3 tau_w^3) (Buckingham 1921, Reiner 1926).
TEST(FlowLosses, binghamLaminarFlowIsBuckinghamReiners)
{
  for (const double v : {0.001, 0.1, 0.5})
  {
    const double w = laminar_wall_stress(bingham, drill_pipe, v);
    EXPECT_NEAR(w, 4.0 / 3.0 * 8.0 + 8.0 * 0.02 * v / drill_pipe.gap() - std::pow(8.0, 4) / (3.0 * w * w * w), 1e-9);
  }
}

// Drilling Engineering (Heriot-Watt), exercise 2b: 4.276 in, 150 gpm, 10 lb/gal, 20 cP, 15 lb/100 ft2: 0.018 psi/ft by mu v/(1500
// d^2) + tau_y/(225 d), which leaves Buckingham and Reiner's last term out: 7.4 % here.
TEST(FlowLosses, binghamPipeOfHeriotWatt)
{
  const Rheology mud = {15.0 * pound_per_100_feet2, 0.020, 1.0};
  const double v = speed_of(150.0 * gpm, drill_pipe);
  EXPECT_NEAR(v / foot, 3.35, 0.01);
  const double w = laminar_wall_stress(mud, drill_pipe, v), last = std::pow(mud.yield_stress, 4) / (3.0 * w * w * w);
  EXPECT_NEAR(4.0 * (w + last) / drill_pipe.gap() * foot / psi, 0.018, 0.0002);
  EXPECT_NEAR(last / (w + last), 0.074, 0.002);
  EXPECT_NEAR(pressure_gradient(mud, 10.0 * ppg, drill_pipe, v), 4.0 * w / drill_pipe.gap(), 1.0);
}

// Bourgoyne's turbulent Bingham mud, rho^0.75 v^1.75 mu_p^0.25/(1800 d^1.25) psi/ft (Applied Drilling Engineering; Guo and Liu,
// eq. 2.60).
TEST(FlowLosses, binghamTurbulentFlowIsNearBourgoynes)
{
  for (const double flow : {500.0, 600.0, 800.0})
  {
    const double v = speed_of(flow * gpm, drill_pipe);
    const double published =
        std::pow(10.0, 0.75) * std::pow(v / foot, 1.75) * std::pow(20.0, 0.25) / (1800.0 * std::pow(4.276, 1.25)) * psi / foot;
    EXPECT_NEAR(pressure_gradient(bingham, 10.0 * ppg, drill_pipe, v), published, 0.02 * published) << flow;
  }
}

// Lapeyrouse, Formulas and Calculations, 2nd ed.: surge of plugged 4 1/2 in pipe in 7 7/8 in, 14,300 ft, 15 lb/gal, n 0.8069, K
// 0.522 lb s^n/100 ft2: 716 psi at his peak of 378 ft/min; 516 psi by the same formula at the mean of 252 ft/min.
TEST(FlowLosses, annulusOfLapeyrouse)
{
  const Rheology mud = {0.0, 0.522 * pound_per_100_feet2, 0.8069};
  const Passage annulus = {7.875 * inch, 4.5 * inch, 0.0};
  const auto laminar = [&](double feet_per_minute)
  { return 4.0 * laminar_wall_stress(mud, annulus, feet_per_minute * foot / 60.0) / annulus.gap() * 14300.0 * foot / psi; };
  EXPECT_NEAR(laminar(378.0), 716.0, 2.0);
  EXPECT_NEAR(laminar(252.0), 516.0, 2.0);
  EXPECT_NEAR(pressure_gradient(mud, 15.0 * ppg, annulus, 252.0 * foot / 60.0) * 14300.0 * foot / psi, 516.0, 2.0);
  EXPECT_NEAR(pressure_gradient(mud, 15.0 * ppg, annulus, 378.0 * foot / 60.0) * 14300.0 * foot / psi, 724.0, 2.0)
      << "near its transition";
}

// API RP 13D itself: a power law is the same in all regimes, to its rounded constants.
TEST(FlowLosses, powerLawIsApis)
{
  for (const Passage& passage : {drill_pipe, open_hole})
    for (const double v : {0.1, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0})
    {
      const Api api(thinning, 12.5 * ppg, passage, v);
      EXPECT_NEAR(reynolds_number(thinning, 12.5 * ppg, passage, v), api.reynolds, 0.003 * api.reynolds);
      EXPECT_NEAR(pressure_gradient(thinning, 12.5 * ppg, passage, v) * foot / psi, api.gradient, 0.005 * api.gradient) << v;
    }
}

// Its Herschel-Bulkley mud: laminar flow loses less by what its factor of the yield stress is too large, turbulent by what that
// counts there.
TEST(FlowLosses, herschelBulkleyIsNearApis)
{
  for (const Passage& passage : {drill_pipe, open_hole})
    for (const double v : {0.3, 0.6, 1.0, 3.0, 4.0, 6.0})
    {
      const double api = Api(yielding, 12.5 * ppg, passage, v).gradient,
                   here = pressure_gradient(yielding, 12.5 * ppg, passage, v) * foot / psi;
      EXPECT_GT(here, 0.94 * api) << v;
      EXPECT_LT(here, 1.02 * api) << v;
    }
}

// Between API's two ways for a mud of PV 15 cP, YP 12 Pa and a yield stress of 3 Pa: its whole law, and the power law through the
// 600 and 300 rpm readings (n 0.475), which is too thin at the shear rates of a bore.
TEST(FlowLosses, turbulentBoreIsBetweenApisTwoWays)
{
  const double at_300 = 12.0 + 0.015 * 511.0, at_600 = 12.0 + 0.015 * 1022.0;
  const double n = std::log2((at_600 - 3.0) / (at_300 - 3.0)), n_p = std::log2(at_600 / at_300);
  const Rheology mud = {3.0, (at_300 - 3.0) / std::pow(511.0, n), n}, power = {0.0, at_300 / std::pow(511.0, n_p), n_p};
  for (const auto& [v, to_whole, to_power] :
       {std::array{4.5, 0.939, 1.039}, std::array{6.0, 0.950, 1.052}, std::array{8.0, 0.957, 1.063}})
  {
    const Passage bore = {4.276 * inch, 0.0, 0.0};
    const double here = pressure_gradient(mud, 1500.0, bore, v) * foot / psi;
    EXPECT_NEAR(here / Api(mud, 1500.0, bore, v).gradient, to_whole, 0.003) << v;
    EXPECT_NEAR(here / Api(power, 1500.0, bore, v).gradient, to_power, 0.003) << v;
  }
}

TEST(FlowLosses, lawsMeetAtTheirLimits)
{
  for (const Passage& passage : {drill_pipe, open_hole})
    for (const double v : {0.05, 0.5, 1.5, 4.0})
    {
      const auto gradient = [&](const Rheology& mud) { return pressure_gradient(mud, 1200.0, passage, v); };
      EXPECT_NEAR(gradient({1e-7, 0.02, 1.0}), gradient(newtonian), 1e-4 * gradient(newtonian)) << "yield point to 0";
      EXPECT_NEAR(gradient({8.0, 0.02, 1.0 - 1e-9}), gradient(bingham), 1e-6 * gradient(bingham)) << "index to 1";
      EXPECT_NEAR(gradient({1e-7, 0.6, 0.6}), gradient(thinning), 1e-4 * gradient(thinning));
    }
  EXPECT_NEAR(pressure_gradient(bingham, 1200.0, drill_pipe, 1e-9), 4.0 * 8.0 / drill_pipe.gap(), 1.0)
      << "the yield stress at rest";
  EXPECT_EQ(pressure_gradient(bingham, 1200.0, drill_pipe, 0.0), 4.0 * 8.0 / drill_pipe.gap());
}

TEST(FlowLosses, growWithoutAJump)
{
  for (const Rheology& mud : {newtonian, bingham, thinning, yielding, Rheology{20.0, 0.03, 1.0}, Rheology{10.0, 1.5, 0.45}})
    for (Passage passage : {drill_pipe, open_hole, Passage{0.2159, 0.17, 0.0}, Passage{0.2159, 0.127, 0.8}})
    {
      double before = pressure_gradient(mud, 1300.0, passage, 1e-3);
      for (double v = 1e-3; v < 10.0; v *= 1.005)
      {
        const double now = pressure_gradient(mud, 1300.0, passage, 1.005 * v);
        ASSERT_GT(now, before) << v;
        // a transition is less steep than V^4
        ASSERT_LT(now, before * 1.02) << v;
        before = now;
      }
    }
}

TEST(FlowLosses, criticalSpeedIsThatOfTheCriticalNumber)
{
  const double v = critical_speed(yielding, 1400.0, open_hole);
  EXPECT_NEAR(reynolds_number(yielding, 1400.0, open_hole, v), critical_reynolds_number(yielding), 1e-3);
  EXPECT_EQ(critical_speed(yielding, 0.0, open_hole), HUGE_VAL);
}

// A narrow slot whose gap varies around: 1/(1 + 1.5 e^2) of the concentric one's laminar loss (Newtonian; Piercy, Hooper and
// Winny 1933).
TEST(FlowLosses, eccentricPipeLosesLess)
{
  for (const double e : {0.25, 0.5, 0.75})
    EXPECT_NEAR(eccentric_share(newtonian, {0.1, 0.09, e}).laminar, 1.0 / (1.0 + 1.5 * e * e), 0.03) << e;
  const EccentricShare half = eccentric_share(newtonian, {0.2159, 0.127, 0.5});
  EXPECT_GT(half.turbulent, half.laminar);
  EXPECT_LT(half.turbulent, 1.0);
  EXPECT_NEAR(pressure_gradient(newtonian, 0.0, {0.2159, 0.127, 0.5}, 1.0),
              half.laminar * pressure_gradient(newtonian, 0.0, {0.2159, 0.127, 0.0}, 1.0), 1e-9);
}

TEST(FlowLosses, rotationIsInProportionUpToTwiceItsTest)
{
  const double tested = 120.0 * rpm;
  EXPECT_EQ(rotation_factor(1.2, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(rotation_factor(1.2, -tested), 1.2);
  EXPECT_DOUBLE_EQ(rotation_factor(0.8, 0.5 * tested), 0.9);
  EXPECT_DOUBLE_EQ(rotation_factor(1.2, 3.0 * tested), 1.4);
  EXPECT_EQ(rotation_factor(1.0, tested), 1.0);
}

// 156.5 Q^2 W/(N1^2 + N2^2 + N3^2)^2 psi (Lapeyrouse): three of 12/32 in, 400 gpm, 10 lb/gal: 1342 psi.
TEST(FlowLosses, nozzlesOfLapeyrouse)
{
  const double diameter = 12.0 / 32.0 * inch, area = 3.0 * 0.25 * pi * diameter * diameter;
  EXPECT_NEAR(nozzle_loss(10.0 * ppg, 400.0 * gpm, area) / psi, 156.5 * 400.0 * 400.0 * 10.0 / (432.0 * 432.0), 4.0);
}

// A Newtonian mud between a wall at rest and a pipe that moves: K = (r^2 - 2 r^2 ln r - 1)/(2 (1 - r^2) ln r).
TEST(FlowLosses, clingingIsNearTheNewtonianOne)
{
  for (const double r : {0.4, 0.571, 0.8})
  {
    const double exact = (r * r - 2.0 * r * r * std::log(r) - 1.0) / (2.0 * (1.0 - r * r) * std::log(r));
    EXPECT_NEAR(clinging(r, 0.0), exact, 0.02) << r;
    EXPECT_NEAR(clinging(r, 1.0), 0.41 + 0.1 * r, 1e-15);
  }
  EXPECT_EQ(turbulence_at(-1.5, 1.0), 0.5);
  EXPECT_EQ(turbulence_at(0.5, 1.0), 0.0);
}
}  // namespace test_hydraulics_flow_losses
