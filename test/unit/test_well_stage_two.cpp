// SPDX-License-Identifier: BSD-3-Clause
// The second correction of the drilled path: chords, the filter that they are, and what counts the interval.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>

#include "drilled_hole.h"

namespace drill_rig_sim::test_well_stage_two
{
namespace
{
using Eigen::Vector3d;

// Stage II: tangent along the chord, md grown by the chord's length, not by the path's.
TEST(StageTwo, StageTwoTakesTheChord)
{
  Wellbore hole(bohai_well(), every_metres(0.1), bit_radius);
  HelixDriller bit(hole.end_direction(), pitch, helix_radius, advance);
  const Vector3d axis = hole.end_direction();
  int committed = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const WellNode last = hole.node(hole.node_count() - 1);
    const int nodes = hole.node_count();
    hole.extend(bit.next(), axis);
    if (hole.node_count() == nodes) continue;
    ++committed;
    const WellNode node = hole.node(nodes);
    const Vector3d chord = node.position - last.position;
    ASSERT_EQ(node.position, hole.bottom_position());
    ASSERT_NEAR(node.md - last.md, chord.norm(), 1e-12);
    ASSERT_LT((node.tangent - chord.normalized()).norm(), 1e-14);
    ASSERT_GE(chord.norm(), 0.1);
    ASSERT_LT(chord.norm(), 0.1 + 1.1 * advance);
    ASSERT_EQ(node.radius, bit_radius);
    ASSERT_EQ(node.friction, 0.28);
  }
  EXPECT_EQ(committed, 8);
  // the path winds: (2 pi r/p)^2/2 = 1.67e-4 longer than the axis; the corrected length does not
  const double wound = hole.drilled_path_length() / (20000 * advance) - 1.0;
  EXPECT_NEAR(wound, 0.5 * std::pow(2.0 * pi * helix_radius / pitch, 2), 1e-6);
  EXPECT_NEAR((hole.hole_depth() - 730.0) / (20000 * advance), 1.0, 1e-6);
}

// The raw path swings by 2 pi r/p = 1.05 deg; the corrected one by at most 4 r/L2 = 0.07 deg, and the curve between too. The
// bottom's plane follows the raw path as fast as the bit can cut it: by 1 rad in a bit radius, on a circle of p/(2 pi R) = 0.60
// deg.
TEST(StageTwo, HelixBecomesSmooth)
{
  Wellbore hole(straight_well(500.0), every_metres(0.1), bit_radius);
  const Vector3d axis = hole.end_direction();
  HelixDriller bit(axis, pitch, helix_radius, advance);
  double raw_swing = 0.0, end_swing = 0.0, plane_swing = 0.0;
  for (int i = 0; i < 100000; ++i)
  {
    const Vector3d move = bit.next();
    hole.extend(move, axis);
    raw_swing = std::max(raw_swing, std::acos(std::min(1.0, move.normalized().dot(axis))));
    end_swing = std::max(end_swing, hole.end_direction().cross(axis).norm());
    if (i > 50000) plane_swing = std::max(plane_swing, hole.bottom_normal().cross(axis).norm());
  }
  EXPECT_NEAR(raw_swing / degree, std::atan(2.0 * pi * helix_radius / pitch) / degree, 1e-3);
  EXPECT_NEAR(plane_swing, pitch / (2.0 * pi * bit_radius), 0.01 * plane_swing);
  double corrected_swing = 0.0;
  for (const double md : depths(500.0, hole.hole_depth(), 1e-3))
    corrected_swing = std::max(corrected_swing, hole.at(md).tangent.cross(axis).norm());
  std::printf("swing: raw %.3f deg, corrected %.4f deg, newly drilled interval %.4f deg\n", raw_swing / degree,
              corrected_swing / degree, end_swing / degree);
  EXPECT_LT(corrected_swing, 4.0 * helix_radius / 0.1);
  EXPECT_LT(end_swing, 4.0 * helix_radius / 0.1);
}

// Complex amplitude of the drilled nodes' sideways position at wavelength w: twice the mean of (x - i y) e^{...} is r for a pure
// helix.
double amplitude(const Wellbore& hole, int from, double wavelength)
{
  std::complex<double> mean = 0.0, sum = 0.0;
  const int count = hole.node_count() - from;
  for (int i = from; i < hole.node_count(); ++i)
    mean += std::complex<double>(hole.node(i).position.x(), hole.node(i).position.y()) / static_cast<double>(count);
  for (int i = from; i < hole.node_count(); ++i)
  {
    const std::complex<double> z(hole.node(i).position.x(), hole.node(i).position.y());
    sum += (z - mean) * std::polar(1.0, 2.0 * pi * hole.node(i).md / wavelength);
  }
  return std::abs(sum) / count;
}

// Sampled every L2 = 0.1 m, 10.3 mm of pitch are 9.709 turns: the nodes see -0.291 turns and draw a helix of pitch 0.343 m, the
// "much longer thread pitch". Sampled at ten pitches they see none.
TEST(StageTwo, LongHelixIsTheAliasOfTheShortOne)
{
  const double exact_advance = pitch / 256.0;
  const auto drill = [&](double interval)
  {
    Wellbore hole(straight_well(500.0), every_metres(interval), bit_radius);
    HelixDriller bit(hole.end_direction(), pitch, helix_radius, exact_advance);
    for (int i = 0; i < 500000; ++i) hole.extend(bit.next(), -Vector3d::UnitZ());
    return hole;
  };
  const Wellbore aliased = drill(0.1);
  const int first = aliased.node_count() - 190;
  const double interval = (aliased.node(aliased.node_count() - 1).md - aliased.node(first).md) / 189.0;
  const double turns = interval / pitch - std::round(interval / pitch);
  const double long_pitch = interval / std::abs(turns);
  const double in = std::max(amplitude(aliased, first, long_pitch), amplitude(aliased, first, -long_pitch));
  std::printf("aliased pitch %.4f m, amplitude %.2f um\n", long_pitch, 1e6 * in);
  EXPECT_NEAR(long_pitch, 0.343, 0.01);
  EXPECT_NEAR(in, helix_radius, 0.02 * helix_radius);

  const Wellbore matched = drill(10.0 * pitch - 1e-9);
  double spread = 0.0;
  const Vector3d reference = matched.node(matched.node_count() - 1).position;
  for (int i = matched.node_count() - 150; i < matched.node_count(); ++i)
    spread = std::max(spread, (matched.node(i).position - reference).head<2>().norm());
  EXPECT_LT(spread, 0.01 * helix_radius);
}

// Counted in drilled length the filter does not know the step size; counted in steps it does.
TEST(StageTwo, CountingStepsTiesTheFilterToTheStep)
{
  const auto nodes_per_metre = [](const TrajectorySpec& trajectory, double step)
  {
    Wellbore hole(straight_well(500.0), trajectory, bit_radius);
    const int before = hole.node_count();
    HelixDriller bit(hole.end_direction(), pitch, helix_radius, step);
    while (hole.hole_depth() < 502.0) hole.extend(bit.next(), -Vector3d::UnitZ());
    return 0.5 * (hole.node_count() - before);
  };
  EXPECT_NEAR(nodes_per_metre(every_metres(0.1), advance), 10.0, 0.6);
  EXPECT_NEAR(nodes_per_metre(every_metres(0.1), 0.4 * advance), 10.0, 0.6);
  EXPECT_NEAR(nodes_per_metre(every_steps(1000), advance), 1.0 / (1000 * advance), 0.6);
  EXPECT_NEAR(nodes_per_metre(every_steps(1000), 0.4 * advance), 1.0 / (400 * advance), 0.6);
  // a crawling bit: an interval waits for a millimetre of chord
  EXPECT_LE(nodes_per_metre(every_steps(10), 2e-6), 1000.0);
}

// Where steps are counted the length has no say, not in the first interval either.
TEST(StageTwo, CountedStepsLeaveTheLengthAside)
{
  const Vector3d axis = tangent_from(0.9, 5.2);
  Wellbore hole(straight_well(500.0, 0.9, 5.2), {0.1, 5}, bit_radius),
      other(straight_well(500.0, 0.9, 5.2), {7.0, 5}, bit_radius);
  const Vector3d aside = 1e-3 * (axis + 0.2 * Vector3d::UnitZ()).normalized();
  for (int k = 0; k < 12; ++k)
  {
    ASSERT_TRUE(hole.extend(aside, axis) && other.extend(aside, axis));
    expect_identical(hole, other);
  }
}
}  // namespace
}  // namespace drill_rig_sim::test_well_stage_two
