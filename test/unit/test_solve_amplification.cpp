// SPDX-License-Identifier: BSD-3-Clause
// What a method makes of one oscillation in one step, against its exact amplification: a bit on the spring of its pipe, x'' =
// -w^2 x.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>

#include "drill_rig_sim/sim/integrator_table.h"
#include "drill_rig_sim/solve/stepper.h"
#include "lone_bit.h"

namespace test_solve_amplification
{
using namespace drill_rig_sim;
using Complex = std::complex<double>;

namespace
{
constexpr double frequency = 100.0;  // w [rad/s]
constexpr double amplitude = 5e-5;   // [m]; its static start is known to 1e-11
constexpr int steps = 12;

/// x - i v/w at the start and after each step of wh: exact motion turns it by wh.
struct Oscillation
{
  std::vector<Complex> u;

  Oscillation(IntegratorKind kind, double turn)
  {
    RigAtRest rig = lone_bit(lone_bit_scene(), [](MeshNode& bit, BeamSection& pipe)
                             { bit.mass = pipe.axial / pipe.length / (frequency * frequency); });
    const double rest = rig.state.nodes[0].position.z();
    rig.state.nodes[0].position.z() += amplitude;
    Method method = find_method(kind);
    method.refines = false;
    Stepper stepper(rig.model, method);
    stepper.limits().tolerance = 1e-15;
    stepper.limits().max_increment = 10.0;
    const auto note = [&]
    { u.emplace_back(rig.state.nodes[0].position.z() - rest, -rig.state.nodes[0].rate.velocity.z() / frequency); };
    note();
    for (int k = 0; k < steps; ++k)
    {
      EXPECT_TRUE(stepper.advance(rig.state, turn / frequency, Setpoints()));
      note();
    }
    EXPECT_EQ(stepper.counters().steps, static_cast<std::uint64_t>(steps)) << "no step is halved";
  }
  double x(int k) const { return u[k].real(); }
};

/// Of one-step methods: u_n+1 = R(i w h) u_n.
void expect_factor(IntegratorKind kind, double turn, Complex factor)
{
  const Oscillation o(kind, turn);
  for (int k = 0; k < steps; ++k)
    EXPECT_LT(std::abs(o.u[k + 1] - factor * o.u[k]), 1e-6 * std::abs(o.u[k]) + 1e-6 * amplitude)
        << find_integrator(kind).name << ", w h " << turn << ", step " << k;
}

constexpr double turns[] = {0.1, 1.0, 5.0, 100.0};
}  // namespace

TEST(Amplification, implicitEulerDividesByOneLessIwh)
{
  for (const IntegratorKind kind : {IntegratorKind::implicit_euler, IntegratorKind::linearly_implicit_euler})
    for (const double turn : turns) expect_factor(kind, turn, 1.0 / (1.0 - Complex(0.0, turn)));
}

// The trapezoidal rule over g h, then BDF2 from both; Hosea and Shampine, Appl. Numer. Math. 20 (1996), 21-37.
TEST(Amplification, trbdf2IsTheProductOfItsStages)
{
  const double g = 2.0 - std::sqrt(2.0);
  for (const double turn : turns)
  {
    const Complex z(0.0, turn);
    const Complex first = (1.0 + 0.5 * g * z) / (1.0 - 0.5 * g * z);
    const Complex second =
        (first / (g * (2.0 - g)) - (1.0 - g) * (1.0 - g) / (g * (2.0 - g))) / (1.0 - (1.0 - g) / (2.0 - g) * z);
    expect_factor(IntegratorKind::trbdf2, turn, second);
  }
}

// (3/2 - i w h) u_n+1 - 2 u_n + u_n-1 / 2 = 0, from its second step on.
TEST(Amplification, bdf2ObeysItsTwoStepFormula)
{
  for (const double turn : turns)
  {
    const Oscillation o(IntegratorKind::bdf2, turn);
    for (int k = 1; k < steps; ++k)
      EXPECT_LT(std::abs((1.5 - Complex(0.0, turn)) * o.u[k + 1] - 2.0 * o.u[k] + 0.5 * o.u[k - 1]),
                2e-6 * std::max(1.0, turn) * amplitude)
          << "w h " << turn << ", step " << k;
  }
  // the larger root (2 + sqrt(1 + 2 z))/(3 - 2 z) at z = i
  const Oscillation o(IntegratorKind::bdf2, 1.0);
  EXPECT_NEAR(std::abs(o.u[steps] / o.u[steps - 1]), std::abs((2.0 + std::sqrt(Complex(1.0, 2.0))) / Complex(3.0, -2.0)), 1e-4);
  EXPECT_NEAR(std::abs(o.u[steps] / o.u[steps - 1]), 0.9333, 1e-4) << "by hand";
}

// Chung and Hulbert's amplification matrix of (x, h v, h^2 a) with r = 1/2: am = 0, af = 1/3, g = 5/6, b = 4/9. Every motion
// obeys its characteristic polynomial; where w h is large all three roots are -r.
TEST(Amplification, generalisedAlphaTendsToItsSpectralRadius)
{
  constexpr double am = 0.0, af = 1.0 / 3.0, g = 5.0 / 6.0, b = 4.0 / 9.0;
  for (const double turn : {0.1, 1.0, 5.0, 100.0, 1e3})
  {
    const double square = turn * turn;
    Eigen::Matrix3d left, right;
    left << 1.0, 0.0, -b, 0.0, 1.0, -g, (1.0 - af) * square, 0.0, 1.0 - am;
    right << 1.0, 1.0, 0.5 - b, 0.0, 1.0, 1.0 - g, -af * square, 0.0, -am;
    const Eigen::Matrix3d a = left.inverse() * right;
    const double trace = a.trace(), minors = 0.5 * (trace * trace - (a * a).trace()), determinant = a.determinant();
    const Oscillation o(IntegratorKind::generalised_alpha, turn);
    for (int k = 0; k + 3 <= steps; ++k)
      EXPECT_NEAR(o.x(k + 3), trace * o.x(k + 2) - minors * o.x(k + 1) + determinant * o.x(k), 1e-6 * amplitude)
          << "w h " << turn << ", step " << k;
    if (turn < 1e3) continue;
    for (int k = 0; k + 3 <= steps; ++k)
      EXPECT_NEAR(o.x(k + 3) + 1.5 * o.x(k + 2) + 0.75 * o.x(k + 1) + 0.125 * o.x(k), 0.0, 1e-4 * amplitude)
          << "(l + 1/2)^3, step " << k;
    // a stiff oscillation is gone: at most k^2 r^k of it is left
    EXPECT_LT(std::abs(o.x(steps)), 144.0 * std::pow(0.5, 12) * amplitude);
  }
}

// x_n+1 - (2 - (w h)^2) x_n + x_n-1 = 0: no damping at all below w h = 2.
TEST(Amplification, centralDifferencesDoNotDamp)
{
  for (const double turn : {0.1, 1.0, 1.9})
  {
    const Oscillation o(IntegratorKind::central_differences, turn);
    EXPECT_NEAR(o.x(1), (1.0 - 0.5 * turn * turn) * o.x(0), 1e-6 * amplitude) << "the first rates are half a step behind, too";
    for (int k = 1; k < steps; ++k)
      EXPECT_NEAR(o.x(k + 1) - (2.0 - turn * turn) * o.x(k) + o.x(k - 1), 0.0, 1e-6 * amplitude)
          << "w h " << turn << ", step " << k;
  }
}
}  // namespace test_solve_amplification
