// SPDX-License-Identifier: BSD-3-Clause
// What SOFT_TORQUE and Z_TORQUE are tuned to: the pipe's impedance and the string's slowest torsion, against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/drive_tuning.h"
#include "symmetric_modes.h"
#include "test_scenes.h"

namespace test_rig_drive_tuning
{
using namespace drill_rig_sim;

namespace
{
constexpr double length = 3000.0;  // [m]

Mesh mesh_of(std::vector<PartSpec> parts, double depth = length)
{
  return build_mesh(parts, ContactSpec(), MudSpec(), uniform_elements(9.5), depth);
}

/// Pipe without tool joints under a bit that weighs next to nothing.
Mesh plain_mesh(double depth = length)
{
  return mesh_of({bit_part(0.2, 0.01), pipe_part(0, 9.5, plain_pipe_mass, 0.0)}, depth);
}

double polar_moment()
{
  return pi / 32.0 * (std::pow(pipe_outer, 4) - std::pow(pipe_inner, 4));
}
constexpr double shear_modulus = 206e9 / 2.6;
}  // namespace

TEST(DriveTuning, impedanceOfPlainPipe)
{
  const double zeta = polar_moment() * std::sqrt(shear_modulus * steel_density);
  EXPECT_NEAR(zeta, 296.0, 1.0);
  EXPECT_NEAR(torsional_impedance(plain_mesh()), zeta, 1e-3 * zeta);
}

// Held at the top, free at the bit: a quarter of a wave.
TEST(DriveTuning, slowestTorsionOfPlainPipe)
{
  const double wave = std::sqrt(shear_modulus / steel_density);
  EXPECT_NEAR(slowest_torsion(plain_mesh()), 0.5 * pi * wave / length, 1e-3 * 0.5 * pi * wave / length);
}

TEST(DriveTuning, slowestTorsionIsTheLeastEigenvalues)
{
  const Mesh mesh = mesh_of({bit_part(0.2159), collar_part(16, 9.4), pipe_part(0, 9.5, tool_jointed_mass)});
  const int n = static_cast<int>(mesh.elements.size());  // the top node is held
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd root(n);
  for (int i = 0; i < n; ++i)
  {
    root[i] = std::sqrt(mesh.nodes[i].spin_inertia);
    const double above = mesh.elements[i].section.torsion;
    stiffness(i, i) += above;
    if (i + 1 == n) continue;
    stiffness(i + 1, i + 1) += above;
    stiffness(i, i + 1) = stiffness(i + 1, i) = -above;
  }
  const SymmetricModes modes = modes_of(root.cwiseInverse().asDiagonal() * stiffness * root.cwiseInverse().asDiagonal());
  const double slowest = std::sqrt(modes.values[0]);
  EXPECT_NEAR(slowest_torsion(mesh), slowest, 2e-6 * slowest);
}

TEST(DriveTuning, whatTheSceneGivesStays)
{
  const Mesh mesh = plain_mesh();
  const double zeta = torsional_impedance(mesh), w = slowest_torsion(mesh);
  TopDriveSpec drive;
  drive.soft_torque.inertia_compensation = 0.2;
  const TopDriveSpec all = tuned(drive, mesh);
  EXPECT_DOUBLE_EQ(all.soft_torque.damping, 2.0 * zeta);
  EXPECT_DOUBLE_EQ(all.soft_torque.stiffness, 0.8 * drive.inertia * w * w);
  EXPECT_DOUBLE_EQ(all.z_torque.damping, zeta);
  EXPECT_DOUBLE_EQ(all.z_torque.stiffness, zeta * 0.125 * w);
  drive.soft_torque = {801.0, 3950.0, 0.0};
  drive.z_torque = {0.0, 55.0, 0.9};
  const TopDriveSpec some = tuned(drive, mesh);
  EXPECT_EQ(some.soft_torque.damping, 801.0);
  EXPECT_EQ(some.soft_torque.stiffness, 3950.0);
  EXPECT_EQ(some.z_torque.stiffness, 55.0);
  EXPECT_EQ(some.z_torque.inertia_compensation, 0.9);
  EXPECT_DOUBLE_EQ(some.z_torque.damping, zeta);
}

TEST(DriveTuning, aShortStringIsTunedForAsIfItHadOneHertz)
{
  const Mesh mesh = plain_mesh(200.0);
  ASSERT_GT(slowest_torsion(mesh), 2.0 * 2.0 * pi);
  const TopDriveSpec drive, both = tuned(drive, mesh);
  EXPECT_DOUBLE_EQ(both.soft_torque.stiffness, (1.0 - drive.soft_torque.inertia_compensation) * drive.inertia * 4.0 * pi * pi);
  EXPECT_DOUBLE_EQ(both.z_torque.stiffness, torsional_impedance(mesh) * 0.25 * pi);
}
}  // namespace test_rig_drive_tuning
