// SPDX-License-Identifier: BSD-3-Clause
// The string as nodes and elements: lengths, masses, joints, special places, and strings that do not fit.
#include <gtest/gtest.h>

#include <stdexcept>

#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/string/string_checks.h"
#include "test_scenes.h"

namespace test_string_mesh
{
using namespace drill_rig_sim;

namespace
{
PartSpec stabilizer()
{
  PartSpec part = collar_part(1, 1.8);
  part.name = "stabilizer";
  part.type = PartType::stabilizer;
  part.length = 1.8;
  part.stabilizer.emplace();
  part.stabilizer->blade_diameter = 0.212;
  return part;
}

/// Bit, motor, stabiliser, two collars, pipe.
Scene assembly()
{
  Scene scene = vertical_scene(500.0, 300.0);
  scene.string = {bit_part(0.2159), motor_part(), stabilizer(), collar_part(2, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
  return scene;
}

double total_mass(const Mesh& mesh)
{
  double mass = 0.0;
  for (const MeshNode& node : mesh.nodes) mass += node.mass;
  return mass;
}

std::string refusal(const Scene& scene, double length)
{
  try
  {
    build_mesh(scene, length);
  }
  catch (const std::runtime_error& e)
  {
    return e.what();
  }
  return "";
}
}  // namespace

TEST(Mesh, carriesAllOfTheStringsLengthAndMass)
{
  const Scene scene = assembly();
  for (double length : {100.0, 320.0, 321.7, 330.01})
  {
    const Mesh mesh = build_mesh(scene, length);
    ASSERT_EQ(mesh.nodes.size(), mesh.elements.size() + 1);
    EXPECT_NEAR(mesh.nodes.front().from_bit, 0.5 * 0.2159, 1e-12);
    EXPECT_NEAR(mesh.nodes.back().from_bit, length, 1e-9);
    const double pipe = length - 0.3 - 8.3 - 1.8 - 18.8;
    const double mass = 40.0 + (8.3 + 1.8 + 18.8) * 136.0 + pipe * tool_jointed_mass;
    EXPECT_NEAR(total_mass(mesh), mass, 1e-9 * mass);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    {
      EXPECT_NEAR(mesh.elements[e].section.length, mesh.nodes[e + 1].from_bit - mesh.nodes[e].from_bit, 1e-9);
      EXPECT_LE(mesh.elements[e].section.length, element_lengths(scene).at(mesh.nodes[e].from_bit) + 0.5);
      EXPECT_NEAR(mesh.elements[e].displaced, mesh.elements[e].linear_mass / steel_density, 1e-12);
    }
  }
}

// Sleeve below the bend or above it: both are nodes, and the wall is stiff under them.
TEST(Mesh, aMotorsSleeveIsANode)
{
  for (const double at : {1.0, 3.5})
  {
    Scene scene = assembly();
    scene.string[1].motor->sleeve_diameter = 0.2142;
    scene.string[1].motor->bit_to_sleeve = at;
    const Mesh mesh = build_mesh(scene, 320.0);
    ASSERT_GE(mesh.bend_node, 0);
    EXPECT_NEAR(mesh.nodes[mesh.bend_node].from_bit, 2.0, 1e-9);
    int sleeves = 0;
    for (const MeshNode& node : mesh.nodes)
    {
      if (node.contact_radius != 0.1071) continue;
      ++sleeves;
      EXPECT_NEAR(node.from_bit, at, 1e-9);
      EXPECT_EQ(node.contact.stiffness, scene.contact.assembly_stiffness);
      EXPECT_EQ(node.squeeze_film_damping, 5e4);
    }
    EXPECT_EQ(sleeves, 1);
  }
}

TEST(Mesh, putsANodeWhereTheGaugePadsEnd)
{
  Scene scene = assembly();
  const Mesh ball = build_mesh(scene, 320.0);
  EXPECT_EQ(ball.gauge_nodes, 1);
  BitSpec& bit = *scene.string[0].bit;
  bit.gauge_length = 0.15;
  bit.gauge_clearance = 3e-4;
  scene.string[1].friction_radius = 0.05;
  const Mesh mesh = build_mesh(scene, 320.0);
  ASSERT_EQ(mesh.gauge_nodes, 2);
  EXPECT_EQ(mesh.nodes.size(), ball.nodes.size() + 1);
  const MeshNode &lower = mesh.nodes[0], &upper = mesh.nodes[1];
  EXPECT_NEAR(upper.from_bit - lower.from_bit, 0.15, 1e-15);
  EXPECT_NEAR(upper.contact_radius, 0.5 * 0.2159 - 3e-4, 1e-15);
  EXPECT_EQ(upper.contact.stiffness, lower.contact.stiffness);
  EXPECT_EQ(upper.friction_radius, 0.0) << "not that of the part above";
  EXPECT_EQ(lower.squeeze_film_damping + upper.squeeze_film_damping, bit.squeeze_film_damping);
  EXPECT_EQ(mesh.elements[0].linear_mass, 0.0) << "the bit's mass is all at its centre";
  EXPECT_NEAR(total_mass(mesh), total_mass(ball), 1e-9 * total_mass(ball));
}

TEST(Mesh, putsNodesWhereTheStringIsSpecial)
{
  const Scene scene = assembly();
  const Mesh mesh = build_mesh(scene, 320.0);
  ASSERT_GE(mesh.bend_node, 0);
  EXPECT_NEAR(mesh.nodes[mesh.bend_node].from_bit, 2.0, 1e-9);
  EXPECT_EQ(mesh.elements[mesh.bend_node - 1].bend, 1.25 * degree);
  int blades = 0, bends = 0;
  for (const MeshNode& node : mesh.nodes)
  {
    if (node.contact_radius != 0.106) continue;
    ++blades;
    EXPECT_NEAR(node.from_bit, 0.3 + 8.3 + 0.9, 1e-9) << "blades in the middle";
    EXPECT_GT(node.squeeze_film_damping, 0.0);
  }
  for (const MeshElement& e : mesh.elements) bends += e.bend != 0.0;
  EXPECT_EQ(blades, 1);
  EXPECT_EQ(bends, 1);
  // pipe leans on its tool joints, where it meets the collar on the larger of the two
  EXPECT_EQ(mesh.nodes.back().contact_radius, 0.084);
  for (const MeshNode& node : mesh.nodes)
    if (std::abs(node.from_bit - 29.2) < 1e-9)
    {
      EXPECT_EQ(node.contact_radius, 0.084);
    }
}

// A lever is the part's own; where two parts meet, that of the one that touches.
TEST(Mesh, knowsTheLeverOfFriction)
{
  Scene scene = assembly();
  const Mesh usual = build_mesh(scene, 320.0);
  for (const MeshNode& node : usual.nodes) EXPECT_EQ(node.friction_radius, 0.0);
  scene.string.back().friction_radius = 0.05;
  scene.string[1].friction_radius = 0.03;
  const Mesh mesh = build_mesh(scene, 320.0);
  const int pipe = static_cast<int>(scene.string.size()) - 1;
  for (std::size_t i = 1; i < mesh.nodes.size(); ++i)
  {
    const MeshNode& node = mesh.nodes[i];
    const bool pipes =
        node.part == pipe || std::abs(node.from_bit - mesh.part_bottom[pipe]) < 1e-9;  // its tool joint is the wider
    EXPECT_EQ(node.friction_radius, pipes ? 0.05 : node.part == 1 ? 0.03 : 0.0) << i;
    EXPECT_EQ(mesh.elements[i - 1].friction_radius, node.part == pipe ? 0.05 : node.part == 1 ? 0.03 : 0.0) << i;
  }
}

// The tube's own stiffness, given outright, makes the same mesh; another one is another section's.
TEST(Mesh, takesSectionsByTheirStiffness)
{
  const Scene scene = assembly();
  const PartSpec& pipe = scene.string.back();
  const double area = 0.25 * pi * (std::pow(pipe.outer_diameter, 2) - std::pow(pipe.inner_diameter, 2));
  const double inertia = pi / 64.0 * (std::pow(pipe.outer_diameter, 4) - std::pow(pipe.inner_diameter, 4));
  Scene given = scene;
  given.string.back().stiffness = {206e9 * area, 206e9 * inertia, 206e9 * inertia / 1.3};
  given.string.back().polar_inertia =
      pipe.linear_mass * (std::pow(pipe.outer_diameter, 2) + std::pow(pipe.inner_diameter, 2)) / 8.0;
  const Mesh tube = build_mesh(scene, 320.0), same = build_mesh(given, 320.0);
  given.string.back().stiffness = {1e8, 2e5, 1.5e5};
  given.string.back().polar_inertia = 0.2;
  const Mesh other = build_mesh(given, 320.0);
  ASSERT_EQ(tube.elements.size(), same.elements.size());
  for (std::size_t e = 0; e < tube.elements.size(); ++e)
  {
    const BeamSection &a = tube.elements[e].section, &b = same.elements[e].section;
    for (double BeamSection::*k : {&BeamSection::axial, &BeamSection::bending, &BeamSection::bending_near,
                                   &BeamSection::bending_far, &BeamSection::torsion, &BeamSection::shear})
      EXPECT_NEAR(b.*k, a.*k, 1e-12 * a.*k);
    EXPECT_NEAR(same.nodes[e].spin_inertia, tube.nodes[e].spin_inertia, 1e-12 * tube.nodes[e].spin_inertia);
    EXPECT_NEAR(same.nodes[e].tilt_inertia, tube.nodes[e].tilt_inertia, 1e-12 * tube.nodes[e].tilt_inertia);
  }
  const BeamSection& last = other.elements.back().section;
  EXPECT_EQ(last.axial, 1e8);
  EXPECT_EQ(last.bending, 2e5);
  EXPECT_NEAR(last.torsion * last.length, 1.5e5, 1e-9);
  EXPECT_NEAR(other.nodes.back().spin_inertia, 0.5 * 0.2 * last.length, 1e-9);
}

// Bit, motor, stabiliser, survey tool, two collars, pipe: each node and element tells whose it is and has that part's own
// numbers.
TEST(Mesh, knowsWhoseEachPlaceIs)
{
  Scene scene = assembly();
  scene.string.insert(scene.string.begin() + 3, mwd_part());
  scene.string[0].bit->squeeze_film_damping = 123.0;
  scene.string[2].stabilizer->squeeze_film_damping = 45.0;
  scene.string[4].contact.emplace().stiffness = 1e9;
  const Mesh mesh = build_mesh(scene, 320.0);
  const std::vector<double> bottoms = {0.0, 0.3, 8.6, 10.4, 19.4, 38.2, 320.0};
  ASSERT_EQ(6u, mesh.part_bottom.size());
  ASSERT_EQ(6u, mesh.part_top.size());
  for (int p = 0; p < 6; ++p)
  {
    EXPECT_NEAR(mesh.part_bottom[p], bottoms[p], 1e-9) << p;
    EXPECT_NEAR(mesh.part_top[p], bottoms[p + 1], 1e-9) << p;
  }
  EXPECT_NEAR(mesh.sensor_from_bit, 14.4, 1e-9);
  for (std::size_t i = 1; i < mesh.nodes.size(); ++i)
  {
    const MeshNode& node = mesh.nodes[i];
    const MeshElement& e = mesh.elements[i - 1];
    const PartSpec& part = scene.string[node.part];
    EXPECT_EQ(e.part, node.part);
    EXPECT_GT(node.from_bit, bottoms[node.part] + 1e-9);
    EXPECT_LT(node.from_bit, bottoms[node.part + 1] + 1e-9);
    const bool blade = std::abs(node.from_bit - 9.5) < 1e-9;
    EXPECT_EQ(node.contact.stiffness, node.part == 4 ? 1e9
                                      : blade        ? scene.contact.assembly_stiffness
                                                     : scene.contact.law.stiffness);
    EXPECT_EQ(e.contact.stiffness, node.part == 4 ? 1e9 : scene.contact.law.stiffness);
    EXPECT_EQ(e.outer_diameter, part.outer_diameter);
    EXPECT_NEAR(e.outer_area, pi * std::pow(0.5 * part.outer_diameter, 2), 1e-15);
    EXPECT_NEAR(e.bore_area, pi * std::pow(0.5 * part.inner_diameter, 2), 1e-15);
    const bool blades = std::abs(node.from_bit - 9.5) < 1e-9;
    EXPECT_EQ(node.squeeze_film_damping, blades ? 45.0 : 0.0);
    const bool bend = static_cast<int>(i) == mesh.bend_node;
    EXPECT_NEAR(node.contact_radius,
                blades                                   ? 0.106
                : node.from_bit > 38.0 && node.joint_end ? 0.084
                                                         : 0.5 * part.outer_diameter,
                1e-15)
        << i;
    const Eigen::Vector3d normal = e.upper_end * Eigen::Vector3d::UnitX(),
                          turned(std::cos(1.25 * degree), std::sin(1.25 * degree), 0.0);
    EXPECT_LT((normal - (bend ? turned : Eigen::Vector3d::UnitX())).norm(), 1e-15) << "towards y";
    EXPECT_EQ(node.joint,
              part.joints == 1 ? 0 : static_cast<int>((node.from_bit - bottoms[node.part] - 1e-9) / part.joint_length))
        << i;
  }
  EXPECT_EQ(mesh.nodes[0].squeeze_film_damping, 123.0);
}

// A straight motor has no node of its own.
TEST(Mesh, aMotorWithoutABendIsCutEvenly)
{
  Scene scene = assembly();
  scene.string[1] = motor_part(0.0);
  const Mesh mesh = build_mesh(scene, 320.0);
  EXPECT_EQ(-1, mesh.bend_node);
  EXPECT_NEAR(mesh.nodes[1].from_bit, 8.6, 1e-9);
}

// The section's second moments, by hand from the diameters.
TEST(Mesh, elementsAndInertiaAreThoseOfTheTube)
{
  Scene scene = vertical_scene(500.0, 300.0);
  scene.string = {bit_part(0.2), pipe_part(0, 10.0, plain_pipe_mass, pipe_outer)};
  scene.numerics.element_length = 5.0;
  const Mesh mesh = build_mesh(scene, 100.3);
  const double polar = pi / 32.0 * (std::pow(pipe_outer, 4) - std::pow(pipe_inner, 4));
  const MeshElement& e = mesh.elements[5];
  EXPECT_NEAR(e.section.length, 5.0, 1e-9);
  EXPECT_NEAR(e.section.axial, 206e9 * pipe_area, 1.0);
  EXPECT_NEAR(e.section.torsion, 206e9 / 2.6 * polar / 5.0, 1e-3);
  EXPECT_NEAR(e.section.bending_near - e.section.bending_far, 2.0 * 206e9 * 0.5 * polar / 5.0, 1e-3);
  const MeshNode& node = mesh.nodes[6];
  EXPECT_NEAR(node.mass, 5.0 * plain_pipe_mass, 1e-9);
  const double bore = 0.25 * pi * pipe_inner * pipe_inner;
  EXPECT_NEAR(node.mud_inside, 1150.0 * bore * 5.0, 1e-9);
  EXPECT_NEAR(node.mud_outside, 1150.0 * (bore + pipe_area) * 5.0, 1e-9);
  EXPECT_NEAR(node.diameter, pipe_outer, 1e-12);
  EXPECT_NEAR(node.spin_inertia, steel_density * polar * 5.0, 1e-9);
  EXPECT_NEAR(node.length, 5.0, 1e-9);
  // Across the axis: half the polar moment, and what is lumped of the cubic beam's consistent mass, whose diagonal 156/420, 4/420
  // L^2 is scaled so that the two ends carry the mass (Hinton, Rock and Zienkiewicz 1976); the mud counts where it moves along.
  const double rotary = steel_density * 0.5 * polar * 5.0, moved = 5.0 * (plain_pipe_mass + 1150.0 * (2.0 * bore + pipe_area));
  EXPECT_NEAR(node.tilt_inertia, rotary + 2.0 * 0.5 * moved * 25.0 * 4.0 / 156.0, 1e-9);
  // the bit is a ball on half an element of 5.2 m, of which 0.2 m are its own
  const MeshNode& bit = mesh.nodes[0];
  const double ball = 0.4 * 40.0 * 0.1 * 0.1, share = 0.5 * 5.0;
  EXPECT_NEAR(bit.mass, 40.0 + share * plain_pipe_mass, 1e-9);
  EXPECT_NEAR(bit.spin_inertia, ball + share * steel_density * polar, 1e-9);
  const double lumped = (share * plain_pipe_mass + 0.5 * 5.2 * 1150.0 * (2.0 * bore + pipe_area)) * 5.2 * 5.2 * 4.0 / 156.0;
  EXPECT_NEAR(bit.tilt_inertia, ball + share * steel_density * 0.5 * polar + lumped, 1e-9);
}

TEST(Mesh, refusesStringsThatDoNotFit)
{
  const Scene scene = assembly();
  EXPECT_NE(refusal(scene, 29.0).find("pipe"), std::string::npos) << refusal(scene, 29.0);
  EXPECT_NE(refusal(scene, 29.45).find("leave only 0.25 m; at least 0.5 m"), std::string::npos) << refusal(scene, 29.45);
  EXPECT_EQ(refusal(scene, 30.0), "");
  Scene fixed = scene;
  fixed.string.back().joints = 10;
  EXPECT_NE(refusal(fixed, 300.0).find("fill"), std::string::npos) << refusal(fixed, 300.0);
  EXPECT_EQ(refusal(fixed, 29.2 + 95.0), "");
  EXPECT_NE(refusal(fixed, 29.2 + 95.0 + 1e-5), "") << "to a micron";
}

TEST(StringProblems, nameTheKeyOfAnElementThatIsTooShortOrOfTooMany)
{
  const auto first = [](const Scene& scene)
  {
    const ProblemList problems = string_problems(scene.string, 320.0, element_lengths(scene));
    return problems.empty() ? std::string() : problems.front().key;
  };
  Scene scene = assembly();
  EXPECT_EQ(first(scene), "");
  scene.string[1].motor->bit_to_bend = 0.3 + 8.3 - 0.005;  // bend 5 mm below the motor's upper end
  EXPECT_EQ(first(scene), "string[1].bit_to_bend");
  scene = assembly();
  scene.string[2].length = scene.string[2].joint_length = 0.015;  // blades in its middle
  EXPECT_EQ(first(scene), "string[2].length");
  scene = assembly();
  scene.string[0].length = scene.string[0].joint_length = 0.02;
  scene.string[1] = stabilizer();
  scene.string[1].length = scene.string[1].joint_length = 0.1;  // blades at 7 cm, the bit's centre at 10.8
  EXPECT_EQ(first(scene), "string[0].length");
  scene = assembly();
  scene.numerics.element_length = 0.005;
  EXPECT_EQ(first(scene), "numerics.element_length");
}

// A rest of less than half a metre joins the joint below it.
TEST(Mesh, leavesNoStub)
{
  const Scene scene = assembly();
  const Mesh mesh = build_mesh(scene, 29.2 + 95.0 + 0.3);
  EXPECT_NEAR(mesh.elements.back().section.length, 4.9, 1e-9) << "9.8 m in two";
  const Mesh longer = build_mesh(scene, 29.2 + 95.0 + 0.7);
  EXPECT_NEAR(longer.elements.back().section.length, 0.7, 1e-9);
}
}  // namespace test_string_mesh
