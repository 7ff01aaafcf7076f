// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>

#include "drilled_hole.h"

namespace
{
std::atomic<long> allocations{0};
}

// not inlined: GCC would pair the library's new with this free and warn
[[gnu::noinline]] void* operator new(std::size_t size)
{
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept
{
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept
{
  std::free(p);
}

namespace drill_rig_sim
{
namespace
{
using Eigen::Vector3d;

// What the bit drills is what the hole gains: 30 m straight, in displacements of uneven length.
TEST(WellExtension, LengthAndVolumeAreThoseDrilled)
{
  const Vector3d axis = tangent_from(0.9, 5.2);
  Wellbore hole(straight_well(500.0, 0.9, 5.2), every_metres(0.1), bit_radius);
  const int before = hole.node_count();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 2.0);
  double drilled = 0.0;
  while (drilled < 30.0)
  {
    const double step = advance * uniform(random);
    drilled += step;
    ASSERT_TRUE(hole.extend(step * axis, axis));
    ASSERT_NEAR(hole.hole_depth(), 500.0 + drilled, 1e-9);
  }
  EXPECT_NEAR(hole.drilled_path_length(), drilled, 1e-9);
  EXPECT_LT((hole.bottom_position() - hole.hole_depth() * axis).norm(), 1e-9);
  std::vector<Vector3d> path;
  hole.raw_path(path);
  EXPECT_EQ(path.back(), hole.bottom_position()) << "the path before its correction ends where the bit is";
  double volume = 0.0;
  for (int i = before; i < hole.node_count(); ++i)
    volume += pi * hole.node(i).radius * hole.node(i).radius * (hole.node(i).md - hole.node(i - 1).md);
  volume += pi * hole.bottom_radius() * hole.bottom_radius() * (hole.hole_depth() - hole.node(hole.node_count() - 1).md);
  EXPECT_NEAR(volume / (pi * bit_radius * bit_radius * drilled), 1.0, 1e-10);
  EXPECT_NEAR(hole.node_count() - before, drilled / 0.1, 1.0 + drilled / 0.1 * 2.0 * advance / 0.1);
}

// The drilled hole neither jumps nor turns suddenly, whatever the bit does: d turns by less than |displacement|/L2 a step.
TEST(WellExtension, FreshEndMovesContinuously)
{
  Wellbore hole(bohai_well(), every_metres(0.1), bit_radius);
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 50000; ++i)
  {
    const Vector3d d = hole.end_direction();
    const double depth = hole.hole_depth();
    const Vector3d displacement = advance * (d + 0.3 * Vector3d(normal(random), normal(random), normal(random)));
    hole.extend(displacement, d);
    ASSERT_LE((hole.end_direction() - d).norm(), 1.05 * displacement.norm() / 0.1) << i;
    ASSERT_LE(std::abs(hole.hole_depth() - depth), 1.05 * displacement.norm()) << i;
    // measured depth of the bottom is the hole's depth, on the very centre
    const ClosestPoint closest = hole.locate(hole.bottom_position(), hole.node_count());
    ASSERT_NEAR(closest.md, hole.hole_depth(), 1e-11);
    ASSERT_LT((closest.centre - hole.bottom_position()).norm(), 1e-11);
  }
  EXPECT_LE(hole.node_count(), Wellbore(bohai_well(), {}, bit_radius).node_count() + (hole.hole_depth() - 730.0) / 0.1 + 1.0);
}

TEST(WellExtension, SitesBelowTheLastNodeAreOnTheStraightEnd)
{
  Wellbore hole(bohai_well(), every_metres(0.1), bit_radius);
  HelixDriller bit(hole.end_direction(), pitch, helix_radius, advance);
  for (int i = 0; i < 13000; ++i) hole.extend(bit.next(), hole.end_direction());
  const WellNode last = hole.node(hole.node_count() - 1);
  const Vector3d d = hole.end_direction();
  Vector3d u, v;
  cross_section(d, u, v);
  for (double beyond : {0.01, 0.05, 0.4})
  {
    const Vector3d point = hole.bottom_position() + (last.md + beyond - hole.hole_depth()) * d + 0.1 * u;
    const ClosestPoint closest = hole.locate(point, -1);
    EXPECT_EQ(closest.segment, hole.node_count());
    EXPECT_NEAR(closest.md, last.md + beyond, 1e-10);
    EXPECT_LT((closest.tangent - d).norm(), 1e-15);
    EXPECT_LT((closest.md_gradient - d).norm(), 1e-15);
    EXPECT_EQ(closest.radius, bit_radius);
    EXPECT_LT((hole.at(last.md + beyond).position + 0.1 * u - point).norm(), 1e-10);
  }
  // where the permanent hole ends the line is within the helix' size of it
  EXPECT_LT((hole.at(last.md + 1e-12).position - last.position).norm(), 2.0 * helix_radius);
}

TEST(WellExtension, NoDisplacementOrBadNumbersChangeNothing)
{
  Wellbore hole(bohai_well(), every_metres(0.1), bit_radius);
  const Vector3d axis = hole.end_direction();
  HelixDriller bit(axis, pitch, helix_radius, advance);
  for (int i = 0; i < 5000; ++i) hole.extend(bit.next(), axis);
  const Wellbore before(hole);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(hole.extend(Vector3d::Zero(), axis));
  EXPECT_FALSE(hole.extend({nan, 0.0, 0.0}, axis));
  EXPECT_FALSE(hole.extend({0.0, -infinity, 0.0}, axis));
  EXPECT_FALSE(hole.extend({1e200, 1e200, 0.0}, axis));
  EXPECT_FALSE(hole.extend(advance * axis, {0.0, nan, 0.0}));
  EXPECT_FALSE(hole.extend(1.001e3 * axis, axis));
  EXPECT_FALSE(hole.extend({2e149, 0.0, 0.0}, axis));
  expect_identical(hole, before);
  // locate answers, whatever it is asked
  for (double bad : {nan, infinity, -infinity, 1e300})
    for (int hint : {-1, 0, 5, hole.node_count(), 1000000})
    {
      const int segment = hole.locate({bad, 1.0, -100.0}, hint).segment;
      EXPECT_GE(segment, 0);
      EXPECT_LE(segment, hole.node_count());
    }
}

// Saved in the middle of an interval, run on past the raw buffer's end, restored, run again: the same bits.
TEST(WellExtension, RestoredHoleGoesOnBitForBit)
{
  for (const TrajectorySpec& trajectory : {every_metres(0.1), every_steps(777)})
  {
    Wellbore hole(bohai_well(), trajectory, bit_radius);
    const Vector3d axis = hole.end_direction();
    HelixDriller bit(axis, pitch, helix_radius, 10.0 * advance);
    for (int i = 0; i < 25300; ++i) hole.extend(bit.next(), axis);
    const Wellbore saved(hole);
    const HelixDriller saved_bit = bit;
    for (int i = 0; i < 9000; ++i) hole.extend(bit.next(), axis);
    const Wellbore first(hole);

    hole = saved;
    bit = saved_bit;
    expect_identical(hole, saved);
    for (int i = 0; i < 9000; ++i) hole.extend(bit.next(), axis);
    expect_identical(hole, first);

    hole = saved;  // another course, then back again
    for (int i = 0; i < 9000; ++i) hole.extend(2.0 * advance * axis, axis);
    EXPECT_NE(hole.version(), first.version());
    hole = first;
    expect_identical(hole, first);
  }
}

// Holes that differ in one coordinate of one node are two versions.
TEST(WellExtension, VersionKnowsEachCoordinate)
{
  const Wellbore start(straight_well(100.0), every_metres(0.1), bit_radius);
  const Vector3d down(0.0, 0.0, -0.11);
  Wellbore hole(start);
  hole.extend(down, down.normalized());
  EXPECT_NE(hole.version(), start.version());
  for (int k = 0; k < 3; ++k)
  {
    Wellbore other(start);
    other.extend(down + 1e-3 * Vector3d::Unit(k), down.normalized());
    ASSERT_EQ(other.node_count(), hole.node_count());
    EXPECT_NE(other.version(), hole.version()) << k;
  }
}

TEST(WellExtension, NothingIsAllocatedInAFrame)
{
  Wellbore hole(bohai_well(), every_metres(0.1), bit_radius);
  const Vector3d axis = hole.end_direction();
  HelixDriller bit(axis, pitch, helix_radius, advance);
  Wellbore snapshot(hole);
  Wellbore other(snapshot);
  const long before = allocations;
  ClosestPoint closest;
  for (int i = 0; i < 1000000; ++i)
  {
    hole.extend(bit.next(), axis);
    if (i % 1000 == 0) closest = hole.locate(hole.bottom_position() - 0.2 * axis, closest.segment);
    if (i % 5000 == 0) snapshot = hole;
    if (i % 60000 == 0) other = hole;
    if (i == 700000) hole = snapshot;
  }
  other = snapshot;
  EXPECT_EQ(allocations, before);
  EXPECT_GT(hole.hole_depth(), 730.0 + 40.0);
}

// A bit that is never stopped: the room for nodes is shared out over ever longer intervals, and the hole goes on after that.
TEST(WellExtension, FullCapacityIsSaidAndSurvived)
{
  Wellbore hole(straight_well(100.0), every_metres(0.1), bit_radius, {}, 16);
  const int before = hole.node_count();
  const Vector3d axis = hole.end_direction();
  while (hole.hole_depth() < 100.75) hole.extend(advance * axis, axis);
  EXPECT_FALSE(hole.capacity_strained());
  while (hole.hole_depth() < 100.95) hole.extend(advance * axis, axis);
  EXPECT_TRUE(hole.capacity_strained());
  while (hole.hole_depth() < 120.0) hole.extend(advance * axis, axis);
  EXPECT_EQ(hole.node_count() - before, 16);
  const ClosestPoint closest = hole.locate(hole.bottom_position(), -1);
  EXPECT_NEAR(closest.md, hole.hole_depth(), 1e-9);
  EXPECT_LT((hole.at(115.0).position - 115.0 * axis).norm(), 1e-9);
  EXPECT_THROW(Wellbore(straight_well(100.0), every_metres(0.1), bit_radius, {}, 100), std::invalid_argument);
}

// The next section's friction holds for what is drilled in it; the diameter is the bit's.
TEST(WellExtension, FrictionFollowsTheSections)
{
  WellSpec spec = straight_well(100.0);
  spec.sections = {{100.5, 0.3112, 0.2}, {200.0, 0.3112, 0.3}};
  Wellbore hole(spec, every_metres(0.1), bit_radius);
  const Vector3d axis = hole.end_direction();
  while (hole.hole_depth() < 101.0) hole.extend(advance * axis, axis);
  EXPECT_NEAR(hole.at(100.3).friction, 0.2, 1e-12);
  EXPECT_NEAR(hole.at(100.8).friction, 0.3, 1e-12);
  EXPECT_EQ(hole.at(100.3).section, 0.0);
  EXPECT_EQ(hole.at(100.8).section, 1.0);
  EXPECT_EQ(hole.locate(100.3 * axis, -1).section, 0.0);
  EXPECT_EQ(hole.locate(100.99 * axis, -1).section, 1.0);
}

// Hole that is drilled in a layer with a friction of its own has that from node to node; elsewhere it has its section's.
TEST(WellExtension, FrictionFollowsTheRock)
{
  const double inclination = 60.0 * degree;  // 0.5 m TVD a metre
  WellSpec spec = straight_well(100.0, inclination);
  spec.sections = {{101.5, 0.3112, 0.2}, {200.0, 0.3112, 0.3}};
  std::vector<FormationLayer> rock(3);
  rock[0].to_tvd = 50.5;
  rock[0].friction = 0.25;
  rock[1].to_tvd = 51.0;
  rock[2].to_tvd = 1000.0;
  rock[2].friction = 0.35;
  Wellbore hole(spec, every_metres(0.1), bit_radius, rock);
  const Wellbore start = hole;
  const Vector3d axis = hole.end_direction();
  while (hole.hole_depth() < 103.0) hole.extend(advance * axis, axis);
  EXPECT_EQ(hole.at(99.0).friction, 0.2) << "hole that was there keeps its section's";
  EXPECT_EQ(hole.at(100.0).friction, 0.2);
  EXPECT_NEAR(hole.at(100.5).friction, 0.25, 1e-12);
  EXPECT_NEAR(hole.at(101.3).friction, 0.2, 1e-12);
  EXPECT_NEAR(hole.at(101.8).friction, 0.3, 1e-12);
  EXPECT_NEAR(hole.at(102.5).friction, 0.35, 1e-12);
  EXPECT_NEAR(hole.locate(102.5 * axis, -1).friction, 0.35, 1e-12);
  // from one value to the next along one interval, without a jump
  for (double md = 100.0; md < 102.9; md += 1e-3)
    ASSERT_LE(std::abs(hole.at(md + 1e-3).friction - hole.at(md).friction), 0.1 * 1.02e-2) << md;

  Wellbore again = start;
  while (again.hole_depth() < 103.0) again.extend(advance * axis, axis);
  expect_identical(again, hole);
}

// Rock does not grow back: the plane turns by no more than what is drilled over the bit's radius, so that its rim never rises.
// The bit of a string that is being wound up turns by 1e-150 rad/s before the torsional wave arrives; the squares of such moves
// underflow.
TEST(WellExtension, BottomTurnsNoFasterThanItRecedes)
{
  for (double length = 1e-320; length < 1e-3; length *= 3.0)
  {
    Wellbore hole(straight_well(100.0), every_metres(0.1), bit_radius);
    const Vector3d axis = hole.end_direction(), aside = axis.unitOrthogonal();
    EXPECT_TRUE(hole.extend(length * aside, axis));
    ASSERT_NEAR(hole.bottom_normal().norm(), 1.0, 1e-14) << length;
    ASSERT_LE(hole.bottom_normal().cross(axis).norm(), length / bit_radius + 1e-15) << length;
  }
}

// Drilled on in a new direction the plane ends square to it.
TEST(WellExtension, BottomTurnsIntoTheDirectionOfDrilling)
{
  Wellbore hole(straight_well(100.0), every_metres(0.1), bit_radius);
  const Vector3d axis = hole.end_direction();
  const Vector3d direction = (axis + 0.02 * axis.unitOrthogonal()).normalized();
  const int needed = static_cast<int>(std::ceil(0.02 * bit_radius / advance));
  for (int i = 0; i < needed; ++i)
  {
    ASSERT_NEAR(hole.bottom_normal().cross(axis).norm(), i * advance / bit_radius, 1e-5);
    hole.extend(advance * direction, axis);
  }
  EXPECT_LT((hole.bottom_normal() - direction).norm(), 1e-14);
}
}  // namespace
}  // namespace drill_rig_sim
