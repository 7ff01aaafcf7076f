// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/hole_cleaning.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/forces/place_drag.h"

namespace drill_rig_sim
{
namespace
{
constexpr double cells_of_hole = 100.0;
constexpr double shortest_cell = 10.0;  // [m]
constexpr double new_hole = 1000.0;     // of new hole [m]
constexpr double narrowest = 1e-3;      // no annulus is taken narrower [m]
constexpr double least_flow = 1e-5;     // below it losses are not compared [m3/s]

/// Of a cell: where it is, and the pipe in it.
struct CellPlace
{
  CuttingsCell cell;
  double md = 0.0;        // of its middle [m]
  double friction = 0.0;  // of the wall [-]
  int element = -1;       // at its middle; -1: none, it is below the bit
};

/// What a walk up the hole adds up.
struct CellSums
{
  double load = 0.0, plain = 0.0, narrowed = 0.0;  // [Pa]
  double bed_height = 0.0;                         // largest [m]
  bool drags = false;
};

/// Cells of a hole with a string in it, from the lowest one up.
class CellWalk
{
public:
  CellWalk(const Model& model, const State& state) noexcept
      : model_(model),
        state_(state),
        bit_depth_(depth_of_bit(model, state)),
        hole_depth_(state.well.hole_depth()),
        segment_(state.nodes.front().segment)
  {
  }

  /// The cell of a depth.
  int cell_at(double md) const noexcept
  {
    const CuttingsState& c = state_.cuttings;
    return std::clamp(static_cast<int>(md / c.cell_length), 0, static_cast<int>(c.bed.size()) - 1);
  }
  int lowest() const noexcept { return cell_at(hole_depth_); }
  int of_bit() const noexcept { return std::min(cell_at(bit_depth_), lowest()); }

  /// Call it for one cell after the other, upwards.
  CellPlace at(int i) noexcept
  {
    const double length = state_.cuttings.cell_length, top = i * length;
    const double bottom = i == lowest() ? hole_depth_ : top + length;
    CellPlace out;
    out.md = 0.5 * (top + bottom);
    const WellNode hole = state_.well.at(out.md, segment_);
    out.cell.length = std::max(0.0, bottom - top);
    out.cell.inclination = std::acos(std::clamp(-hole.tangent.z(), -1.0, 1.0));
    out.friction = hole.friction;
    const double from_bit = i == of_bit() ? std::max(0.0, bit_depth_ - out.md) : bit_depth_ - out.md;
    double inner = 0.0;
    if (from_bit >= 0.0)
    {
      const int last = model_.elements() - 1;
      while (element_ < last && model_.mesh().nodes[static_cast<std::size_t>(element_) + 1].from_bit < from_bit) ++element_;
      out.element = element_;
      inner = model_.mesh().elements[static_cast<std::size_t>(element_)].outer_diameter;
    }
    out.cell.passage = {std::max(2.0 * hole.radius, inner + narrowest), inner, 0.0};
    return out;
  }

private:
  const Model& model_;
  const State& state_;
  double bit_depth_, hole_depth_;
  int segment_, element_ = 0;
};

/// Pressure gradients of the annulus; that of the clean one worked out once for neighbours alike.
class AnnulusLosses
{
public:
  AnnulusLosses(const CuttingsFluid& fluid, double flow) noexcept : fluid_(fluid), flow_(flow) {}

  void add(const CuttingsCell& cell, double open, CellSums& sums) noexcept
  {
    if (flow_ < least_flow) return;
    const double area = cell.passage.area();
    if (cell.passage.outer != known_.outer || cell.passage.inner != known_.inner)
    {
      known_ = cell.passage;
      plain_ = pressure_gradient(fluid_.curve, fluid_.density, known_, flow_ / area);
    }
    const double narrower = area / open;
    sums.plain += cell.length * plain_;
    sums.narrowed +=
        cell.length *
        (narrower > 1.0 ? narrower * pressure_gradient(fluid_.curve, fluid_.density, cell.passage, flow_ / open) : plain_);
  }

private:
  const CuttingsFluid& fluid_;
  double flow_;
  Passage known_;
  double plain_ = 0.0;
};

/// Factor of a bed on the wall's friction.
double friction_of_bed(const Model& model, const CellPlace& place, double height) noexcept
{
  if (place.element < 0 || height <= 0.0) return 1.0;
  const MeshElement& element = model.mesh().elements[static_cast<std::size_t>(place.element)];
  const double weight = model.element_weight(place.element, -1.0, 0.0, full_bore) / element.section.length;
  const double by_wall = place.friction * weight;
  return by_wall > 0.0 ? 1.0 + bed_drag(*model.cuttings(), element.outer_diameter, height) / by_wall : 1.0;
}

/// What a cell does to rig and string.
void add_effects(const Model& model, const CellPlace& place, std::size_t i, AnnulusLosses& losses, CuttingsState& c,
                 CellSums& sums) noexcept
{
  const CuttingsFluid& fluid = *model.cuttings();
  const CuttingsCell& cell = place.cell;
  c.friction[i] = 1.0;
  if (cell.length <= 0.0) return;
  const double open = open_area(fluid, cell, c.bed[i]);
  if (c.bed[i] > 0.0)
  {
    const double height = bed_height(cell.passage, cell.passage.area() - open);
    sums.bed_height = std::max(sums.bed_height, height);
    c.friction[i] = friction_of_bed(model, place, height);
    sums.drags = sums.drags || c.friction[i] > 1.0;
  }
  if (place.element < 0) return;
  sums.load += standard_gravity * (fluid.cuttings.density - fluid.density) * c.suspended[i] * std::cos(cell.inclination) / open;
  losses.add(cell, open, sums);
}

/// Of the bit's face that breaks rock [m2].
double drilled_area(const Model& model, const State& state) noexcept
{
  const double bit = model.bit().diameter, pilot = model.scene().well.pilot_diameter;
  const bool ring = model.pilot().is_ahead(state.well.hole_depth());
  return 0.25 * pi * (bit * bit - (ring ? pilot * pilot : 0.0));
}

void advance_cells(const Model& model, State& state) noexcept
{
  CuttingsState& c = state.cuttings;
  const CuttingsFluid& fluid = *model.cuttings();
  const CuttingsFlow flow{std::max(0.0, c.pumped / c.elapsed), std::abs(state.drive.angle - c.angle) / c.elapsed, c.elapsed};
  const CuttingsFlow rest{0.0, 0.0, c.elapsed};
  const double drilled = drilled_area(model, state) * std::max(0.0, state.well.hole_depth() - c.hole_depth);
  CellWalk walk(model, state);
  AnnulusLosses losses(fluid, flow.flow);
  CellSums sums;
  double moving = 0.0;
  for (int k = walk.lowest(); k >= 0; --k)
  {
    const std::size_t i = static_cast<std::size_t>(k);
    const CellPlace place = walk.at(k);
    if (k == walk.of_bit()) moving += drilled;
    CuttingsContent content{c.suspended[i], c.bed[i]};
    moving = advance_cell(fluid, place.cell, k > walk.of_bit() ? rest : flow, moving, content);
    c.suspended[i] = content.suspended;
    c.bed[i] = content.bed;
    add_effects(model, place, i, losses, c, sums);
  }
  c.drilled += drilled;
  c.returned += moving;
  c.load = sums.load;
  if (sums.plain > 0.0) c.narrowing = sums.narrowed / sums.plain;
  c.bed_height = sums.bed_height;
  c.drags = sums.drags;
}

/// What is collected until the next time begins anew.
void begin_period(const State& state, CuttingsState& c) noexcept
{
  c.elapsed = c.pumped = 0.0;
  c.angle = state.drive.angle;
  c.hole_depth = state.well.hole_depth();
}
}  // namespace

void begin_cuttings(const Model& model, State& state)
{
  CuttingsState& c = state.cuttings;
  c = CuttingsState();
  if (!model.cuttings()) return;
  const double depth = state.well.hole_depth();
  c.cell_length = std::max(depth / cells_of_hole, shortest_cell);
  const std::size_t cells = static_cast<std::size_t>(std::ceil((depth + new_hole) / c.cell_length));
  c.suspended.assign(cells, 0.0);
  c.bed.assign(cells, 0.0);
  c.friction.assign(cells, 1.0);
  begin_period(state, c);
}

void advance_cuttings(const Model& model, double step, State& state) noexcept
{
  CuttingsState& c = state.cuttings;
  if (c.bed.empty() || !model.cuttings()) return;
  c.elapsed += step;
  c.pumped += state.hydraulics.return_flow * step;
  if (c.elapsed < cuttings_period) return;
  advance_cells(model, state);
  begin_period(state, c);
}

double bed_friction(const CuttingsState& cuttings, double md) noexcept
{
  if (!cuttings.drags) return 1.0;
  const double last = static_cast<double>(cuttings.friction.size() - 1);
  const double at = std::clamp(md / cuttings.cell_length - 0.5, 0.0, last);
  const std::size_t i = static_cast<std::size_t>(at), next = std::min(i + 1, cuttings.friction.size() - 1);
  const double share = at - static_cast<double>(i);
  return cuttings.friction[i] + share * (cuttings.friction[next] - cuttings.friction[i]);
}

double cuttings_in_hole(const CuttingsState& cuttings) noexcept
{
  return std::accumulate(cuttings.suspended.begin(), cuttings.suspended.end(), 0.0) +
         std::accumulate(cuttings.bed.begin(), cuttings.bed.end(), 0.0);
}

}  // namespace drill_rig_sim
