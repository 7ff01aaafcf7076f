// SPDX-License-Identifier: BSD-3-Clause
// A bent motor that its hole bends straight is reported, one that leans in it is not.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/sim/profile.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/solve/start.h"
#include "test_scenes.h"

namespace test_sim_assembly_fit
{
using namespace drill_rig_sim;

namespace
{
/// A motor of 6 3/4 in in a hole of 8 1/2 in at 60 deg; `sleeve`: over its blades, 0: none [m].
Scene bent_motor(double bend, double sleeve, double bit_to_sleeve = 0.9)
{
  Scene scene = scene_in({{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {700.0, 60.0 * degree, 0.0}, {1000.0, 60.0 * degree, 0.0}}, 1000.0,
                         990.0, 0.2);
  scene.string = {bit_part(0.2159), motor_part(bend), collar_part(3, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
  scene.string[1].motor->sleeve_diameter = sleeve;
  scene.string[1].motor->bit_to_sleeve = bit_to_sleeve;
  return scene;
}

std::optional<TightAssembly> tight_at_rest(const Scene& scene)
{
  const RigAtRest rig = build_at_rest(scene);
  return tight_assembly(*rig.model, rig.statics.forces);
}
}  // namespace

TEST(AssemblyFit, aTightSleeveBelowALargeBend)
{
  const auto tight = tight_at_rest(bent_motor(1.5 * degree, 0.20955));
  ASSERT_TRUE(tight);
  EXPECT_GT(tight->side_force, 40e3);
  EXPECT_NEAR(tight->weight, standard_gravity * (40.0 + 8.3 * 136.0) * (1.0 - 1200.0 / 7850.0), 0.05 * tight->weight);
  EXPECT_NE(text_of(*tight).find("does not fit into its hole"), std::string::npos);
  EXPECT_TRUE(tight_at_rest(bent_motor(1.83 * degree, 0.2096, 0.7)));
}

// Its side force drags on the wall, which the hook load of drill static holds too.
TEST(AssemblyFit, isPartOfAStaticReport)
{
  const StaticReport tight = static_report(bent_motor(1.5 * degree, 0.20955), sliding_up);
  ASSERT_TRUE(tight.tight);
  EXPECT_GT(tight.tight->side_force, 40e3);
  const StaticReport loose = static_report(bent_motor(1.5 * degree, 0.0), sliding_up);
  EXPECT_FALSE(loose.tight);
  EXPECT_GT(tight.hook_load, loose.hook_load + 0.2 * (tight.tight->side_force - loose.bit_side_force));
}

TEST(AssemblyFit, aMotorThatLeansInItsHole)
{
  for (const double bend : {0.0, 0.5, 1.0, 1.5})
  {
    const auto tight = tight_at_rest(bent_motor(bend * degree, 0.0));
    EXPECT_FALSE(tight) << bend << " deg, " << (tight ? tight->side_force : 0.0) << " N";
  }
  EXPECT_FALSE(tight_at_rest(bent_motor(0.5 * degree, 0.2064))) << "a sleeve of 8 1/8 in below half a degree";
}

// Pressed aside with 50 kN under little weight the bit drills sideways by the rock law: by tens of degrees within a metre, were
// it not for the body behind it.
TEST(AssemblyFit, theHoleTurnsNoFasterThanTheBodyLetsIt)
{
  Scene scene = bent_motor(1.5 * degree, 0.20955);
  scene.start.bit_depth = 999.9;
  scene.string[0].bit->side_cutting = 0.3;
  Simulator rig(scene);
  ASSERT_TRUE(rig.statistics().tight);
  const Eigen::Vector3d before = rig.wellbore().end_direction();
  rig.command(PumpSetpoint{0.03});
  rig.command(WinchSetpoint{-0.005, false});
  bool warned = false;
  for (int k = 0; k < 8000; ++k)
  {
    ASSERT_EQ(FrameStatus::running, rig.frame(0.01)) << rig.failure();
    warned = warned || rig.statistics().accuracy.doubt == AccuracyDoubt::turn;
  }
  const double most = rig.statistics().tight->turn * (2.0 - 0.5 * 0.2159),
               turned = std::acos(before.dot(rig.wellbore().end_direction()));
  EXPECT_TRUE(warned);
  EXPECT_TRUE(rig.truth().accuracy_warning);
  EXPECT_GT(rig.truth().hole_depth, 1000.02);
  EXPECT_LT(turned, 1.1 * most);
}

// A motor that fits never comes near.
TEST(AssemblyFit, anOrdinaryMotorIsNotHeldBack)
{
  Scene scene = bent_motor(1.5 * degree, 0.0);
  scene.start.bit_depth = 999.9;
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.03});
  rig.command(WinchSetpoint{-0.01, false});
  for (int k = 0; k < 8000; ++k)
  {
    ASSERT_EQ(FrameStatus::running, rig.frame(0.01)) << rig.failure();
    ASSERT_NE(AccuracyDoubt::turn, rig.statistics().accuracy.doubt) << 0.01 * k << " s";
  }
  EXPECT_GT(rig.truth().hole_depth, 1000.2);
}
}  // namespace test_sim_assembly_fit
