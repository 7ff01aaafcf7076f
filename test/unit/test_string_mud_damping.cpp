// SPDX-License-Identifier: BSD-3-Clause
// What a mud takes from a string's waves, against the shear layer's own equation and Couette's flow.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/string/mud_damping.h"
#include "test_scenes.h"

namespace test_string_mud_damping
{
using namespace drill_rig_sim;
using Complex = std::complex<double>;

constexpr double w = 2.0 * pi;      // 1 Hz, along and about
constexpr double across = 5.0 * w;  // 5 Hz, across

MudSpec mud_of(double density, double viscosity)
{
  MudSpec mud;
  mud.density = density;
  mud.viscosity = viscosity;
  return mud;
}

/// Shear stress in phase with the speed of a wall that swings along itself, over that speed, beside a wall that stands still at
/// distance `gap`: i rho w u = mu u'' by central differences [Pa s/m].
double drag_beside_wall(double density, double viscosity, double gap)
{
  const int n = 20000;
  const double h = gap / n;
  const Complex centre(2.0, density * w * h * h / viscosity);
  std::vector<Complex> share(n);  // of the node before, in this one's speed, from the far wall on
  share[n - 1] = 1.0 / centre;
  for (int k = n - 2; k > 0; --k) share[k] = 1.0 / (centre - share[k + 1]);
  // one-sided difference of second order: u0 = 1, u1, u2
  const Complex u1 = share[1], u2 = share[2] * u1;
  return std::real(viscosity * (1.5 - 2.0 * u1 + 0.5 * u2) / h);
}

TEST(MudDamping, ofAWideGapIsTheShearLayers)
{
  const MudSpec mud = mud_of(1150.0, 0.02);
  const MudDamping drag = mud_damping(mud, 0.127, 0.1086, 0.2159);
  const double layer = std::sqrt(0.5 * 1150.0 * 0.02 * w);
  EXPECT_NEAR(drag.along, pi * (0.127 + 0.1086) * layer, 1e-6 * drag.along);
  EXPECT_NEAR(drag.along, 6.29, 0.01) << "[N s/m per m]";
  EXPECT_NEAR(drag.about, 0.0222, 1e-4) << "[N m s/rad per m]";
  EXPECT_NEAR(drag.across, 42.7, 0.1) << "[N s/m per m]";
}

TEST(MudDamping, solvesTheEquationOfTheShearLayer)
{
  for (const double viscosity : {0.005, 0.05, 0.5})
    for (const double gap : {0.002, 0.01, 0.05})
    {
      const double outer = 0.1651, pipe = mud_damping(mud_of(1300.0, viscosity), outer, 0.0, outer + 2.0 * gap).along;
      EXPECT_NEAR(pipe, pi * outer * drag_beside_wall(1300.0, viscosity, gap), 1e-4 * pipe)
          << viscosity << " Pa s, " << gap << " m";
    }
}

TEST(MudDamping, ofANarrowGapIsCouettes)
{
  const double outer = 0.2, gap = 1.5e-3;
  const MudDamping drag = mud_damping(mud_of(1200.0, 0.5), outer, 0.0, outer + 2.0 * gap);
  EXPECT_NEAR(drag.along, pi * outer * 0.5 / gap, 1e-3 * drag.along);
  EXPECT_NEAR(drag.about, 0.25 * outer * outer * drag.along, 1e-12);
}

TEST(MudDamping, acrossGrowsInATightHoleAndStaysFinite)
{
  const MudSpec mud = mud_of(1200.0, 0.02);
  const double free = mud_damping(mud, 0.1651, 0.07, 100.0).across, tight = mud_damping(mud, 0.1651, 0.07, 0.2159).across;
  EXPECT_NEAR(free, 2.0 * pi * 0.1651 * std::sqrt(0.5 * 1200.0 * 0.02 * across), 1e-4 * free);
  EXPECT_NEAR(tight / free, (1.0 + std::pow(0.1651 / 0.2159, 3)) / std::pow(1.0 - std::pow(0.1651 / 0.2159, 2), 2), 1e-4);
  EXPECT_NEAR(mud_damping(mud, 0.2158, 0.07, 0.2159).across / mud_damping(mud, 0.2158, 0.07, 100.0).across, 13.9, 0.1);
}

TEST(MudDamping, thereIsNoneInAirOrWithoutViscosity)
{
  for (const MudSpec& mud : {mud_of(0.0, 0.02), mud_of(1200.0, 0.0)})
  {
    const MudDamping drag = mud_damping(mud, 0.127, 0.1086, 0.2159);
    EXPECT_EQ(drag.along, 0.0);
    EXPECT_EQ(drag.across, 0.0);
    EXPECT_EQ(drag.about, 0.0);
  }
}

TEST(MudDamping, keysStandOverTheViscosityZeroIncluded)
{
  Scene scene = vertical_scene(400.0, 390.0);
  scene.mud = mud_of(1150.0, 0.02);
  scene.mud.axial_damping = 0.0;
  scene.mud.torsional_damping = 0.5;
  const Mesh mesh = build_mesh(scene, 410.0);
  for (const MeshNode& node : mesh.nodes)
  {
    EXPECT_EQ(node.mud_along, 0.0);
    EXPECT_EQ(node.mud_about, 0.5 * node.length);
  }
  const MeshNode& pipe = mesh.nodes[mesh.nodes.size() / 2];
  EXPECT_NEAR(pipe.mud_across / pipe.length, 42.7, 0.1);
}
}  // namespace test_string_mud_damping
