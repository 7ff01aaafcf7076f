#include "drill_rig_sim/model/places.h"

#include <algorithm>

#include "drill_rig_sim/model/forces/span_wall.h"
#include "drill_rig_sim/model/mast.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
/// The middle of element e: from where the cubic had it at the start of the step, by the ends' increments. Its arms stay those of the
/// start; what that leaves out of a tilt, half its square, points along the pipe.
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
}

const double* numbers_of(const HoleSegment* segment) noexcept
{
  static_assert(sizeof(HoleSegment) == 23 * sizeof(double), "numbers without a gap");
  return segment ? segment->c0.data() : nullptr;
}

/// find_closest() of all free nodes by the batch kernel. One by one: gauge and blades, whose film of mud wants to know the hole even where they are
/// clear of it, and what the kernel leaves.
void find_nodes(const Model& model, const State& start, const Stage& stage, Workspace& work) noexcept
{
  StringColumns& columns = work.columns;
  const auto task = [&](int first, int last)
  {
    return PlaceTask{first, last, &columns.nodes, node_column::position, node_column::contact_radius, node_column::searched, node_column::room,
                     columns.segments.data(), &work.nodes[0].closest, sizeof(NodeMotion), columns.places.data()};
  };
  each_between(stage.guided_nodes, model.nodes(), [&](int first, int last) { work.place->look(task(first, last)); });
  each_outside(stage.guided_nodes, model.nodes(), [&](int i)
  {
    const int hint = start.nodes[i].segment;
    columns.segments[i] = nullptr;
    if (columns.places[i] == Place::clear && columns.node_hints[i] == hint) return;
    columns.places[i] = Place::search;
    columns.node_hints[i] = hint;
    if (!columns.single_nodes[i]) columns.segments[i] = numbers_of(start.well.smooth_segment(hint, work.nodes[i].position));
  });
  each_between(stage.guided_nodes, model.nodes(), [&](int first, int last) { work.place->find(task(first, last)); });
  each_outside(stage.guided_nodes, model.nodes(), [&](int i)
  {
    NodeMotion& node = work.nodes[i];
    const int hint = columns.node_hints[i];
    const bool in_mast = hint == 0 && clear_in_mast(start.well, node.position, model.mesh().nodes[i].contact_radius);
    if (columns.places[i] == Place::search && !in_mast) return find_closest(model, start, i, node);
    node.closest.segment = hint;
    node.touches = columns.places[i] == Place::touches;
  });
}

/// find_span() of all free elements, in the same way; of those that are clear of the wall only that is known.
void find_spans(const Model& model, const State& start, const Stage& stage, Workspace& work) noexcept
{
  StringColumns& columns = work.columns;
  const NumberColumns& elements = columns.elements;
  const double *x = elements[element_column::middle], *y = elements[element_column::middle + 1], *z = elements[element_column::middle + 2];
  const auto task = [&](int first, int last)
  {
    return PlaceTask{first, last, &columns.elements, element_column::middle, element_column::radius, element_column::searched, element_column::room,
                     columns.segments.data(), &work.spans[0].closest, sizeof(SpanMotion), columns.places.data()};
  };
  each_between(stage.guided_elements, model.elements(), [&](int first, int last)
  {
    work.place->find_middles({first, last, &columns.nodes, &columns.elements});
    work.place->look(task(first, last));
  });
  each_outside(stage.guided_elements, model.elements(), [&](int e)
  {
    const int hint = start.spans[e].segment;
    columns.segments[e] = nullptr;
    if (columns.places[e] == Place::clear && columns.element_hints[e] == hint) return;
    columns.places[e] = Place::search;
    columns.element_hints[e] = hint;
    if (!columns.single_elements[e]) columns.segments[e] = numbers_of(start.well.smooth_segment(hint, {x[e], y[e], z[e]}));
  });
  each_between(stage.guided_elements, model.elements(), [&](int first, int last) { work.place->find(task(first, last)); });
  each_outside(stage.guided_elements, model.elements(), [&](int e)
  {
    SpanMotion& span = work.spans[e];
    const int hint = columns.element_hints[e];
    const bool in_mast = hint == 0 && clear_in_mast(start.well, {x[e], y[e], z[e]}, elements[element_column::radius][e]);
    if (columns.places[e] == Place::search && !in_mast) return find_span(model, start, stage, e, work);
    span.closest.segment = hint;
    span.touches = columns.places[e] == Place::touches;
    if (span.touches) move_span(model, start, stage, e, work);
  });
}

/// What was found in another hole is void: it has been drilled on since.
void forget_other_hole(const Wellbore& well, StringColumns& columns) noexcept
{
  if (columns.hole == well.version()) return;
  columns.hole = well.version();
  double *nodes = columns.nodes[node_column::room], *elements = columns.elements[element_column::room];
  std::fill(nodes, nodes + columns.node_hints.size(), 0.0);
  std::fill(elements, elements + columns.element_hints.size(), 0.0);
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
