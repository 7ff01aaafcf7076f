// SPDX-License-Identifier: BSD-3-Clause
// Drilling a vertical hole without friction: the winch sets the rate, the rock law the weight, and the hole grows by what is
// drilled.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/hydraulics/mud_circuit.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/well/wellbore.h"
#include "drill_ahead.h"
#include "test_scenes.h"

namespace test_sim_on_bottom
{
using namespace drill_rig_sim;

namespace
{
constexpr double kFrame = 0.01;

/// A constant of the drilling law per case: about 10 kN at 10 mm/s and 9.4 rad/s.
struct Rock
{
  double drillability, weight_exponent, speed_exponent, threshold;
};

/// The bit's friction does not fall with its speed, so that it does not drive the string's torsional swing.
Scene frictionless(const Rock& rock)
{
  Scene scene = drilling_scene(0.005, 0.0);
  scene.string[0].bit->torque.static_friction = scene.string[0].bit->torque.kinetic_friction = 0.4;
  FormationLayer& layer = scene.formation[0];
  layer.drillability = rock.drillability;
  layer.weight_exponent = rock.weight_exponent;
  layer.speed_exponent = rock.speed_exponent;
  layer.threshold = rock.threshold;
  return scene;
}

void drill(Simulator& rig, double feed, double speed, double seconds)
{
  drill_ahead(rig, speed, 0.02, feed);
  for (int k = 0; k < std::lround(seconds / kFrame); ++k) ASSERT_EQ(rig.frame(kFrame), FrameStatus::running) << rig.failure();
}

/// Volume of the hole from measured depth `from` down, by its nodes.
double volume_below(const Wellbore& well, double from)
{
  double volume = 0.0, md = from;
  for (int i = 0; i < well.node_count(); ++i)
  {
    const WellNode node = well.node(i);
    if (node.md <= md) continue;
    volume += pi * node.radius * node.radius * (node.md - md);
    md = node.md;
  }
  return volume + pi * well.bottom_radius() * well.bottom_radius() * (well.hole_depth() - md);
}
}  // namespace

// Steady after some time constants of weight (compliance of line and string over the rock's slope, 1 to 3 s): 40 s leave e^-13.
TEST(OnBottom, feedSetsTheRateAndTheRockLawTheWeight)
{
  const Rock rocks[] = {{1.3e-7, 1.0, 1.0, 0.0}, {1.3e-7, 1.0, 1.0, 3000.0}, {6.0e-9, 1.3, 1.0, 0.0}, {6.0e-6, 0.7, 0.8, 0.0}};
  for (const Rock& rock : rocks)
  {
    Simulator rig(frictionless(rock));
    const double speed = 90.0 * rpm, feed = 0.010;
    drill(rig, feed, speed, 5.0 + 40.0);
    const Truth& m = rig.truth();
    ASSERT_TRUE(m.on_bottom);
    const double start = m.hole_depth, start_time = m.time;
    // means over ten seconds: a swing of the string dies slowly
    double weight = 0.0, torque = 0.0, surface_torque = 0.0, bit_speed = 0.0, rop = 0.0;
    for (int k = 0; k < 1000; ++k)
    {
      drill(rig, feed, speed, kFrame);
      weight += m.wob / 1000.0;
      torque += m.bit_torque / 1000.0;
      surface_torque += m.torque / 1000.0;
      bit_speed += m.bit_speed / 1000.0;
      rop += m.rop / 1000.0;
    }
    const double rate = (m.hole_depth - start) / (m.time - start_time);
    EXPECT_NEAR(rate, feed, 1e-3 * feed);
    EXPECT_NEAR(rop, feed, 1e-3 * feed);
    EXPECT_NEAR(bit_speed, speed, 1e-3 * speed);
    const double law =
        rock.threshold + std::pow(feed / (rock.drillability * std::pow(speed, rock.speed_exponent)), 1.0 / rock.weight_exponent);
    // 0.2 %: the feed itself wanders by the stretch of the line while the block falls
    EXPECT_NEAR(weight, law, 2e-3 * law) << "exponents " << rock.weight_exponent << ", " << rock.speed_exponent;
    EXPECT_NEAR(torque, 0.4 * weight * 0.2159 / 3.0, 1e-3 * torque);
    const double drag = 5e-4 * 100.0 * speed;  // of the mud on the string, half a newton metre
    EXPECT_NEAR(surface_torque, torque + drag, 5e-3 * torque);
  }
}

TEST(OnBottom, hookLoadDropsByTheWeightOnBit)
{
  Simulator rig(frictionless({1.3e-7, 1.0, 1.0, 0.0}));
  const double off_bottom = rig.truth().hook_load;
  ASSERT_TRUE(rig.tare());
  drill(rig, 0.010, 90.0 * rpm, 45.0);
  const Truth& m = rig.truth();
  // buoyancy of the 0.45 m that went under water is 160 N, in a drop of 8 kN: added by hand
  const double submerged = 0.45 * standard_gravity * 1150.0 * tool_jointed_mass / steel_density;
  // and the rail carries its share of a block that goes down
  const double rail = 0.03 * standard_gravity * 17500.0;
  // and mud lifts the string on its way up the annulus (hydraulics/mud_circuit.h): collars, then pipe
  const auto lift = [&m](double length, double diameter)
  { return length * annulus_gradient(1150.0, m.bit_flow, 0.2159, diameter) * 0.25 * pi * diameter * 0.2159; };
  const double lifted = lift(18.8, 0.165) + lift(100.0 - 19.1, pipe_outer);
  EXPECT_GT(lifted, 500.0);
  EXPECT_NEAR(off_bottom - m.hook_load, m.wob + submerged + rail + lifted, 0.02 * m.wob);
  EXPECT_NEAR(m.surface_wob, off_bottom - m.hook_load, 1e-9);
  EXPECT_FALSE(rig.tare()) << "on bottom";
}

TEST(OnBottom, holeGrowsByWhatTheBitDrills)
{
  const Scene scene = frictionless({1.3e-7, 1.0, 1.0, 0.0});
  Simulator rig(scene);
  const Wellbore& well = rig.wellbore();
  const Truth& m = rig.truth();
  drill(rig, 0.010, 90.0 * rpm, 20.0);
  const double hole = m.hole_depth, bit = m.bit_depth, path = well.drilled_path_length(), volume = volume_below(well, 99.0);
  double drilled = 0.0;
  for (int k = 0; k < 10000; ++k)
  {
    drill(rig, 0.010, 90.0 * rpm, kFrame);
    drilled += m.rop * kFrame;
  }
  const double gained = m.hole_depth - hole;
  EXPECT_NEAR(gained, 1.0, 2e-3);
  // length: hole, path and the sum of the published rate are the same centimetres
  EXPECT_NEAR(well.drilled_path_length() - path, gained, 1e-9);
  EXPECT_NEAR(drilled, gained, 1e-9);
  EXPECT_NEAR(-well.bottom_position().z(), m.hole_depth, 1e-9);
  // the bit follows but for its embedding in the rock, some tenths of a millimetre
  EXPECT_NEAR(m.bit_depth - bit, gained, 1e-5);
  EXPECT_NEAR(m.bit_depth, m.hole_depth, 1e-3);
  EXPECT_GE(m.bit_depth, m.hole_depth);
  // volume of a bit-sized cylinder
  const double radius = 0.5 * scene.string[0].bit->diameter;
  EXPECT_NEAR(volume_below(well, 99.0) - volume, pi * radius * radius * gained, 1e-9);
}

TEST(OnBottom, bitThatDoesNotTurnDrillsNothing)
{
  Simulator rig(frictionless({1.3e-7, 1.0, 0.0, 0.0}));
  const double hole = rig.truth().hole_depth;
  drill(rig, 0.010, 0.0, 5.0);
  EXPECT_GT(rig.truth().wob, 1000.0);
  EXPECT_EQ(rig.truth().hole_depth, hole);
}

/// Why the scene cannot be started; empty where it can.
std::string refusal_of(const Scene& scene)
{
  try
  {
    Simulator rig(scene);
    return "";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}

// A start that could not rest is refused: the bit resists by mu F D/3, and string and block together must hang on the line.
TEST(OnBottom, aStartHoldsOnlyWhatRockAndLineHold)
{
  Scene scene = frictionless({1.3e-7, 1.0, 0.0, 0.0});
  scene.start.bit_depth = scene.well.hole_depth;
  scene.start.weight_on_bit = 20e3;
  const double most = 0.4 * 20e3 * scene.string[0].bit->diameter / 3.0;
  scene.start.torque_on_bit = 0.999 * most;
  EXPECT_EQ("", refusal_of(scene));
  scene.start.torque_on_bit = 1.001 * most;
  EXPECT_EQ(0u, refusal_of(scene).find("start: torque_on_bit: ")) << refusal_of(scene);
  scene.start.torque_on_bit = 1e3 * most;  // with which the string has no equilibrium
  EXPECT_EQ(0u, refusal_of(scene).find("start: torque_on_bit: ")) << refusal_of(scene);
  scene.start.torque_on_bit = 0.0;
  scene.start.weight_on_bit = 2e6;
  EXPECT_EQ(0u, refusal_of(scene).find("start: weight_on_bit: ")) << refusal_of(scene);
}

// A drag bit that stands resists by the weight that cuts, a (F - F_0)/(2 zeta), in the rock of the hole's bottom.
TEST(OnBottom, aStartsTorqueIsHeldByTheBottomsRock)
{
  Scene scene = frictionless({1.3e-7, 1.0, 0.0, 0.0});
  scene.formation.insert(scene.formation.begin(), scene.formation[0]);
  scene.formation[0].to_tvd = 50.0;
  scene.formation[1].threshold = 5e3;
  scene.string[0].bit->torque.model = BitTorqueModel::detournay;
  scene.start.bit_depth = scene.well.hole_depth;
  scene.start.weight_on_bit = 20e3;
  const double a = 0.5 * scene.string[0].bit->diameter;
  const double most = a * 15e3 / (2.0 * cutter_inclination);
  scene.start.torque_on_bit = 0.999 * most;
  EXPECT_EQ("", refusal_of(scene));
  scene.start.torque_on_bit = 1.001 * most;
  EXPECT_EQ(0u, refusal_of(scene).find("start: torque_on_bit: ")) << refusal_of(scene);
}

/// Direction of the hole after half a metre drilled on from a straight one at 20 deg, behind the bit a string of slick collars:
/// turn of inclination and azimuth since [rad].
std::pair<double, double> drift(double side_cutting, double friction)
{
  Scene scene = scene_in(build_and_hold(20.0, 0.5 * degree, slant, slant_azimuth, 200.0), 200.0, 199.99, friction);
  scene.string.insert(scene.string.begin() + 1, collar_part(4, 9.4));
  scene.string[0].bit->side_cutting = side_cutting;
  Simulator rig(scene);
  drill(rig, 0.02, 120.0 * rpm, 25.0);
  EXPECT_NEAR(rig.truth().hole_depth, 200.5, 0.05);
  return {rig.truth().bit_inclination - slant, rig.truth().bit_azimuth - slant_azimuth};
}

// The textbook's pendulum: collars that hang from a far point of contact press the bit on the low side, and side cutting makes
// that drop. Without friction it does not walk; with it the bit that turns clockwise climbs to the right on the low side.
TEST(OnBottom, pendulumDropsAndFrictionWalksItToTheRight)
{
  const auto [drop, walk] = drift(0.3, 0.0);
  EXPECT_LT(drop, -1.0 * degree);
  EXPECT_NEAR(walk, 0.0, 0.02 * degree);
  EXPECT_GT(drift(0.3, 0.3).second, 0.5 * degree);
  EXPECT_LT(std::abs(drift(0.0, 0.0).first), 0.25 * std::abs(drop)) << "a bit that does not cut sideways goes where it points";
}

// A bit that stands by turns drills with its mean speed when it turns: of all turns none is lost, whatever the lag.
TEST(OnBottom, aBitThatStopsAndGoesDrillsByItsTurns)
{
  for (const double lag : {0.1, 0.4, 1.0})
  {
    Scene scene = frictionless({1.3e-7, 1.0, 1.0, 0.0});
    scene.string[0].bit->speed_lag = lag;
    Simulator rig(scene);
    drill(rig, 1e-3, 9.4, 20.0);
    double turned = 0.0, drilled_with = 0.0, stood = 0.0, depth = rig.truth().hole_depth;  // rad, rad, s, m
    for (int k = 0; k < 60; ++k)
    {
      drill_ahead(rig, k % 2 == 0 ? 0.0 : 12.0, 0.02, 1e-3);
      for (int frame = 0; frame < 200; ++frame)
      {
        ASSERT_EQ(rig.frame(kFrame), FrameStatus::running) << rig.failure();
        turned += rig.truth().bit_speed * kFrame;
        drilled_with += (rig.truth().hole_depth - depth) / (1.3e-7 * rig.truth().wob);
        depth = rig.truth().hole_depth;
        if (std::abs(rig.truth().bit_speed) < 0.1) stood += kFrame;
      }
    }
    EXPECT_GT(stood, 20.0) << "of 120 s";
    EXPECT_NEAR(drilled_with / turned, 1.0, 0.03) << lag;
  }
}
}  // namespace test_sim_on_bottom
