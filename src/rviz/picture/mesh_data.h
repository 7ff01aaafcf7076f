// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_MESH_DATA_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_MESH_DATA_H

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "color_scale.h"
#include "hole_axis.h"

namespace drill_rig_sim
{
/// As the graphics card gets it: place, normal, and colour as bytes red, green, blue, opacity.
struct Vertex
{
  float position[3];
  float normal[3];
  std::uint8_t color[4];
};

/// Triangles, or pairs of points that are lines. Triangles run counterclockwise seen from where they are to be seen.
struct MeshData
{
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;

  void clear();
  std::uint32_t add(const Eigen::Vector3d& position, const Eigen::Vector3d& normal, const Color& color);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void add_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Color& color);
};

/// Darkens each colour by how far its face turns away from a light that stands high in the south-east, to a half at most: seen
/// from anywhere nothing is black, as it would be under rviz' one light.
void shade(MeshData& mesh);

/// A circle about a place: one of a tube's rings.
struct Ring
{
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d side = Eigen::Vector3d::UnitX(),
                  other = Eigen::Vector3d::UnitY();  ///< unit, across the tube; side x other points along it
  double radius = 0.0;
  Color color;
};

/// A tube through rings, with `sides` faces about it (at least 3). Seen from outside, or `inside` a hole from within.
void add_tube(MeshData& mesh, const std::vector<Ring>& rings, int sides, bool inside = false);

/// A disc that closes a tube at `ring`, seen from where side x other points to, or with `back` from the other side.
void add_disc(MeshData& mesh, const Ring& ring, int sides, bool back);

/// An arrow from `tail` to `tip`, of shaft radius `radius` and `sides` faces about it; its head is as wide as three of that and
/// at most half of it long. Nothing where it has no length.
void add_arrow(MeshData& mesh, const Eigen::Vector3d& tail, const Eigen::Vector3d& tip, double radius, const Color& color,
               int sides = 6);

/// Two triangles between four places, seen from the side from which they run counterclockwise.
void add_quad(MeshData& mesh, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
              const Eigen::Vector3d& d, const Eigen::Vector3d& normal, const Color& color);

/// A box with its edges along the axes.
void add_box(MeshData& mesh, const Eigen::Vector3d& least, const Eigen::Vector3d& most, const Color& color);

/// A straight bar of square cross-section, `width` wide.
void add_bar(MeshData& mesh, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double width, const Color& color);

/// A line in dashes of `dash` [m], with gaps as long.
void add_dashes(MeshData& mesh, const std::vector<Eigen::Vector3d>& points, double dash, const Color& color);

}  // namespace drill_rig_sim

#endif
