// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_KERNELS_STRING_COLUMNS_H
#define DRILL_RIG_SIM_MODEL_KERNELS_STRING_COLUMNS_H

#include <cstdint>
#include <vector>

#include "drill_rig_sim/math/columns.h"
#include "drill_rig_sim/model/kernels/place_kernel.h"
#include "drill_rig_sim/model/kernels/wall_kernel.h"
#include "drill_rig_sim/model/model.h"

namespace drill_rig_sim
{
struct NodeMotion;

/// Of the nodes, by column.
struct NodeColumns
{
  // by the motion kernel
  Columns<3> position, normal;
  Columns<3> turning;  ///< angular velocity
  Columns<3> axis;
  Columns<4> orientation;  ///< x, y, z, w
  Column carried_spin;
  Columns<6> increment, rate, acceleration;
  // of the model
  Column mass;  ///< with that of the block
  Column spin_inertia, tilt_inertia;
  Column mud_across;  ///< where it is immersed
  Column mud_along;   ///< less that across
  Column mud_about, mud_quadratic;
  Column contact_radius;
  // by the place kernel
  Columns<3> searched;  ///< where it was when the hole was searched last
  Column room;  ///< how far from there it may go and still be clear of the wall in the same segment, for sure; 0: not known

  template <class V>
  void visit(V& v)
  {
    v("position", position);
    v("normal", normal);
    v("turning", turning);
    v("axis", axis);
    v("orientation", orientation);
    v("carried_spin", carried_spin);
    v("increment", increment);
    v("rate", rate);
    v("acceleration", acceleration);
    v("mass", mass);
    v("spin_inertia", spin_inertia);
    v("tilt_inertia", tilt_inertia);
    v("mud_across", mud_across);
    v("mud_along", mud_along);
    v("mud_about", mud_about);
    v("mud_quadratic", mud_quadratic);
    v("contact_radius", contact_radius);
    v("searched", searched);
    v("room", room);
  }
};

/// And of the elements.
struct ElementColumns
{
  // of the model: BeamSection
  Column length, axial, bending_near, bending_far, torsion;
  Columns<4> upper_end;  ///< MeshElement's quaternion
  Column radius;         ///< of the body
  // by the place kernel
  Columns<3> middle;
  Columns<3> searched;  ///< as of nodes
  Column room;

  template <class V>
  void visit(V& v)
  {
    v("length", length);
    v("axial", axial);
    v("bending_near", bending_near);
    v("bending_far", bending_far);
    v("torsion", torsion);
    v("upper_end", upper_end);
    v("radius", radius);
    v("middle", middle);
    v("searched", searched);
    v("room", room);
  }
};

/// What the batch kernels of the string work with.
struct StringColumns
{
  explicit StringColumns(const Model& model);

  /// The motion of one node.
  void take(const NodeMotion& node, int i) noexcept;

  NodeColumns nodes;
  ElementColumns elements;
  bool moved = false;  ///< hold the motion of the workspace's nodes
  // of the search in the hole: who is searched singly at any time; where the search starts, and what it finds
  std::vector<unsigned char> single_nodes, single_elements;
  HoleColumns node_holes, element_holes;
  std::vector<unsigned char> beside;  ///< of those that are searched, PlaceTask::beside
  std::vector<Place> places;
  // the hole and the first segments of the last searches
  std::uint64_t hole = 0;
  std::vector<int> node_hints, element_hints;
  // of nodes that touch the wall
  std::vector<WallPlace> wall_places;
  std::vector<WallLaw> wall_laws;  ///< where they differ from the model's
};

}  // namespace drill_rig_sim

#endif
