// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_KERNELS_PLACE_KERNEL_H
#define DRILL_RIG_SIM_MODEL_KERNELS_PLACE_KERNEL_H

#include <vector>

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

/// The hole's segments (HoleSegment) beside nodes or elements, by column.
struct HoleColumns
{
  Columns<3> c0, c1, c2, c3, chord;
  Column md, length, radius, radius_change, friction, friction_change, section, section_change;
  std::vector<const HoleSegment*> held;  ///< which segments these are; null: none

  template <class V>
  void visit(V& v)
  {
    v("c0", c0);
    v("c1", c1);
    v("c2", c2);
    v("c3", c3);
    v("chord", chord);
    v("md", md);
    v("length", length);
    v("radius", radius);
    v("radius_change", radius_change);
    v("friction", friction);
    v("friction_change", friction_change);
    v("section", section);
    v("section_change", section_change);
  }
  void hold(std::size_t i, const HoleSegment* segment) noexcept
  {
    if (held[i] != segment) take(i, segment);
  }

private:
  void take(std::size_t i, const HoleSegment* segment) noexcept;
};

/// Of nodes or elements, by column.
struct PlaceTask
{
  int first, last;  ///< from and to, the latter not among them
  const Columns<3>& position;
  const Column& radius;  ///< of the sections
  Columns<3>& searched;  ///< where they were at their last searches,
  Column& room;          ///< and how far they may go from there (string_columns.h)
  const HoleColumns& hole;
  const unsigned char* beside;  ///< of each whether the hole is at hand; those where it is not are left as they are
  Place* places;                ///< room for a batch behind the last
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
