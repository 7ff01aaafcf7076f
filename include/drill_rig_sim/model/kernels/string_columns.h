#ifndef DRILL_RIG_SIM_MODEL_KERNELS_STRING_COLUMNS_H
#define DRILL_RIG_SIM_MODEL_KERNELS_STRING_COLUMNS_H

#include <cstdint>
#include <vector>

#include "drill_rig_sim/math/number_columns.h"
#include "drill_rig_sim/model/kernels/place_kernel.h"
#include "drill_rig_sim/model/kernels/wall_kernel.h"
#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/stage.h"

namespace drill_rig_sim
{
struct NodeMoves;

/// NumberColumns of the nodes; what is a vector or a quaternion (x, y, z, w) has one for each number.
namespace node_column
{
enum : int
{
  // by the motion kernel
  position = 0,
  normal = 3,
  turning = 6,    ///< angular velocity
  velocity = 9,
  rotating = 12,  ///< rotational part of the rate
  axis = 15,
  acceleration = 18,
  orientation = 24,
  carried_spin = 28,
  increment = 29,
  // of the stage
  free = 35,       ///< 1, or 0 of a guided node, whose mass and mud are another's
  immersed = 36,   ///< times free
  added_mass = 37,  ///< times free
  // of the model
  mass = 38,  ///< with that of the block
  spin_inertia = 39,
  tilt_inertia = 40,
  mud_across = 41,  ///< where it is immersed
  mud_along = 42,   ///< less that across
  mud_torsional = 43,
  mud_quadratic = 44,
  contact_radius = 45,
  // by the place kernel
  searched = 46,  ///< where it was when the hole was searched last
  room = 49,      ///< how far from there it may go and still be clear of the wall in the same segment, for sure; 0: not known
  count = 50
};
}  // namespace node_column

/// And of the elements.
namespace element_column
{
enum : int
{
  // of the stage
  load = 0,
  free_stretch = 3,
  // of the model: BeamSection
  length = 4,
  axial = 5,
  bending_near = 6,
  bending_far = 7,
  torsion = 8,
  upper_end = 9,  ///< MeshElement's quaternion
  radius = 13,    ///< of the body
  // by the place kernel
  middle = 14,
  searched = 17,  ///< as of nodes
  room = 20,
  count = 21
};
}  // namespace element_column

/// What the batch kernels of the string work with.
struct StringColumns
{
  explicit StringColumns(const Model& model);

  /// What the stage says now.
  void take_stage(const Stage& stage) noexcept;
  /// The motion of one node.
  void take(const NodeMoves& node, int i) noexcept;

  NumberColumns nodes, elements;
  bool moved = false;  ///< hold the motion of the workspace's nodes
  // of the search in the hole: who is searched singly at any time; where the search starts, and what it finds
  std::vector<unsigned char> single_nodes, single_elements;
  std::vector<const double*> segments;
  std::vector<Place> places;
  // the hole and the first segments of the last searches
  std::uint64_t hole = 0;
  std::vector<int> node_hints, element_hints;
  // of nodes that touch the wall
  std::vector<WallPlace> wall_places;
  std::vector<WallNumbers> wall_numbers;
};

}  // namespace drill_rig_sim

#endif
