// SPDX-License-Identifier: BSD-3-Clause
// Stick-slip of a string of 3 km, by a stiff drive and by those that give way to the string's waves; and how fast these damp its
// modes.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <complex>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/state.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/simulator.h"
#include "in_source.h"
#include "symmetric_modes.h"
#include "test_scenes.h"

namespace test_sim_stick_slip
{
using namespace drill_rig_sim;

namespace
{
Simulator rig_of_3_km()
{
  return Simulator(read_scene(in_source("test/top_drive/stick_slip.yaml")));
}

/// Of the bit's speed [rpm] at a speed of the drive, the last 30 of 90 s.
ValueRange bit_speed(Simulator& rig, TopDriveMode mode, double speed = 90.0 * rpm)
{
  TopDriveSetpoint turn;
  turn.mode = mode;
  turn.speed = speed;
  rig.command(turn);
  rig.command(PumpSetpoint{0.03});
  ValueRange out{1e9, -1e9};
  for (int k = 0; k < 9000; ++k)
  {
    EXPECT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
    if (k >= 6000) out.add(rig.truth().bit_speed / rpm);
  }
  return out;
}
}  // namespace

TEST(StickSlip, aStiffDriveSticksAndSlips)
{
  Simulator rig = rig_of_3_km();
  const ValueRange speed = bit_speed(rig, TopDriveMode::speed);
  EXPECT_LT(speed.least, 1.0);
  EXPECT_NEAR(speed.largest, 193.0, 10.0);
}

TEST(StickSlip, aTunedSoftTorqueTurnsSteadily)
{
  Simulator rig = rig_of_3_km();
  const ValueRange speed = bit_speed(rig, TopDriveMode::soft_torque);
  EXPECT_GT(speed.least, 80.0);
  EXPECT_LT(speed.largest, 100.0);
}

TEST(StickSlip, aTunedZTorqueTurnsSteadily)
{
  Simulator rig = rig_of_3_km();
  const ValueRange speed = bit_speed(rig, TopDriveMode::z_torque);
  EXPECT_GT(speed.least, 80.0);
  EXPECT_LT(speed.largest, 100.0);
}

// Where no SOFT_TORQUE helps any more.
TEST(StickSlip, aTunedZTorqueTurnsSteadilyAt50Rpm)
{
  Simulator soft = rig_of_3_km(), rig = rig_of_3_km();
  EXPECT_LT(bit_speed(soft, TopDriveMode::soft_torque, 50.0 * rpm).least, 1.0);
  const ValueRange speed = bit_speed(rig, TopDriveMode::z_torque, 50.0 * rpm);
  EXPECT_GT(speed.least, 45.0);
  EXPECT_LT(speed.largest, 55.0);
}

// Out of stick-slip, which has begun: what makes it worth switching over.
TEST(StickSlip, softTorqueEndsItOnceItRuns)
{
  Simulator rig = rig_of_3_km();
  EXPECT_LT(bit_speed(rig, TopDriveMode::speed).least, 1.0);
  const ValueRange speed = bit_speed(rig, TopDriveMode::soft_torque);
  EXPECT_GT(speed.least, 60.0);
}

namespace
{
using Complex = std::complex<double>;

/// 3 km of plain pipe that nothing rubs, and its drive an impedance.
struct PlainPipe
{
  static constexpr double length = 3000.0, sample = 0.05;  // [m], [s]
  double zeta = 0.0, wave = 0.0;                           // [N m s/rad], [m/s]
  TopDriveSpec drive;

  explicit PlainPipe(const DriveImpedance& impedance)
  {
    const double moment = pi / 32.0 * (std::pow(pipe_outer, 4) - std::pow(pipe_inner, 4)), shear_modulus = 206e9 / 2.6;
    zeta = moment * std::sqrt(shear_modulus * steel_density);
    wave = std::sqrt(shear_modulus / steel_density);
    drive.z_torque = impedance;
    drive.gearbox_friction = 0.0;
    drive.max_acceleration = 1.0;
  }

  Scene scene() const
  {
    Scene scene = without_damping(vertical_scene(length, length - 20.0));
    scene.string = {bit_part(0.2, 0.01), pipe_part(0, 9.5, plain_pipe_mass, 0.0)};
    scene.numerics.level = Level::axial_torsional;
    scene.numerics.step = 0.005;
    scene.rig.top_drive = drive;
    return scene;
  }

  /// What drive and string carry at the same speed at the top, together: zero at a mode. A string that is free at the bit: zeta
  /// tanh(s L/c).
  Complex balance(Complex s) const
  {
    const DriveImpedance& set = drive.z_torque;
    const Complex rotor = set.damping + s * drive.inertia * (1.0 - set.inertia_compensation) + set.stiffness / s;
    return 1.0 / (1.0 / rotor + s / drive.meter_stiffness) + zeta * std::tanh(s * length / wave);
  }

  /// By Newton's method from the mode of a string that is held at the top.
  Complex mode(int n) const
  {
    Complex s(-0.3, (2.0 * n - 1.0) * pi * wave / (2.0 * length));
    for (int i = 0; i < 50; ++i)
    {
      const double h = 1e-6;
      s -= balance(s) * 2.0 * h / (balance(s + h) - balance(s - h));
    }
    EXPECT_LT(std::abs(balance(s)), 1e-6 * zeta);
    return s;
  }
};

/// Exponents of a signal that is a sum of exponentials, by the shift of its Hankel matrix (matrix pencil) [1/s].
std::vector<Complex> exponents(const std::vector<double>& signal, int count, double sample)
{
  const int rows = static_cast<int>(signal.size()) / 2, columns = static_cast<int>(signal.size()) - rows;
  Eigen::MatrixXd hankel(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k) hankel(i, k) = signal[i + k];
  const Eigen::MatrixXd basis = modes_of(hankel * hankel.transpose()).vectors.rightCols(count);  // the left singular vectors
  const Eigen::MatrixXd shift = basis.topRows(rows - 1).colPivHouseholderQr().solve(basis.bottomRows(rows - 1));
  const Eigen::VectorXcd factors = shift.eigenvalues();
  std::vector<Complex> out;
  for (int i = 0; i < count; ++i) out.push_back(std::log(factors[i]) / sample);
  return out;
}

/// Of the drive's speed after it has run up to 3 rad/s, in Z_TORQUE; as many as needed for the quicker modes not to spoil the
/// slowest two.
std::vector<Complex> exponents_of(const PlainPipe& pipe)
{
  Simulator rig(pipe.scene());
  TopDriveSetpoint turn;
  turn.mode = TopDriveMode::z_torque;
  turn.speed = 3.0;
  rig.command(turn);
  std::vector<double> speed;
  for (int k = 0; k < 1900; ++k)
  {
    EXPECT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
    if (k >= 400 && k % 5 == 0) speed.push_back(rig.truth().top_drive_speed - turn.speed);
  }
  return exponents(speed, 24, PlainPipe::sample);
}
}  // namespace

// The two slowest modes decay as fast as those of a wave equation under the same impedance.
TEST(ZTorque, dampsTwoModes)
{
  for (const DriveImpedance& set : {DriveImpedance{900.0, 60.0, 0.98}, DriveImpedance{600.0, 150.0, 0.98}})
  {
    const PlainPipe pipe(set);
    const std::vector<Complex> found = exponents_of(pipe);
    for (const int n : {1, 2})
    {
      const Complex mode = pipe.mode(n);
      const Complex nearest = *std::min_element(found.begin(), found.end(),
                                                [&](Complex a, Complex b) { return std::abs(a - mode) < std::abs(b - mode); });
      EXPECT_LT(mode.real(), -0.2) << n;
      EXPECT_NEAR(nearest.real(), mode.real(), 0.03 * std::abs(mode.real())) << n;
      EXPECT_NEAR(nearest.imag(), mode.imag(), 0.01 * mode.imag()) << n;
    }
  }
}
}  // namespace test_sim_stick_slip
