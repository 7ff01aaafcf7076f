// SPDX-License-Identifier: BSD-3-Clause
// What is shown along the string, by hand: forces of given elements, sides of given places, bending of a given arc, poses of
// parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/sim/profile.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/solve/methods/method.h"
#include "drill_rig_sim/solve/start.h"
#include "test_scenes.h"

namespace test_sim_profile
{
using namespace drill_rig_sim;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
/// Along the slanted hole, across it upwards, and to the right looking down it.
const Vector3d down_hole(std::sin(slant) * std::sin(slant_azimuth), std::sin(slant) * std::cos(slant_azimuth), -std::cos(slant));
const Vector3d high(std::cos(slant) * std::sin(slant_azimuth), std::cos(slant) * std::cos(slant_azimuth), std::sin(slant));
const Vector3d right(std::cos(slant_azimuth), -std::sin(slant_azimuth), 0.0);

/// Collars and pipe in the slanted hole, 100 m of it.
Scene slanted_string()
{
  Scene scene = slanted_scene(100.0, 0.2);
  scene.string.insert(scene.string.begin() + 1, collar_part(2, 9.4));
  return scene;
}

/// Forces that tell the elements apart.
RigForces numbered_forces(const Model& model)
{
  RigForces forces = Workspace(model).result.forces;
  for (int e = 0; e < model.elements(); ++e)
  {
    forces.tension[e] = 1000.0 * (e + 1);
    forces.torque[e] = 10.0 * e * e;
  }
  for (int i = 0; i < model.nodes(); ++i)
  {
    forces.bending_moment[i] = 7.0 * i;
    forces.wall[i] = Vector3d(i, -i, 0.5 * i);
  }
  return forces;
}
}  // namespace

// A string that hangs free carries at each place what hangs below it, whatever the mesh.
TEST(Profile, tensionIsTheWeightBelow)
{
  for (const double element_length : {9.5, 2.0})
  {
    Scene scene = vertical_scene(200.0, 150.0);
    scene.string = {bit_part(0.2159), collar_part(2, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
    scene.numerics.element_length = element_length;
    const StaticReport report = static_report(scene, no_sliding);
    const StringProfile& p = report.profile;
    const RigAtRest rig = build_at_rest(scene);
    double below = standard_gravity * (rig.model->mesh().bit_mass - scene.mud.density * rig.model->mesh().bit_displaced);
    EXPECT_GT(below, 100.0);
    for (std::size_t i = 0; i < p.tension.size(); ++i)
    {
      EXPECT_NEAR(below, p.tension[i], 1.0) << i << " at " << element_length;
      const double lower = p.position[i].z();
      if (i + 1 < p.tension.size())
        below += rig.model->element_weight(static_cast<int>(i), lower, p.position[i + 1].z(), full_bore);
    }
    EXPECT_NEAR(report.hook_load_string, p.tension.back(), 1.0);
  }
}

// A node shows the mean of the elements that meet there, tension less or more their weight between the middle and the end; the
// ends show theirs.
TEST(Profile, forcesAreMeansOfTheElementsThatMeet)
{
  RigAtRest rig = build_at_rest(slanted_string());
  const RigForces forces = numbered_forces(*rig.model);
  for (std::size_t i = 0; i < rig.state.nodes.size(); ++i) rig.state.nodes[i].rate.spin = 0.1 * i;
  StringProfile p;
  fill_profile(*rig.model, rig.state, forces, p);
  const int n = rig.model->nodes();
  ASSERT_EQ(p.tension.size(), static_cast<std::size_t>(n));
  const auto rise = [&](int e)  // half of an element's weight along it
  {
    const double lower = p.position[e].z(), upper = p.position[e + 1].z();
    return 0.5 * rig.model->element_weight(e, lower, upper, full_bore) * (upper - lower) /
           rig.model->mesh().elements[e].section.length;
  };
  EXPECT_GT(rise(0), 50.0);
  EXPECT_DOUBLE_EQ(p.tension.front(), 1000.0 - rise(0));
  EXPECT_DOUBLE_EQ(p.tension.back(), 1000.0 * (n - 1) + rise(n - 2));
  EXPECT_EQ(p.torque.front(), 0.0);
  EXPECT_EQ(p.torque.back(), 10.0 * (n - 2) * (n - 2));
  for (int i = 1; i + 1 < n; ++i)
  {
    EXPECT_NEAR(p.tension[i], 1000.0 * (i + 0.5) + 0.5 * (rise(i - 1) - rise(i)), 1e-9 * p.tension[i]);
    EXPECT_DOUBLE_EQ(p.torque[i], 5.0 * ((i - 1) * (i - 1) + i * i));
  }
  for (int i = 0; i < n; ++i)
  {
    EXPECT_EQ(p.bending_moment[i], 7.0 * i);
    EXPECT_EQ(p.contact_vector[i], Vector3d(i, -i, 0.5 * i));
    EXPECT_EQ(p.spin_speed[i], 0.1 * i);
    EXPECT_EQ(p.position[i], rig.state.nodes[i].position);
    EXPECT_NEAR(p.md[i], down_hole.dot(p.position[i]), p.position[i].z() < 0.0 ? 1e-6 : 5.0)
        << "above the table the string hangs plumb";
  }
  EXPECT_NEAR(p.from_bit.front(), 0.5 * 0.2159, 1e-12);
  EXPECT_NEAR(p.from_bit.back(), 120.0, 0.3)
      << "100 m of hole and 20 m of air, less what the way over the kink at the table saves";
}

// The mud's pressure pushes on the steel's section: effective tension less rho g depth (A_o - A_i); none above the table. The
// node between two sections shows that of the upper one.
TEST(Profile, trueAxialForceLacksTheMudsPressure)
{
  const Scene scene = slanted_string();
  RigAtRest rig = build_at_rest(scene);
  StringProfile p;
  fill_profile(*rig.model, rig.state, numbered_forces(*rig.model), p);
  const double collar_area = pi / 4.0 * (0.165 * 0.165 - 0.0714 * 0.0714);
  int in_air = 0;
  for (int i = 0; i < rig.model->nodes(); ++i)
  {
    const bool collar = p.from_bit[i] < 0.3 + 18.8 - 1e-6;
    const double depth = -p.position[i].z(), area = collar ? collar_area : pipe_area;
    const double push = depth > 0.0 ? scene.mud.density * standard_gravity * depth * area : 0.0;
    EXPECT_NEAR(p.true_axial_force[i], p.tension[i] - push, 1e-6) << i;
    EXPECT_EQ(p.radius[i], collar ? 0.0825 : 0.5 * pipe_outer) << i;
    in_air += depth < 0.0;
  }
  EXPECT_GT(in_air, 1);
  // Archimedes: the bottom of a free string is pushed by the pressure there
  EXPECT_LT(p.true_axial_force[0], 1000.0 - 0.9 * 1150.0 * standard_gravity * 94.0 * collar_area);
}

// Bending stress M D / (2 I) of the weaker of the elements that meet, and compression over the critical buckling load of the
// worse.
TEST(Profile, stressAndBucklingAreThoseOfTheWorseElement)
{
  RigAtRest rig = build_at_rest(slanted_string());
  RigForces forces = numbered_forces(*rig.model);
  const int n = rig.model->nodes();
  for (int e = 0; e + 1 < n; ++e) forces.tension[e] *= e == 5 ? 1.0 : -1.0;  // one element is not compressed
  rig.state.nodes[3].guided = true;
  StringProfile p;
  fill_profile(*rig.model, rig.state, forces, p);
  const auto resistance = [](double outer, double inner)
  { return pi / 32.0 * (std::pow(outer, 4) - std::pow(inner, 4)) / outer; };
  const auto share = [&](int e)
  { return e == 5 ? 0.0 : buckling_share(*rig.model, rig.state, static_cast<std::size_t>(e), -1000.0 * (e + 1)); };
  for (int i = 1; i + 1 < n; ++i)
  {
    const bool collar = p.from_bit[i] < 0.3 + 18.8 - 1e-6;
    const double expected = 7.0 * i / (collar ? resistance(0.165, 0.0714) : resistance(pipe_outer, pipe_inner));
    EXPECT_NEAR(expected, p.bending_stress[i], 1e-6 * expected) << i;
    EXPECT_DOUBLE_EQ(std::max(share(i - 1), share(i)), p.buckling[i]) << i;
    EXPECT_EQ(i == 3 ? 1 : 0, p.guided[i]) << i;
  }
  EXPECT_DOUBLE_EQ(share(0), p.buckling[0]);
  EXPECT_DOUBLE_EQ(share(n - 2), p.buckling[n - 1]);
}

// Nodes put on given sides of the hole: clockwise from the high side looking down; 0 without contact.
TEST(Profile, contactSideIsClockwiseFromTheHighSide)
{
  RigAtRest rig = build_at_rest(slanted_string());
  RigForces forces = numbered_forces(*rig.model);
  const double sides[] = {0.0, 0.5, 1.5, 3.0, -0.5, -1.5, -3.0};
  for (int i = 0; i < 7; ++i)
  {
    const double md = 99.0 - rig.model->mesh().nodes[i].from_bit;
    rig.state.nodes[i].position = md * down_hole + 0.005 * (std::cos(sides[i]) * high + std::sin(sides[i]) * right);
    forces.contact[i] = 100.0 + i;
  }
  StringProfile p;
  fill_profile(*rig.model, rig.state, forces, p);
  for (int i = 0; i < 7; ++i)
  {
    EXPECT_NEAR(p.contact_side[i], sides[i], 1e-6);
    EXPECT_EQ(p.contact_force[i], 100.0 + i);
  }
  EXPECT_EQ(p.contact_side[7], 0.0);
}

// What touches between the nodes is half of each node beside it.
TEST(Profile, contactBetweenTheNodesIsOfBothByHalves)
{
  const RigAtRest rig = build_at_rest(slanted_string());
  RigForces forces = numbered_forces(*rig.model);
  const std::size_t elements = rig.model->mesh().elements.size();
  forces.contact.assign(elements + 1, 1.0);
  forces.wall.assign(elements + 1, Vector3d(1.0, 0.0, 0.0));
  forces.span_contact.assign(elements, 0.0);
  forces.span_wall.assign(elements, Vector3d::Zero());
  forces.span_contact[3] = 50.0;
  forces.span_wall[3] = Vector3d(30.0, 40.0, 0.0);
  StringProfile p;
  fill_profile(*rig.model, rig.state, forces, p);
  for (std::size_t i = 0; i < p.md.size(); ++i)
  {
    const bool beside = i == 3 || i == 4;
    EXPECT_EQ(p.contact_force[i], beside ? 26.0 : 1.0) << i;
    EXPECT_EQ(p.contact_vector[i], beside ? Vector3d(16.0, 20.0, 0.0) : Vector3d(1.0, 0.0, 0.0)) << i;
  }
}

// At rest the string lies on the low side, and what the wall carries there is the weight across the hole.
TEST(Profile, atRestTheWallCarriesTheWeightAcrossTheHole)
{
  Scene scene = slanted_string();
  scene.numerics.element_length = 9.5;  // nodes are tool joints
  Simulator rig(scene);
  StringProfile p;
  rig.profile(p);
  double carried = 0.0;
  for (std::size_t i = 3; i < 7; ++i)  // away from collars and table
  {
    ASSERT_GT(p.contact_force[i], 0.0);
    EXPECT_NEAR(std::abs(p.contact_side[i]), pi, 1e-6);
    EXPECT_NEAR((p.contact_vector[i] - p.contact_force[i] * high).norm(), 0.0, 1e-3 * p.contact_force[i]);
    carried += p.contact_force[i] / 4.0;
  }
  const double weight = standard_gravity * tool_jointed_mass * (1.0 - 1150.0 / steel_density) * std::sin(slant) * 9.5;
  EXPECT_NEAR(carried, weight, 0.03 * weight);
}

// Sections along a circle of 500 m: moment E I/R, at every node with an element below it; the twist of a helix by hand: G J times
// twist over length. Second order in element over radius: 1e-4.
TEST(StringForces, ofAnArcAreThoseOfItsCurvature)
{
  RigAtRest rig = build_at_rest(vertical_scene(400.0, 200.0));
  constexpr double radius = 500.0, twist = 2e-3;  // [m], [rad] between nodes
  const Mesh& mesh = rig.model->mesh();
  for (int i = 0; i < rig.model->nodes(); ++i)
  {
    const double angle = (mesh.nodes.back().from_bit - mesh.nodes[i].from_bit) / radius;
    NodeState& node = rig.state.nodes[i];
    node.position = radius * Vector3d(1.0 - std::cos(angle), 0.0, -std::sin(angle));
    const Quaterniond plumb = shortest_turn(Vector3d::UnitX(), -Vector3d::UnitZ());
    const Vector3d tangent(std::sin(angle), 0.0, -std::cos(angle));
    node.orientation =
        Quaterniond(Eigen::AngleAxisd(-twist * i, tangent)) * Quaterniond(Eigen::AngleAxisd(-angle, Vector3d::UnitY())) * plumb;
  }
  Stage stage(*rig.model);
  Workspace work(*rig.model);
  begin_step(*rig.model, rig.state, 0.0, Setpoints(), stage);
  prepare_start(rig.state, stage);
  for (std::size_t e = 0; e < stage.rate.size(); ++e) stage.load.set(e, Vector3d::Zero());
  const std::vector<double> u(6 * mesh.nodes.size(), 0.0);
  update(*rig.model, rig.state, stage, u.data(), work);
  find_string_forces(*rig.model, rig.state, stage, work);
  const double polar = pi / 32.0 * (std::pow(pipe_outer, 4) - std::pow(pipe_inner, 4)), moment = 206e9 * 0.5 * polar / radius;
  for (int e = 1; e < rig.model->elements(); ++e)
  {
    const double torque = 206e9 / 2.6 * polar * twist / mesh.elements[e].section.length;
    EXPECT_NEAR(work.result.forces.bending_moment[e + 1], moment, 1e-3 * moment) << e;
    EXPECT_NEAR(work.result.forces.torque[e], -torque, 2e-2 * torque)
        << "the lower end is ahead: the string above drives it back, " << e;
  }
}

// Parts of the assembly by name at their lower ends, joints of pipe by number, every third; x towards the bit, the bit as it has
// turned.
TEST(PartPoses, areAtTheLowerEndsOfTheParts)
{
  Scene scene = motor_drilling_scene(10.0);
  scene.string[1].motor->bend = 0.0;
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.03});
  for (int k = 0; k < 37; ++k) ASSERT_EQ(rig.frame(0.01), FrameStatus::running);
  std::vector<PartPose> poses;
  rig.part_poses(3, poses);
  const std::vector<std::string> names = {"bit", "motor", "collar", "pipe_0", "pipe_3", "pipe_6", "pipe_9"};
  const double below[] = {0.0, 0.3, 8.6, 27.4, 27.4 + 28.5, 27.4 + 57.0, 27.4 + 85.5};  // from the bit's face [m]
  std::vector<std::string> shown;
  for (const PartPose& pose : poses) shown.push_back(pose.name);
  ASSERT_EQ(shown, std::vector<std::string>(names.begin(), names.begin() + shown.size()));
  ASSERT_GE(shown.size(), 6u);
  for (std::size_t k = 0; k < poses.size(); ++k)
  {
    EXPECT_NEAR(poses[k].position.z(), -90.0 + below[k], 0.01) << poses[k].name;  // less a stretch of millimetres
    EXPECT_LT(poses[k].position.head<2>().norm(), 1e-3);
    EXPECT_NEAR((poses[k].orientation * Vector3d::UnitX()).z(), -1.0, 1e-6) << poses[k].name;
  }
  EXPECT_LT((poses[0].orientation.toRotationMatrix() - rig.truth().bit_orientation.toRotationMatrix()).norm(), 1e-12);
  const Quaterniond between = poses[0].orientation * poses[1].orientation.conjugate();
  EXPECT_GT(2.0 * std::acos(std::min(1.0, std::abs(between.w()))), 0.1) << "the motor has turned the bit against its housing";
  rig.part_poses(1, poses);
  ASSERT_GT(poses.size(), 9u);
  EXPECT_EQ(poses[4].name, "pipe_1");
  EXPECT_NEAR(poses[4].position.z() - poses[3].position.z(), 9.5, 1e-3);
}
}  // namespace test_sim_profile
