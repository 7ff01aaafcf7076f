// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/places.h"

#include <algorithm>

#include "drill_rig_sim/model/forces/span_wall.h"
#include "drill_rig_sim/model/mast.h"
#include "drill_rig_sim/model/pointing.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
/// The middle of element e: from where the cubic had it at the start of the step, by the ends' increments. Its arms stay those of
/// the start; what that leaves out of a tilt, half its square, points along the pipe.
void move_span(const Model& model, const State& start, const Stage& stage, int e, Workspace& work) noexcept
{
  const MeshElement& element = model.mesh().elements[e];
  const NodeMotion &lower = work.nodes[e], &upper = work.nodes[e + 1];
  const double arm = 0.125 * element.section.length;
  SpanMotion& span = work.spans[e];
  span.upper_arm = arm * (element.bend != 0.0 ? bent_normal(element, start.nodes[e + 1].orientation) : stage.normal[e + 1]);
  span.lower_arm = -arm * stage.normal[e];
  span.increment = middle(span, lower.increment, upper.increment);
  span.position =
      0.5 * (start.nodes[e].position + start.nodes[e + 1].position) + span.upper_arm + span.lower_arm + span.increment.head<3>();
  if (model.mesh().is_shaft(e))  // its lean does not turn with the arm
    span.position += arm * (x_axis(leaning(start.nodes[e + 1].orientation, stage.lean)) - stage.normal[e + 1]);
}

/// Whom a search by the batch kernel is about: nodes or elements outside `guided`.
struct Search
{
  const Runs& guided;
  int count;
  PlaceTask task;
  const std::vector<unsigned char>& singly;
  std::vector<int>& hints;  ///< segments at the start of their last searches
  HoleColumns& hole;
};

/// A node is clear if it has not moved far since it was found clear; of the others those are searched in batches that are beside
/// a smooth segment, and what then is left, unless it is in the mast, by one(k). For the rest found(k, segment, touches).
/// `hint_of(k)`: the segment at the start of the step; `point_of(k)`: where it is.
template <class Find, class Hint, class Point, class One, class Found>
void search(const Wellbore& well, const Search& who, Workspace& work, Find&& find, Hint&& hint_of, Point&& point_of, One&& one,
            Found&& found) noexcept
{
  StringColumns& columns = work.columns;
  PlaceTask task = who.task;
  const auto each_run = [&](const auto& batch)
  {
    each_between(who.guided, who.count,
                 [&](int first, int last)
                 {
                   task.first = first;
                   task.last = last;
                   batch(task);
                 });
  };
  each_run(work.place->look);
  each_outside(who.guided, who.count,
               [&](int k)
               {
                 const int hint = hint_of(k);
                 columns.beside[k] = 0;
                 if (columns.places[k] == Place::clear && who.hints[k] == hint) return;
                 columns.places[k] = Place::search;
                 who.hints[k] = hint;
                 const HoleSegment* segment = who.singly[k] ? nullptr : well.smooth_segment(hint, point_of(k));
                 if (!segment) return;
                 who.hole.hold(static_cast<std::size_t>(k), segment);
                 columns.beside[k] = 1;
               });
  each_run(find);
  each_outside(who.guided, who.count,
               [&](int k)
               {
                 const bool in_mast = who.hints[k] == 0 && clear_in_mast(well, point_of(k), task.radius[k]);
                 if (columns.places[k] == Place::search && !in_mast) return one(k);
                 found(k, who.hints[k], columns.places[k] == Place::touches);
               });
}

/// find_closest() of all free nodes by the batch kernel. One by one: gauge and blades, whose film of mud wants to know the hole
/// even where they are clear of it, and what the kernel leaves.
void find_nodes(const Model& model, const State& start, const Stage& stage, Workspace& work) noexcept
{
  StringColumns& columns = work.columns;
  NodeColumns& nodes = columns.nodes;
  HoleColumns& hole = columns.node_holes;
  const PlaceTask task{0,          0,    nodes.position,        nodes.contact_radius, nodes.searched,
                       nodes.room, hole, columns.beside.data(), columns.places.data()};
  search(
      start.well, {stage.guided_nodes, model.nodes(), task, columns.single_nodes, columns.node_hints, hole}, work,
      [&](const PlaceTask& all) { work.place->find_nodes(all, work.nodes.data()); },
      [&](int i) { return start.nodes[i].segment; }, [&](int i) -> const Vector3d& { return work.nodes[i].position; },
      [&](int i) { find_closest(model, start, i, work.nodes[i]); },
      [&](int i, int segment, bool touches)
      {
        work.nodes[i].closest.segment = segment;
        work.nodes[i].touches = touches;
      });
}

/// find_span() of all free elements, in the same way; of those that are clear of the wall only that is known.
void find_spans(const Model& model, const State& start, const Stage& stage, Workspace& work) noexcept
{
  StringColumns& columns = work.columns;
  ElementColumns& elements = columns.elements;
  each_between(stage.guided_elements, model.elements(),
               [&](int first, int last) { work.place->find_middles(first, last, columns.nodes, elements); });
  HoleColumns& hole = columns.element_holes;
  const PlaceTask task{0,
                       0,
                       elements.middle,
                       elements.radius,
                       elements.searched,
                       elements.room,
                       hole,
                       columns.beside.data(),
                       columns.places.data()};
  search(
      start.well, {stage.guided_elements, model.elements(), task, columns.single_elements, columns.element_hints, hole}, work,
      [&](const PlaceTask& all) { work.place->find_spans(all, work.spans.data()); },
      [&](int e) { return start.spans[e].segment; }, [&](int e) { return elements.middle[e]; },
      [&](int e) { find_span(model, start, stage, e, work); },
      [&](int e, int segment, bool touches)
      {
        work.spans[e].closest.segment = segment;
        work.spans[e].touches = touches;
        if (touches) move_span(model, start, stage, e, work);
      });
}

/// What was found in another hole is void: it has been drilled on since.
void forget_other_hole(const Wellbore& well, StringColumns& columns) noexcept
{
  if (columns.hole == well.version()) return;
  columns.hole = well.version();
  for (std::size_t i = 0; i < columns.node_hints.size(); ++i) columns.nodes.room[i] = 0.0;
  for (std::size_t e = 0; e < columns.element_hints.size(); ++e) columns.elements.room[e] = 0.0;
  for (HoleColumns* hole : {&columns.node_holes, &columns.element_holes})
    std::fill(hole->held.begin(), hole->held.end(), nullptr);
}
}  // namespace

void find_closest(const Model& model, const State& start, int i, NodeMotion& node) noexcept
{
  node.touches = false;
  node.closest.segment = start.nodes[i].segment;
  if (i == model.top()) return;
  node.closest = start.well.locate(node.position, node.closest.segment);
  open_mast(node.closest);
  node.touches = wall_gap(node.closest, node.position, model.mesh().nodes[i].contact_radius) < 0.0;
}

void find_span(const Model& model, const State& start, const Stage& stage, int e, Workspace& work) noexcept
{
  move_span(model, start, stage, e, work);
  SpanMotion& span = work.spans[e];
  span.touches = false;
  span.closest.segment = start.spans[e].segment;
  span.closest = start.well.locate(span.position, span.closest.segment);
  open_mast(span.closest);
  span.touches = wall_gap(span.closest, span.position, 0.5 * model.mesh().elements[e].outer_diameter) < 0.0;
}

void find_in_hole(const Model& model, const State& start, const Stage& stage, Workspace& work) noexcept
{
  if (work.place)
  {
    forget_other_hole(start.well, work.columns);
    find_nodes(model, start, stage, work);
    find_spans(model, start, stage, work);
    return;
  }
  each_outside(stage.guided_nodes, model.nodes(), [&](int i) { find_closest(model, start, i, work.nodes[i]); });
  each_outside(stage.guided_elements, model.elements(), [&](int e) { find_span(model, start, stage, e, work); });
}

}  // namespace drill_rig_sim
