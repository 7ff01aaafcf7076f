// SPDX-License-Identifier: BSD-3-Clause
// Natural frequencies against closed forms: bars, shafts and beams clamped at the top, with the bit's mass, in tension, cut off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "drill_eigenmodes.h"
#include "test_scenes.h"

namespace test_tools_modes
{
using namespace drill_rig_sim;

namespace
{
constexpr double bit_radius = 0.05;

/// A bit on plain pipe in a wide vertical hole, pipe without weight in its mud.
Scene hanging(double depth, double bit_mass)
{
  Scene scene = vertical_scene(depth + 50.0, depth);
  PartSpec pipe = pipe_part(0, 9.5, plain_pipe_mass);
  pipe.pipe->tool_joint_diameter = 0.0;
  pipe.density = scene.mud.density;
  scene.string = {bit_part(2.0 * bit_radius, bit_mass), pipe};
  scene.string[0].length = 0.06;
  scene.mud.added_mass = 0.0;
  scene.start.block_height = 1.0;
  scene.numerics.element_length = depth / 60.0;
  return scene;
}

struct Hung
{
  RigAtRest rig;
  int top;
  double length;  // from bit to clamp [m]
  BeamSection section;

  explicit Hung(const Scene& scene)
      : rig(build_at_rest(scene)),
        top(rig.model->top()),
        length(rig.model->mesh().nodes.back().from_bit - bit_radius),
        section(rig.model->mesh().elements.back().section)
  {
  }
  double frequency(ModeFamily family, int mode) const
  {
    return find_modes(rig, family, top, mode + 1)[static_cast<std::size_t>(mode)].frequency();
  }
};

/// The n-th root of f above 0, from 0: counted by changes of sign.
double root(const std::function<double(double)>& f, int n, double step)
{
  double x = 1e-3 * step;
  for (int found = 0;; x += step)
    if (f(x) * f(x + step) <= 0.0 && ++found == n) break;
  double low = x, high = x + step;
  for (int k = 0; k < 200; ++k) (f(low) * f(0.5 * (low + high)) <= 0.0 ? high : low) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

/// Frequency of a bar, clamped above, with a tip of `tip` times its own mass: cos b = tip b sin b, w = b c/L.
double bar(double speed, double length, double tip, int n)
{
  return root([tip](double b) { return std::cos(b) - tip * b * std::sin(b); }, n, 0.01) * speed / (2.0 * pi * length);
}

/// Frequency of a beam, clamped above, in tension T, with a tip of mass M and inertia J: EI y'''' - T y'' = m w^2 y; at the tip
/// EI y'' = J w^2 y', EI y''' - T y' = -M w^2 y.
struct Beam
{
  double stiffness, mass, length, tension, tip, tip_inertia;

  double determinant(double w) const
  {
    const double a = 0.5 * tension / stiffness, b = std::sqrt(a * a + mass * w * w / stiffness);
    const double p = std::sqrt(a + b), q = std::sqrt(b - a), l = length;
    const double scale = std::exp(-p * l);  // cosh and sinh stay small
    const double ch = 0.5 * (1.0 + scale * scale), sh = 0.5 * (1.0 - scale * scale), c = scale * std::cos(q * l),
                 s = scale * std::sin(q * l);
    // y = ch - c and sh/p - s/q, and their derivatives
    const double y[2][4] = {{ch - c, p * sh + q * s, p * p * ch + q * q * c, p * p * p * sh - q * q * q * s},
                            {sh / p - s / q, ch - c, p * sh + q * s, p * p * ch + q * q * c}};
    double moment[2], shear[2];
    for (int k = 0; k < 2; ++k)
    {
      moment[k] = stiffness * y[k][2] - tip_inertia * w * w * y[k][1];
      shear[k] = stiffness * y[k][3] - tension * y[k][1] + tip * w * w * y[k][0];
    }
    return moment[0] * shear[1] - moment[1] * shear[0];
  }
  double frequency(int n) const
  {
    const double unit = std::sqrt(stiffness / mass) / (length * length);
    return root([this](double w) { return determinant(w); }, n, 0.02 * unit) / (2.0 * pi);
  }
};

void expect_beam(const Hung& hung, double tip, double tension)
{
  const Beam beam{hung.section.bending, plain_pipe_mass, hung.length, tension, tip, 0.4 * tip * bit_radius * bit_radius};
  const std::vector<Mode> modes = find_modes(hung.rig, ModeFamily::lateral, hung.top, 6);
  ASSERT_EQ(modes.size(), 6u);
  for (int n = 1; n <= 3; ++n)
    for (int of_pair : {0, 1})
      EXPECT_NEAR(modes[static_cast<std::size_t>(2 * n - 2 + of_pair)].frequency(), beam.frequency(n), 2e-3 * beam.frequency(n))
          << n;
}
}  // namespace

TEST(Modes, ofABarAreAQuarterWave)
{
  const Hung hung(hanging(300.0, 1e-3));
  const double speed = std::sqrt(hung.section.axial / plain_pipe_mass);
  for (int n = 0; n < 3; ++n)
    EXPECT_NEAR(hung.frequency(ModeFamily::axial, n), (2 * n + 1) * speed / (4.0 * hung.length),
                1e-3 * (2 * n + 1) * speed / (4.0 * hung.length));
}

TEST(Modes, ofABarWithTheBitsMass)
{
  const Hung hung(hanging(300.0, 3000.0));
  const double speed = std::sqrt(hung.section.axial / plain_pipe_mass);
  for (int n = 0; n < 3; ++n)
  {
    const double expected = bar(speed, hung.length, 3000.0 / (plain_pipe_mass * hung.length), n + 1);
    EXPECT_NEAR(hung.frequency(ModeFamily::axial, n), expected, 1e-3 * expected) << n;
  }
}

TEST(Modes, ofAShaftWithTheBitsInertia)
{
  for (const double mass : {1e-3, 3e4})
  {
    const Hung hung(hanging(300.0, mass));
    const double inertia = plain_pipe_mass * (std::pow(pipe_outer, 2) + std::pow(pipe_inner, 2)) / 8.0;  // [kg m]
    const double speed = std::sqrt(hung.section.torsion * hung.section.length / inertia);
    for (int n = 0; n < 3; ++n)
    {
      const double expected = bar(speed, hung.length, 0.4 * mass * bit_radius * bit_radius / (inertia * hung.length), n + 1);
      EXPECT_NEAR(hung.frequency(ModeFamily::torsional, n), expected, 1e-3 * expected) << n;
    }
  }
}

// Euler and Bernoulli: 3.5160, 22.034, 61.697 times sqrt(EI/m)/L^2.
TEST(Modes, ofABeam)
{
  Scene scene = hanging(20.0, 1e-3);
  const Hung hung(scene);
  const double unit = std::sqrt(hung.section.bending / plain_pipe_mass) / (2.0 * pi * hung.length * hung.length);
  const std::vector<Mode> modes = find_modes(hung.rig, ModeFamily::lateral, hung.top, 6);
  const double roots[] = {3.5160, 22.034, 61.697};
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(modes[static_cast<std::size_t>(k)].frequency(), roots[k / 2] * unit, 3e-3 * roots[k / 2] * unit) << k;
  expect_beam(hung, 1e-3, 0.0);
}

TEST(Modes, ofABeamWithTheBitsMassAndInTension)
{
  Scene scene = hanging(20.0, 2000.0);
  scene.string[0].density = scene.mud.density;  // no weight
  expect_beam(Hung(scene), 2000.0, 0.0);
  scene.string[0].density = steel_density;
  expect_beam(Hung(scene), 2000.0, 2000.0 * standard_gravity * (1.0 - scene.mud.density / steel_density));
}

TEST(Modes, ofAnAssemblyThatIsCutOff)
{
  const Hung hung(hanging(300.0, 1e-3));
  const Mesh& mesh = hung.rig.model->mesh();
  const int clamp = node_at(mesh, 100.0);
  EXPECT_NEAR(mesh.nodes[static_cast<std::size_t>(clamp)].from_bit, 100.0, 3.0);
  const double length = mesh.nodes[static_cast<std::size_t>(clamp)].from_bit - bit_radius;
  const double expected = std::sqrt(hung.section.axial / plain_pipe_mass) / (4.0 * length);
  const std::vector<Mode> modes = find_modes(hung.rig, ModeFamily::axial, clamp, 1);
  EXPECT_NEAR(modes[0].frequency(), expected, 1e-3 * expected);
  ASSERT_EQ(modes[0].shape.size(), static_cast<std::size_t>(clamp) + 1);
  EXPECT_EQ(modes[0].shape[0].axial, 1.0);
  EXPECT_EQ(modes[0].shape.back().axial, 0.0);
  for (int i = 0; i < clamp; i += 5)
    EXPECT_NEAR(modes[0].shape[static_cast<std::size_t>(i)].axial,
                std::cos(0.5 * pi * (mesh.nodes[static_cast<std::size_t>(i)].from_bit - bit_radius) / length), 1e-3);
}

// In a straight vertical string nothing couples: all together are the three families.
TEST(Modes, coupledAreTheFamiliesOfAStraightString)
{
  const Hung hung(hanging(20.0, 50.0));
  std::vector<double> apart;
  for (const ModeFamily family : {ModeFamily::axial, ModeFamily::torsional, ModeFamily::lateral})
    for (const Mode& m : find_modes(hung.rig, family, hung.top, 30)) apart.push_back(m.frequency());
  std::sort(apart.begin(), apart.end());
  const std::vector<Mode> together = find_modes(hung.rig, ModeFamily::coupled, hung.top, 30);
  int axial = 0;
  for (std::size_t k = 0; k < together.size(); ++k)
  {
    const Mode& m = together[k];
    EXPECT_NEAR(m.frequency(), apart[k], 1e-6 * apart[k]) << k;
    EXPECT_GT(std::max({m.axial, m.torsional, m.lateral}), 0.999) << k;
    EXPECT_NEAR(m.axial + m.torsional + m.lateral, 1.0, 1e-9);
    axial += m.axial > 0.5;
  }
  EXPECT_GE(axial, 1);
}

// Weight on bit takes stiffness from the string above it.
TEST(Modes, weightOnBitLowersTheLateralOnes)
{
  Scene scene = hanging(20.0, 500.0);
  scene.string[1].density = steel_density;
  const double free = Hung(scene).frequency(ModeFamily::lateral, 0);
  scene.well.hole_depth = scene.start.bit_depth;
  scene.well.sections[0].to = scene.well.survey.back().md;
  scene.start.weight_on_bit = 3000.0;
  const Hung pressed(scene);
  EXPECT_NEAR(pressed.rig.statics.forces.wob, 3000.0, 30.0);
  EXPECT_LT(pressed.frequency(ModeFamily::lateral, 0), free);
  EXPECT_GT(pressed.frequency(ModeFamily::axial, 0), Hung(hanging(20.0, 500.0)).frequency(ModeFamily::axial, 0))
      << "and the rock holds the bit";
}
}  // namespace test_tools_modes
