#ifndef DRILL_RIG_SIM_MODEL_KERNELS_PLACE_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_PLACE_KERNEL_H

#include <cstddef>

#include "drill_rig_sim/math/kernel.h"
#include "drill_rig_sim/math/number_columns.h"

/// Where in the hole nodes and elements' middles are, several at a time: Wellbore::locate() from the segment of the start, for those that are
/// beside that segment, and wall_gap() there.
namespace drill_rig_sim
{
struct ClosestPoint;

/// What a search has found.
enum class Place : unsigned char
{
  clear,   ///< of the wall
  touches,
  search   ///< nothing, the search must be done singly
};

struct PlaceTask
{
  int first, last;  ///< nodes or elements from and to, the latter not among them
  NumberColumns* columns;
  int position;        ///< the first of its three columns
  int radius;          ///< column of the sections' radii
  int searched, room;  ///< where they were at their last searches (three columns), and how far they may go from there (string_columns.h)
  /// Of each its HoleSegment's numbers, in the segment's order; null: to be left as it is. Room for a batch behind the last.
  const double* const* segments;
  /// Overwritten but for segment and iterations, of batches in which one touches; `closest_stride` bytes apart.
  ClosestPoint* closest;
  std::ptrdiff_t closest_stride;
  Place* places;  ///< room for a batch behind the last
};

/// Middles of the elements on their cubics (SpanMotion), from the nodes' columns.
struct MiddleTask
{
  int first, last;
  const NumberColumns* nodes;
  NumberColumns* elements;
};

/// A kernel's.
struct PlaceKernel
{
  /// Those that are where the last search has left them room are clear, the others are to be searched.
  void (*look)(const PlaceTask& task) noexcept;
  /// Searches; what is found leaves its place and room.
  void (*find)(const PlaceTask& task) noexcept;
  void (*find_middles)(const MiddleTask& task) noexcept;
};

/// Null: there is none, and one by one is the way.
const PlaceKernel* place_kernel(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
