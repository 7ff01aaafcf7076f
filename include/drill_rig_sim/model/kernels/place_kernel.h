#ifndef DRILL_RIG_SIM_MODEL_KERNELS_PLACE_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_PLACE_KERNEL_H

#include "drill_rig_sim/math/columns.h"
#include "drill_rig_sim/math/kernel.h"

/// Where in the hole nodes and elements' middles are, several at a time: Wellbore::locate() from the segment of the start, for
/// those that are beside that segment, and wall_gap() there.
namespace drill_rig_sim
{
struct ElementColumns;
struct HoleSegment;
struct NodeColumns;
struct NodeMotion;
struct SpanMotion;

/// What a search has found.
enum class Place : unsigned char
{
  clear,  ///< of the wall
  touches,
  search  ///< nothing, the search must be done singly
};

/// Of nodes or elements, by column.
struct PlaceTask
{
  int first, last;  ///< from and to, the latter not among them
  const Columns<3>& position;
  const Column& radius;  ///< of the sections
  Columns<3>& searched;  ///< where they were at their last searches,
  Column& room;          ///< and how far they may go from there (string_columns.h)
  /// Of each its segment; null: to be left as it is. Room for a batch behind the last.
  const HoleSegment* const* segments;
  Place* places;  ///< room for a batch behind the last
};

/// A kernel's.
struct PlaceKernel
{
  /// Those that are where the last search has left them room are clear, the others are to be searched.
  void (*look)(const PlaceTask& task) noexcept;
  /// Searches; what is found leaves its place and room, and of batches in which one touches the closest points, but for segment
  /// and iterations.
  void (*find_nodes)(const PlaceTask& task, NodeMotion* nodes) noexcept;
  void (*find_spans)(const PlaceTask& task, SpanMotion* spans) noexcept;
  /// Middles of the elements from `first` to `last`, the latter not among them, on their cubics (SpanMotion), from the nodes'
  /// columns.
  void (*find_middles)(int first, int last, const NodeColumns& nodes, ElementColumns& elements) noexcept;
};

/// Null: there is none, and one by one is the way.
const PlaceKernel* place_kernel(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
