// SPDX-License-Identifier: BSD-3-Clause
// Stiff collars run through the rotary table into a hole that bends away under it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/model/mast.h"
#include "drill_rig_sim/sim/profile.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/well/tie_in.h"
#include "test_scenes.h"

namespace test_sim_shallow_bend
{
using namespace drill_rig_sim;

namespace
{
constexpr double frame = 0.01;                                   // [s]
constexpr double hole = 0.3112, outer = 0.2032, inner = 0.0714;  // 12 1/4 in; 8 in collars
constexpr double bend_radius = 30.0 / (14.0 * degree);           // 14 deg/30 m, about the sharpest that a tie-in may be
constexpr double inclined = 30.0 * degree;

/// Tied in where the hole is inclined by 30 deg: an arc begins at the table. The 35 m of collars are the string's lower end.
Scene shallow_bend(double bit_depth, double block_height)
{
  const double end = bend_radius * inclined;
  std::vector<SurveyStation> survey{{end, inclined, 0.0}, {end + 200.0, inclined, 0.0}};
  const std::string wrong =
      tie_survey_in({bend_radius * (1.0 - std::cos(inclined)), 0.0, bend_radius * std::sin(inclined)}, survey);
  EXPECT_EQ(wrong, "");
  Scene scene = scene_in(survey, end + 200.0, bit_depth, 0.25);
  scene.well.sections = {{end + 200.0, hole, 0.25}};
  PartSpec collars = collar_part(4, 8.75);
  collars.outer_diameter = outer;
  collars.inner_diameter = inner;
  collars.linear_mass = 220.0;
  scene.string = {bit_part(hole), collars, pipe_part(0, 9.5, tool_jointed_mass)};
  scene.start.block_height = block_height;
  return scene;
}

/// Farthest from the axis that pipe above the table is, and what it has of the mast's inside there: at most 1.
struct Above
{
  double farthest = 0.0;  // [m]
  double share = 0.0;
};

Above above_table(const StringProfile& profile)
{
  Above out;
  for (std::size_t i = 0; i < profile.position.size(); ++i)
  {
    const Eigen::Vector3d& p = profile.position[i];
    if (p.z() <= 0.0) continue;
    const double aside = std::hypot(p.x(), p.y()),
                 inside = std::min(0.5 * hole + mast_opening * p.z(), mast_radius) - profile.radius[i];
    out.farthest = std::max(out.farthest, aside);
    out.share = std::max(out.share, aside / inside);
  }
  return out;
}
}  // namespace

// Bent to the hole's radius R the collars bear EI/R. Towards the bit, on the hole's axis, that dies away in a straight line over
// the length l in which they come off the wall, c from the axis: c = l^2/(6 R). The bit carries EI/(R l), and towards the outside
// of the bend; less the weight's share there, which pushes to the same side, w sin(inclination) l/2.
TEST(ShallowBend, bitCarriesWhatStraightensTheCollars)
{
  const StaticReport report = static_report(shallow_bend(55.0, 15.0), no_sliding);
  ASSERT_TRUE(report.outcome.converged);
  const double stiffness = 206e9 * pi / 64.0 * (std::pow(outer, 4) - std::pow(inner, 4));
  const double clearance = 0.5 * (hole - outer), length = std::sqrt(6.0 * bend_radius * clearance);
  const double weight = (220.0 - 1150.0 * pi / 4.0 * (outer * outer - inner * inner)) * standard_gravity;
  const double expected = stiffness / (bend_radius * length) + 0.5 * weight * length * std::sin(50.0 / bend_radius);
  EXPECT_NEAR(report.bit_side_force, expected, 0.2 * expected);
  EXPECT_NEAR(std::abs(report.bit_side_direction), pi, 0.2) << "the low side";
  const auto most = std::max_element(report.profile.bending_moment.begin(), report.profile.bending_moment.end());
  EXPECT_NEAR(*most, stiffness / bend_radius, 0.25 * stiffness / bend_radius);
}

// Stand by stand, as far as the block comes down each time: the collars at the table, in it, under it; then out again. All is
// bent and pressed, and stays within the hole and the mast.
TEST(ShallowBend, collarsRunThroughTheTable)
{
  for (const double begin : {8.0, 36.0})
  {
    Simulator rig(shallow_bend(begin, 30.0));
    StringProfile profile;
    double most = 0.0, aside = 0.0;
    for (const double up : {-0.5, 0.5})
    {
      rig.command(WinchSetpoint{up, false});
      for (int k = 0; k < 5600; ++k)
      {
        ASSERT_EQ(rig.frame(frame), FrameStatus::running) << begin << " m: " << rig.failure();
        if (k % 20 != 0) continue;
        rig.profile(profile);
        most = std::max(most, *std::max_element(profile.contact_force.begin(), profile.contact_force.end()));
        const Above above = above_table(profile);
        ASSERT_LT(above.share, 1.05) << begin << " m, bit at " << rig.truth().bit_depth;
        aside = std::max(aside, above.farthest);
      }
    }
    EXPECT_FALSE(rig.truth().slack_line) << begin;
    EXPECT_EQ(rig.statistics().convergence_failures, 0) << begin;
    EXPECT_GT(most, 5e3) << "the collars are bent";
    EXPECT_LT(most, 40e3) << "by the hole, not by a jam: 24 kN at the bit by hand";
    EXPECT_GT(aside, 0.05) << "they lean, the table's guides open upwards";
    EXPECT_LT(aside, 0.5);
  }
}
}  // namespace test_sim_shallow_bend
