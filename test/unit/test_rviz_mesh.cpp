// SPDX-License-Identifier: BSD-3-Clause
// What is drawn, as triangles: closed forms of areas and normals, from where they are seen; the string's outline; bad data
// refused.
#include <gtest/gtest.h>

#include <cmath>

#include "rviz/picture/derrick_picture.h"
#include "rviz/picture/string_tube.h"
#include "rviz/picture/tools_picture.h"
#include "rviz/picture/well_picture.h"

namespace drill_rig_sim::test_rviz_mesh
{
namespace
{
using Eigen::Vector3d;

Vector3d place(const MeshData& mesh, std::size_t i)
{
  const Vertex& v = mesh.vertices[mesh.indices[i]];
  return {v.position[0], v.position[1], v.position[2]};
}

Vector3d normal(const MeshData& mesh, std::size_t i)
{
  const Vertex& v = mesh.vertices[mesh.indices[i]];
  return {v.normal[0], v.normal[1], v.normal[2]};
}

double area(const MeshData& mesh)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    sum += 0.5 * (place(mesh, i + 1) - place(mesh, i)).cross(place(mesh, i + 2) - place(mesh, i)).norm();
  return sum;
}

/// Whether all triangles run counterclockwise seen from where their normals point to.
bool faces_its_normals(const MeshData& mesh)
{
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
  {
    const Vector3d across = (place(mesh, i + 1) - place(mesh, i)).cross(place(mesh, i + 2) - place(mesh, i));
    if (across.norm() > 1e-9 && across.dot(normal(mesh, i)) < 0.0) return false;
  }
  return true;
}

std::vector<Ring> cylinder(double length, double radius)
{
  Ring a;
  a.radius = radius;
  Ring b = a;
  b.center.z() = length;
  return {a, b};
}

/// A bit, a stabiliser and pipe of ten-metre joints.
RigData three_parts()
{
  RigData rig;
  rig.parts = {{"bit", PartKind::bit, 0.4, 0.4, 0.15, 0.15},
               {"blades", PartKind::stabilizer, 2.0, 2.0, 0.1, 0.14},
               {"pipe", PartKind::pipe, 0.0, 10.0, 0.06, 0.08}};
  rig.section_bottom = {50.0, 200.0};
  rig.section_radius = {0.2, 0.16};
  rig.layer_base = {60.0, 1000.0};
  return rig;
}

HoleAxis straight_down(double depth)
{
  return {{Vector3d::Zero(), {0.0, 0.0, -depth}}, {-Vector3d::UnitZ(), -Vector3d::UnitZ()}};
}

StringData five_nodes()
{
  StringData d;
  for (const double s : {0.2, 2.4, 7.0, 12.4, 32.4})
  {
    d.from_bit.push_back(s);
    d.md.push_back(100.0 - s);
    d.position.emplace_back(0.01, 0.0, s - 100.0);
    for (auto* values : {&d.tension, &d.torque, &d.bending_moment, &d.bending_stress, &d.contact_force, &d.contact_side,
                         &d.spin_speed, &d.buckling})
      values->push_back(s);
    d.guided.push_back(0);
  }
  return d;
}
}  // namespace

TEST(Tube, hasTheAreaOfItsFacesAndIsSeenFromItsSide)
{
  for (const bool inside : {false, true})
  {
    MeshData mesh;
    add_tube(mesh, cylinder(3.0, 2.0), 12, inside);
    EXPECT_NEAR(12 * 2.0 * 2.0 * std::sin(M_PI / 12) * 3.0, area(mesh), 1e-5);
    EXPECT_TRUE(faces_its_normals(mesh));
    EXPECT_GT((inside ? -1.0 : 1.0) * normal(mesh, 0).dot(Vector3d(place(mesh, 0).x(), place(mesh, 0).y(), 0.0)), 0.0);
  }
}

TEST(Shapes, areSeenFromOutside)
{
  MeshData mesh;
  add_box(mesh, {0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}, {});
  EXPECT_NEAR(22.0, area(mesh), 1e-5);
  EXPECT_TRUE(faces_its_normals(mesh));
  mesh.clear();
  add_disc(mesh, cylinder(1.0, 2.0).front(), 24, false);
  add_disc(mesh, cylinder(1.0, 2.0).front(), 24, true);
  EXPECT_TRUE(faces_its_normals(mesh));
  EXPECT_TRUE(faces_its_normals(bit_mesh(0.4, 0.15)));
  EXPECT_TRUE(faces_its_normals(derrick_mesh(40.0)));
  mesh.clear();
  add_arrow(mesh, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.1, {});
  EXPECT_TRUE(mesh.indices.empty());
}

TEST(Bit, keepsWithinItsGaugeAndLength)
{
  const MeshData mesh = bit_mesh(0.4, 0.15);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
  {
    const Vector3d p = place(mesh, i);
    EXPECT_LE(std::hypot(p.y(), p.z()), 0.15 + 1e-6);
    EXPECT_GE(p.x(), -0.4 - 1e-6);
    EXPECT_LE(p.x(), 1e-6);
  }
}

TEST(Dashes, areHalfOfTheLine)
{
  MeshData mesh;
  add_dashes(mesh, {Vector3d(0, 0, 0), Vector3d(3, 0, 0), Vector3d(3, 5, 0), Vector3d(15, 5, 0)}, 1.0, {});
  double length = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 2) length += (place(mesh, i + 1) - place(mesh, i)).norm();
  EXPECT_NEAR(10.0, length, 1e-4);
}

TEST(Shade, darkensWhatTurnsAwayAndLeavesNothingBlack)
{
  MeshData mesh;
  mesh.add(Vector3d::Zero(), {0.36, -0.48, 0.80}, {});
  mesh.add(Vector3d::Zero(), {-0.36, 0.48, -0.80}, {});
  shade(mesh);
  EXPECT_GE(mesh.vertices[0].color[0], 254);
  EXPECT_NEAR(0.52 * 255, mesh.vertices[1].color[0], 1.0);
}

TEST(Outline, hasAToolJointAtEachJointsEnd)
{
  const std::vector<OutlinePoint> outline = outline_of(three_parts(), 45.0);
  int wide = 0;
  for (const OutlinePoint& p : outline) wide += p.radius == 0.08;
  EXPECT_EQ(8, wide);  // joints end at 12.4, 22.4, 32.4 and 42.4 m
  for (const OutlinePoint& p : outline_of(three_parts(), 45.0, false)) EXPECT_NE(0.08, p.radius);
  EXPECT_NEAR(0.4, outline.front().from_bit, 1e-12);
  EXPECT_NEAR(45.0, outline.back().from_bit, 1e-12);
}

TEST(StringTube, goesThroughItsNodesExaggerated)
{
  const StringData data = five_nodes();
  const std::vector<DrawnNode> nodes = StringTube::place(data, straight_down(120.0), 10.0);
  EXPECT_NEAR(0.0, (nodes[2].position - Vector3d(0.1, 0.0, -93.0)).norm(), 1e-9);
  StringTube tube;
  tube.shape(three_parts(), data.from_bit);
  MeshData mesh;
  add_tube(mesh,
           tube.rings(
               nodes, data.tension, [](double) { return Color{}; }, 10.0),
           8);
  EXPECT_TRUE(faces_its_normals(mesh));
  double widest = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    widest = std::max(widest, std::hypot(place(mesh, i).x() - 0.1, place(mesh, i).y()));
  EXPECT_NEAR(1.0, widest, 1e-6);  // the stabiliser's body, ten times
}

TEST(Wall, isSeenFromWithinAndHasItsSections)
{
  MeshData mesh;
  add_tube(mesh, wall_rings(straight_down(120.0), three_parts(), 50.0, 1.0, 1.0), 24, true);
  EXPECT_TRUE(faces_its_normals(mesh));
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
  {
    const Vector3d p = place(mesh, i);
    const double radius = std::hypot(p.x(), p.y());
    if (radius > 1e-6 && std::abs(p.z() + 50.0) > 0.01)
    {
      EXPECT_NEAR(p.z() > -50.0 ? 0.2 : 0.16, radius, 1e-5) << p.z();
    }
  }
}

TEST(Layers, meetAtTheirBases)
{
  MeshData bands, lines;
  add_layers(bands, lines, straight_down(120.0), three_parts(), 30.0);
  EXPECT_EQ(2u, bands.vertices.size() / 4);
  ASSERT_EQ(2u, lines.vertices.size());
  EXPECT_NEAR(-60.0, lines.vertices[0].position[2], 1e-5);
}

TEST(PlanDistance, isSquareToThePlanAndEndsWithIt)
{
  const std::vector<Vector3d> plan{{0, 0, 0}, {0, 0, -100}, {0, 0, -200}};
  const PlanDistance off = distance_to_plan(plan, {3.0, 4.0, -150.0});
  EXPECT_TRUE(off.there);
  EXPECT_NEAR(5.0, off.distance, 1e-12);
  EXPECT_TRUE(distance_to_plan(plan, {3.0, 4.0, -200.5}).there);
  EXPECT_NEAR(5.0, distance_to_plan(plan, {3.0, 4.0, -200.5}).distance, 1e-9) << "beyond its end only what is across counts";
  EXPECT_NEAR(0.0, distance_to_plan(plan, {0.0, 0.0, -200.39}).distance, 1e-9);
  EXPECT_FALSE(distance_to_plan(plan, {3.0, 4.0, -230.0}).there);
  EXPECT_FALSE(distance_to_plan({}, Vector3d::Zero()).there);
}

TEST(Problem, namesWhatCannotBeDrawn)
{
  EXPECT_EQ("", problem_of(five_nodes()));
  StringData d = five_nodes();
  d.torque.pop_back();
  EXPECT_EQ("torque has 4 entries, position 5", problem_of(d));
  d = five_nodes();
  d.position[1].x() = std::nan("");
  EXPECT_EQ("position holds a number that is not finite", problem_of(d));
  d = five_nodes();
  d.from_bit[3] = d.from_bit[2];
  EXPECT_EQ("from_bit does not go up the string", problem_of(d));
  EXPECT_EQ("the string has 0 nodes, needed are two", problem_of(StringData()));
  EXPECT_EQ("", problem_of(three_parts()));
  RigData rig = three_parts();
  rig.parts[1].radius = std::nan("");
  EXPECT_EQ("part blades has a diameter or a length that cannot be", problem_of(rig));
  EXPECT_EQ("there are no parts", problem_of(RigData()));
}

}  // namespace drill_rig_sim::test_rviz_mesh
