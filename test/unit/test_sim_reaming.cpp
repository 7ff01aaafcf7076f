// SPDX-License-Identifier: BSD-3-Clause
// A bit that widens a narrower hole: weight and torque of the ring, the way of the pilot, and rock again beyond it.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_ahead.h"
#include "drill_rig_sim/contact/bit_torque.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/well/pilot_hole.h"
#include "drill_rig_sim/well/wellbore.h"
#include "playing.h"
#include "test_scenes.h"

namespace test_sim_reaming
{
using namespace drill_rig_sim;

namespace
{
constexpr double half_bit = 0.10795;  // diameter of the pilot [m]: q = 1/2
constexpr double feed = 0.01;         // [m/s]
constexpr double turning = 10.0;      // [rad/s]

/// On bottom of 100 m, a pilot on to `pilot_depth` along `survey`.
Scene reaming_scene(double pilot_depth, double inclination = 0.0)
{
  Scene scene = drilling_scene(0.0);
  scene.well.survey = {{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {130.0, inclination, 0.0}};
  scene.well.pilot_depth = pilot_depth;
  scene.well.pilot_diameter = half_bit;
  scene.start.weight_on_bit = 1e3;
  return scene;
}

/// Mean weight and torque on bit over two seconds, about two of its turns.
struct Loads
{
  double weight = 0.0, torque = 0.0;
};
Loads loads_over_two_seconds(Simulator& rig)
{
  Loads sum;
  for (int k = 0; k < 200; ++k)
  {
    EXPECT_EQ(rig.frame(0.01), FrameStatus::running);
    sum.weight += rig.truth().wob / 200.0;
    sum.torque += rig.truth().bit_torque / 200.0;
  }
  return sum;
}
}  // namespace

// int dr = a/2, int r dr = 3 a^2/8 = 3/4 of a^2/2, int r^2 dr = 7 a^3/24 = 7/8 of a^3/3 from a/2 to a.
TEST(Ring, takesItsShareOfTheFace)
{
  FormationLayer rock;
  rock.drillability = 1e-8;
  rock.weight_exponent = 2.0;
  rock.threshold = 4e3;
  const FormationLayer by_width = ring_of(rock, 0.5, true), by_area = ring_of(rock, 0.5, false);
  EXPECT_DOUBLE_EQ(by_width.ring.share, 0.5);
  EXPECT_DOUBLE_EQ(by_width.ring.share * by_width.ring.lever, 0.75);
  EXPECT_DOUBLE_EQ(by_area.ring.share, 0.75);
  EXPECT_DOUBLE_EQ(by_area.ring.share * by_area.ring.lever, 0.875);
  // at the same rate half the weight
  EXPECT_NEAR(on_axis_rop(by_width, 10.0, 10e3), on_axis_rop(rock, 10.0, 20e3), 1e-15);
  EXPECT_EQ(on_axis_rop(by_width, 10.0, 2e3), 0.0);
  const FormationLayer whole = ring_of(rock, 0.0, true);
  EXPECT_EQ(whole.drillability, rock.drillability);
  EXPECT_EQ(whole.ring.lever, 1.0);
}

TEST(Ring, makesItsShareOfTheTorqueAtTheSameDepthOfCut)
{
  FormationLayer rock;
  rock.drillability = 1e-8;
  rock.threshold = 4e3;
  BitTorqueSpec drag;
  drag.model = BitTorqueModel::detournay;
  drag.wear_weight = 3e3;
  const double diameter = 0.2, force = 40e3, speed = 12.0;
  const FormationLayer ring = ring_of(rock, 0.5, true);
  for (const double energy : {0.0, 1.0 / (pi * diameter * rock.drillability * cutter_inclination)})
  {
    drag.cutting_energy = energy;
    const TorqueLimit full = bit_torque_limit(drag, diameter, force, speed, rock),
                      part = bit_torque_limit(drag, diameter, 0.5 * force, speed, ring);
    EXPECT_NEAR(part.value, 0.75 * full.value, 1e-9 * full.value) << energy;
    EXPECT_NEAR(part.force_slope, 1.5 * full.force_slope, 1e-9 * full.force_slope) << energy;
  }
  const BitTorqueSpec pressed;
  const TorqueLimit full = bit_torque_limit(pressed, diameter, force, speed, rock);
  const TorqueLimit part = bit_torque_limit(pressed, diameter, 0.75 * force, speed, ring_of(rock, 0.5, false));
  EXPECT_NEAR(part.value, 0.875 * full.value, 1e-9 * full.value);
  EXPECT_NEAR(part.speed_slope, 0.875 * full.speed_slope, 1e-9 * full.value);
}

// K N W = feed: 7692 N in the whole rock, three quarters of it on the ring.
TEST(Reaming, asksForTheRingsWeightAndTorqueThenForTheWholeFaces)
{
  const Scene scene = reaming_scene(100.2);
  Simulator rig(scene);
  rig.balance_energy();
  drill_ahead(rig, turning, 0.0, feed);
  play(rig, 14.0);
  ASSERT_LT(rig.truth().hole_depth, 100.17);
  const Loads reaming = loads_over_two_seconds(rig);
  play(rig, 14.0);
  ASSERT_GT(rig.truth().hole_depth, 100.25);
  const Loads drilling = loads_over_two_seconds(rig);
  const double weight = feed / (scene.formation[0].drillability * turning);
  EXPECT_NEAR(drilling.weight, weight, 0.01 * weight);
  EXPECT_NEAR(reaming.weight, 0.75 * weight, 0.01 * weight);
  EXPECT_NEAR(reaming.torque, 0.875 * drilling.torque, 0.01 * drilling.torque);
  EXPECT_LT(rig.energy().closure(), 0.005);
  EXPECT_LT(rig.energy().numerical_magnitudes(), 0.05 * rig.energy().throughput());
}

// A pilot that builds 6 deg in 30 m is 7 mm aside after two metres; the bottom cuts its bend by 0.16 mm.
TEST(Reaming, followsThePilot)
{
  const Scene scene = reaming_scene(110.0, 6.0 * degree);
  Simulator rig(scene);
  drill_ahead(rig, turning, 0.0, feed);
  play(rig, 210.0);
  const double depth = rig.truth().hole_depth;
  ASSERT_GT(depth, 101.9);
  const Eigen::Vector3d axis = Survey(scene.well.survey).at(depth).position, bottom = rig.wellbore().bottom_position();
  EXPECT_GT(axis.head<2>().norm(), 6e-3);
  EXPECT_LT((bottom - axis).head<2>().norm(), 0.3e-3);
}
}  // namespace test_sim_reaming
