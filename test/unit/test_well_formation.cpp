// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/formation.h"

namespace drill_rig_sim::test_well_formation
{
namespace
{
using Eigen::Vector3d;

FormationLayer main_job_rock()
{
  FormationLayer rock;
  rock.to_tvd = 10000.0;
  rock.drillability = 8.6e-9;
  return rock;
}

// 8.6e-9 m/s per (N rad/s) * 14.26 rad/s * 74 kN = 9.08 mm/s = 32.7 m/h: the paper's rate.
TEST(Formation, OnAxisRateHasTheUnitsOfTheScene)
{
  const FormationLayer rock = main_job_rock();
  EXPECT_NEAR(on_axis_rop(rock, 14.26, 74e3), 8.6e-9 * 14.26 * 74e3, 1e-18);
  EXPECT_NEAR(on_axis_rop(rock, 14.26, 74e3) * 3600.0, 32.7, 0.1);
}

TEST(Formation, OnAxisForceDrillsAlongTheAxisByThePowerLaw)
{
  FormationLayer rock = main_job_rock();
  rock.weight_exponent = 1.3;
  rock.speed_exponent = 0.7;
  rock.threshold = 5e3;
  const Vector3d axis = tangent_from(51.0 * degree, 297.0 * degree);
  const Vector3d v = rock_breaking_velocity(rock, 60e3 * axis, 12.0, axis, 0.1);
  const double expected = 8.6e-9 * std::pow(12.0, 0.7) * std::pow(55e3, 1.3);
  EXPECT_NEAR(v.dot(axis) / expected, 1.0, 2e-5);  // N^2/(N^2 + 0.05^2) at 12 rad/s
  EXPECT_LT((v - v.dot(axis) * axis).norm(), 1e-15 * v.norm() + 1e-18);
}

TEST(Formation, SideForceCutsByTheBitsSideCutting)
{
  const FormationLayer rock = main_job_rock();
  const Vector3d axis = -Vector3d::UnitZ();
  const Vector3d force = 70e3 * axis + 7e3 * Vector3d::UnitX();
  const Vector3d v = rock_breaking_velocity(rock, force, 14.0, axis, 0.1);
  EXPECT_NEAR(v.x() / -v.z(), 0.1 * 0.1, 1e-9);
  EXPECT_NEAR(-v.z(), 8.6e-9 * 14.0 * 70e3, 1e-5 * 8.4e-3);  // alpha = 1: g(|F|)/|F| = 1
  const Vector3d none = rock_breaking_velocity(rock, force, 14.0, axis, 0.0);
  EXPECT_EQ(none.x(), 0.0);
}

// A bit that leans on its gauge, its face hardly pressed, drills less: half where the weight is a hundredth of the side force.
TEST(Formation, AFaceThatIsHardlyPressedDrillsLess)
{
  const FormationLayer rock = main_job_rock();
  const Vector3d axis = -Vector3d::UnitZ();
  const auto down = [&](double weight, double side)
  { return rock_breaking_velocity(rock, weight * axis + side * Vector3d::UnitX(), 14.0, axis, 0.0).dot(axis); };
  const double full = down(700.0, 0.0);
  EXPECT_NEAR(down(700.0, 70e3), 0.5 * full, 1e-9 * full);
  EXPECT_NEAR(down(700.0, 140e3), 0.2 * full, 1e-9 * full);
}

// Strike north, dip to its right: east. The beds go down to the east, their upward normal leans east.
TEST(Formation, BedNormalFollowsTheRightHandRule)
{
  FormationLayer rock = main_job_rock();
  rock.dip = 30.0 * degree;
  rock.strike = 0.0;
  const Vector3d n = bed_normal(rock);
  EXPECT_NEAR((n - Vector3d(0.5, 0.0, std::sqrt(0.75))).norm(), 0.0, 1e-15);
  const Vector3d down_dip(std::cos(rock.dip), 0.0, -std::sin(rock.dip));
  EXPECT_NEAR(n.dot(down_dip), 0.0, 1e-15);
  rock.strike = 90.0 * degree;  // to the south
  EXPECT_NEAR((bed_normal(rock) - Vector3d(0.0, -0.5, std::sqrt(0.75))).norm(), 0.0, 1e-15);
}

// By hand: straight down into beds dipping 30 deg east, h = 0.2, i_b = 1: A_f (-z) = -0.8 z - 0.2 cos30 n
// = (-0.2 cos30 sin30, 0, -0.8 - 0.2 cos^2 30): up-dip, to the west, as wells drift in dipping beds.
TEST(Formation, AnisotropyTurnsTheBitUpDip)
{
  FormationLayer rock = main_job_rock();
  rock.dip = 30.0 * degree;
  rock.anisotropy = 0.2;
  const Vector3d axis = -Vector3d::UnitZ();
  const Vector3d v = rock_breaking_velocity(rock, 70e3 * axis, 14.0, axis, 1.0) / (8.6e-9 * 14.0 * 70e3);
  EXPECT_NEAR(v.x(), -0.2 * std::sqrt(0.75) * 0.5, 1e-12);
  EXPECT_NEAR(v.y(), 0.0, 1e-12);
  EXPECT_NEAR(v.z(), -0.8 - 0.2 * 0.75, 1e-12);
}

TEST(Formation, NothingIsDrilledOffBottomOrWithoutTurning)
{
  FormationLayer rock = main_job_rock();
  const Vector3d axis = -Vector3d::UnitZ();
  for (double beta : {0.0, 0.5, 1.0})
  {
    rock.speed_exponent = beta;
    EXPECT_EQ(rock_breaking_velocity(rock, 70e3 * axis, 0.0, axis, 0.1).norm(), 0.0);
    EXPECT_EQ(rock_breaking_velocity(rock, 70e3 * axis, -3.0, axis, 0.1).norm(), 0.0);
    EXPECT_EQ(rock_breaking_velocity(rock, Vector3d::Zero(), 14.0, axis, 0.1).norm(), 0.0);
    EXPECT_EQ(rock_breaking_velocity(rock, 5e3 * Vector3d::UnitX(), 14.0, axis, 0.1).norm(), 0.0);
    EXPECT_EQ(rock_breaking_velocity(rock, -5e3 * axis, 14.0, axis, 0.1).norm(), 0.0);
    // continuously: a hundredth of a turn a minute drills next to nothing
    EXPECT_LT(on_axis_rop(rock, 1e-3, 70e3), 1e-3 * on_axis_rop(rock, 14.0, 70e3));
  }
}

// Also where the weight vanishes under a side force: no jump when the bit lifts off.
TEST(Formation, RateIsContinuousAtThresholdAndAtLiftOff)
{
  FormationLayer rock = main_job_rock();
  rock.threshold = 10e3;
  rock.weight_exponent = 0.5;
  const Vector3d axis = -Vector3d::UnitZ();
  EXPECT_LT(rock_breaking_velocity(rock, (10e3 + 1e-6) * axis, 14.0, axis, 0.1).norm(), 1e-3 * on_axis_rop(rock, 14.0, 70e3));
  rock.threshold = 0.0;
  const Vector3d side = 5e3 * Vector3d::UnitX();
  EXPECT_LT(rock_breaking_velocity(rock, side + 0.05 * axis, 14.0, axis, 0.1).norm(),
            1e-5 * rock_breaking_velocity(rock, side + 70e3 * axis, 14.0, axis, 0.1).norm());
}

TEST(Formation, NeverDrillsBackwards)
{
  FormationLayer rock = main_job_rock();
  rock.dip = 60.0 * degree;
  rock.anisotropy = 0.95;
  const Vector3d axis = -Vector3d::UnitZ();
  for (int k = 0; k < 360; k += 5)
    for (double side : {1e3, 2e4, 2e5})
    {
      const Vector3d force = 2e4 * axis + side * Vector3d(std::cos(k * degree), std::sin(k * degree), 0.0);
      EXPECT_GE(rock_breaking_velocity(rock, force, 14.0, axis, 1.0).dot(axis), -1e-18);
    }
}

TEST(Formation, SlopeIsTheDerivative)
{
  FormationLayer rock = main_job_rock();
  rock.threshold = 8e3;
  for (double alpha : {0.5, 1.0, 1.4, 3.0})
  {
    rock.weight_exponent = alpha;
    for (double weight : {9e3, 30e3, 120e3})
    {
      const double h = 0.1;
      const double difference = (on_axis_rop(rock, 11.0, weight + h) - on_axis_rop(rock, 11.0, weight - h)) / (2.0 * h);
      EXPECT_NEAR(on_axis_rop_slope(rock, 11.0, weight) / difference, 1.0, 1e-6);
    }
    EXPECT_EQ(on_axis_rop_slope(rock, 11.0, 7e3), 0.0);
    EXPECT_TRUE(std::isfinite(on_axis_rop_slope(rock, 11.0, 8e3 + 1e-12)));
  }
}

// Below an exponent of 1 the slope grows without end towards the threshold; it is held at its value 1 N above it. From 1 on it is
// not.
TEST(Formation, SlopeIsBoundedWithinANewtonOfTheThreshold)
{
  FormationLayer rock = main_job_rock();
  rock.threshold = 8e3;
  const double rate = 8.6e-9 * 14.0;  // of 1 N
  rock.weight_exponent = 0.5;
  EXPECT_NEAR(on_axis_rop_slope(rock, 14.0, 8e3 + 1e-3), 0.5 * rate, 1e-12 * rate);
  EXPECT_NEAR(on_axis_rop_slope(rock, 14.0, 8e3 + 4.0), 0.25 * rate, 1e-12 * rate);
  EXPECT_EQ(on_axis_rop_slope(rock, 14.0, 8e3), 0.0);
  EXPECT_EQ(on_axis_rop(rock, 14.0, 7e3), 0.0);
  EXPECT_NEAR(on_axis_rop(rock, 14.0, 8e3 + 0.25), 0.5 * rate, 1e-12 * rate);
  rock.weight_exponent = 1.0625;
  EXPECT_NEAR(on_axis_rop_slope(rock, 14.0, 8e3 + 1.0 / 65536.0), 1.0625 * 0.5 * rate, 1e-12 * rate);
}

// N^2/(N^2 + 0.05^2) below an exponent of 1, by hand; from 1 on the rate goes to nought by itself.
TEST(Formation, SlowTurningDrillsLess)
{
  FormationLayer rock = main_job_rock();
  EXPECT_NEAR(drilling_coefficient(rock, 0.05) / rock.drillability, 0.05, 1e-15);
  rock.speed_exponent = 0.0;
  EXPECT_NEAR(drilling_coefficient(rock, 0.05) / rock.drillability, 0.5, 1e-15);
  EXPECT_NEAR(drilling_coefficient(rock, 0.1) / rock.drillability, 0.8, 1e-15);
}

// Half a newton drills as half a newton does.
TEST(Formation, TheLeastWeightDrills)
{
  const FormationLayer rock = main_job_rock();
  const Vector3d axis = -Vector3d::UnitZ();
  EXPECT_NEAR(rock_breaking_velocity(rock, 0.5 * axis, 14.0, axis, 0.1).dot(axis), 8.6e-9 * 14.0 * 0.5, 1e-20);
}

// Wholly anisotropic rock is cut along its beds' normal alone.
TEST(Formation, FullAnisotropyCutsAcrossTheBeds)
{
  FormationLayer rock = main_job_rock();
  rock.dip = 30.0 * degree;
  rock.anisotropy = 1.0;
  const Vector3d axis = -Vector3d::UnitZ(), n = bed_normal(rock);
  EXPECT_LT((cutting_direction(rock, axis, 1.0, axis) + std::sqrt(0.75) * n).norm(), 1e-15);
}

TEST(Formation, LayersAreFoundByDepthAndRefusedOutOfOrder)
{
  FormationLayer soft = main_job_rock(), hard = main_job_rock();
  soft.to_tvd = 500.0;
  hard.to_tvd = 900.0;
  hard.drillability = 1e-9;
  const Formation formation({soft, hard});
  EXPECT_EQ(formation.at(-10.0).drillability, soft.drillability);
  EXPECT_EQ(formation.at(499.9).drillability, soft.drillability);
  EXPECT_EQ(formation.at(500.0).drillability, hard.drillability);
  EXPECT_EQ(formation.at(5000.0).drillability, hard.drillability);
  EXPECT_THROW(Formation({hard, soft}), std::invalid_argument);
  EXPECT_THROW(Formation({soft, soft}), std::invalid_argument) << "a layer of no thickness";
  FormationLayer back = hard;
  back.to_tvd = 800.0;
  try
  {
    Formation({soft, hard, back});
    FAIL();
  }
  catch (const std::invalid_argument& e)
  {
    EXPECT_STREQ("formation: layer 3 ends at tvd 800 m, it must end below the layer above (900 m)", e.what());
  }
  EXPECT_THROW(Formation({}), std::invalid_argument);
}
}  // namespace
}  // namespace drill_rig_sim::test_well_formation
