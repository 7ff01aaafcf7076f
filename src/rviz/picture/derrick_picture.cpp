// SPDX-License-Identifier: BSD-3-Clause
#include "derrick_picture.h"

#include <algorithm>

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr double half_foot = 5.0, half_crown = 1.2, half_floor = 6.0;  // [m]
constexpr double block_top = 4.6;                                      // of the travelling block above the shaft's end [m]
constexpr Color beam{0.62f, 0.64f, 0.66f}, brace{0.45f, 0.47f, 0.50f}, floor_color{0.34f, 0.36f, 0.38f},
    block{0.90f, 0.75f, 0.10f}, drive{0.30f, 0.55f, 0.80f}, rope{0.80f, 0.80f, 0.75f};

/// A leg's place at a height.
Vector3d leg(int which, double share, double crown_height)
{
  const double half = half_foot + share * (half_crown - half_foot);
  return {which == 0 || which == 3 ? half : -half, which < 2 ? half : -half, share * crown_height};
}

void add_floor(MeshData& mesh)
{
  constexpr double hole = 0.6;
  add_box(mesh, {-half_floor, -half_floor, -0.4}, {-hole, half_floor, -0.05}, floor_color);
  add_box(mesh, {hole, -half_floor, -0.4}, {half_floor, half_floor, -0.05}, floor_color);
  add_box(mesh, {-hole, -half_floor, -0.4}, {hole, -hole, -0.05}, floor_color);
  add_box(mesh, {-hole, hole, -0.4}, {hole, half_floor, -0.05}, floor_color);
}
}  // namespace

MeshData derrick_mesh(double crown_height)
{
  MeshData mesh;
  add_floor(mesh);
  constexpr int bays = 6;
  for (int which = 0; which < 4; ++which)
  {
    add_bar(mesh, leg(which, 0.0, crown_height), leg(which, 1.0, crown_height), 0.35, beam);
    const int next = (which + 1) % 4;
    for (int bay = 0; bay < bays; ++bay)
    {
      const double low = static_cast<double>(bay) / bays, high = static_cast<double>(bay + 1) / bays;
      add_bar(mesh, leg(which, high, crown_height), leg(next, high, crown_height), 0.15, brace);
      if (which == 0 && bay == 0) continue;  // the V door: pipe comes in here
      add_bar(mesh, leg(which, low, crown_height), leg(next, high, crown_height), 0.1, brace);
    }
  }
  add_box(mesh, {-half_crown, -half_crown, crown_height - 0.3}, {half_crown, half_crown, crown_height + 1.0}, beam);
  return mesh;
}

MeshData block_mesh()
{
  MeshData mesh;
  add_box(mesh, {-0.7, -0.9, 0.3}, {0.7, 0.9, 2.6}, drive);
  add_box(mesh, {-0.2, -0.2, 0.0}, {0.2, 0.2, 0.3}, beam);
  add_box(mesh, {-0.15, -0.15, 2.6}, {0.15, 0.15, 3.0}, beam);
  add_box(mesh, {-0.6, -0.9, 3.0}, {0.6, 0.9, block_top}, block);
  return mesh;
}

void add_lines(MeshData& lines, double crown_height, double block_height, int sheaves)
{
  const int count = 2 * std::clamp(sheaves, 1, 20);
  const double top = crown_height - 0.3, bottom = std::min(block_height + block_top, top);
  for (int i = 0; i < count; ++i)
  {
    const double y = 0.8 * (2.0 * i / (count - 1.0) - 1.0);
    lines.add_line({0.0, y, bottom}, {0.0, y, top}, rope);
  }
  lines.add_line({0.0, 0.9, top}, {half_foot - 0.5, 2.5, 0.0}, rope);    // fast line, to the drum
  lines.add_line({0.0, -0.9, top}, {half_foot - 0.5, -3.5, 0.0}, rope);  // dead line, to its anchor
}

}  // namespace drill_rig_sim
