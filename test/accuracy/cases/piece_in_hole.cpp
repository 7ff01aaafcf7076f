// SPDX-License-Identifier: BSD-3-Clause
#include "piece_in_hole.h"

#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

double PieceInHole::compression() const
{
  double sum = 0.0;
  for (double tension : forces.tension) sum -= tension;
  return sum / static_cast<double>(forces.tension.size());
}

bool PieceInHole::push(double distance)
{
  NodeState& held = state.nodes.back();
  const Vector3d axis = state.well.locate(held.position, -1).tangent;
  held.position += distance * axis;
  return settle();
}

bool PieceInHole::settle()
{
  // round-off of positions some hundred metres from the origin is a tenth of a newton in elements of centimetres; a floppy piece
  // without weight needs a second walk
  for (int attempt = 0; attempt < 4; ++attempt)
  {
    const StaticOutcome out = solve_static(*model, state, no_sliding);
    forces = out.forces;
    if (out.converged || out.residual < 1.0) return true;
  }
  return false;
}

PieceInHole lay_in_hole(const Scene& scene, double length, double bit_depth)
{
  PieceInHole piece{nullptr, State(Wellbore(scene.well, scene.trajectory, 0.5 * scene.string.front().bit->diameter)), {}};
  piece.model = std::make_shared<Model>(scene, build_mesh(scene, length));
  const Mesh& mesh = piece.model->mesh();
  piece.forces.tension.assign(mesh.elements.size(), 0.0);
  piece.state.nodes.assign(mesh.nodes.size(), NodeState());
  piece.state.spans.assign(mesh.elements.size(), SpanState());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
  {
    const WellNode hole = piece.state.well.at(bit_depth - mesh.nodes[i].from_bit);
    const Vector3d up = high_side(hole.tangent);
    Eigen::Matrix3d axes;
    axes << hole.tangent, up, hole.tangent.cross(up);
    piece.state.nodes[i].orientation = Eigen::Quaterniond(axes);
    // a micrometre off the wall
    piece.state.nodes[i].position = hole.position - (hole.radius - mesh.nodes[i].contact_radius - 1e-6) * up;
  }
  return piece;
}

}  // namespace drill_rig_sim
