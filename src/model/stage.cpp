// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/stage.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/forces/hoisting.h"
#include "drill_rig_sim/model/forces/pads.h"
#include "drill_rig_sim/model/forces/place_drag.h"
#include "drill_rig_sim/model/kernels/guided_kernel.h"
#include "drill_rig_sim/model/pointing.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
/// Of the mud that moves sideways with a node [kg].
double mud_mass(const MeshNode& node, const NodeState& at, const Wellbore& well, double bore_top) noexcept
{
  const double inside = node.from_bit < bore_top ? node.mud_inside : 0.0;
  return inside + confinement(node.diameter, 2.0 * well.radius_near(at.position, at.segment)) * node.mud_outside;
}

Vector3d up_along(const State& state, std::size_t e) noexcept
{
  return (state.nodes[e + 1].position - state.nodes[e].position).normalized();
}

/// What weight and the mud's pressures do to the elements (mud_circuit.h).
void take_loads(const Model& model, const State& state, Stage& stage) noexcept
{
  const MudCircuit& mud = model.mud();
  const MudPressures pressures = pressures_in_mud(model, state);
  const bool pumped = pressures.any();
  const double bore_top = state.hydraulics.bore_top;
  const double lifts = pumped ? pressures.annulus - state.cuttings.load - stage.drags[0].pressure : 0.0;
  for (std::size_t e = 0; e < state.spans.size(); ++e)
  {
    const Vector3d &lower = state.nodes[e].position, &upper = state.nodes[e + 1].position;
    const double weight = model.element_weight(static_cast<int>(e), lower.z(), upper.z(), bore_top), lift = mud.lift[e] * lifts;
    Vector3d load = lift != 0.0 ? Vector3d(lift * up_along(state, e)) : Vector3d(Vector3d::Zero());
    load.z() -= weight;
    stage.load.set(e, load);
    stage.free_stretch[e] = state.spans[e].free_stretch;
    if (pumped)
      stage.free_stretch[e] +=
          mud.stretch_by_bore[e] * pressures.in_bore(mud, e) + mud.stretch_by_annulus[e] * pressures.in_annulus(mud, e);
  }
  if (stage.drags[0].pressure <= 0.0) return;
  const std::size_t packed = static_cast<std::size_t>(std::min(stage.drags[0].node, model.elements() - 1));
  const double lift = stage.drags[0].pressure * model.mesh().elements[packed].outer_area;
  stage.load.set(packed, stage.load[packed] + lift * up_along(state, packed));
}

/// What the state says of the step that starts from it.
void take_start(const Model& model, const State& state, Stage& stage) noexcept
{
  const double bore_top = state.hydraulics.bore_top;
  for (std::size_t i = 0; i < stage.normal.size(); ++i)
  {
    stage.normal[i] = x_axis(state.nodes[i].orientation);
    stage.immersed[i] = state.nodes[i].position.z() < 0.0 ? 1.0 : 0.0;
    stage.added_mass[i] = stage.immersed[i] > 0.0 && !state.nodes[i].guided
                              ? mud_mass(model.mesh().nodes[i], state.nodes[i], state.well, bore_top)
                              : 0.0;
  }
  find_drags(model, state, stage);
  take_loads(model, state, stage);
  find_guides(model, state, stage);
}
}  // namespace

Stage::Stage(const Model& model)
    : rate(model.mesh().nodes.size(), Vector6d::Zero()),
      acceleration(rate),
      normal(rate.size(), -Vector3d::UnitZ()),
      guides(rate.size()),
      guided_kernel(drill_rig_sim::guided_kernel(model.kernel())),
      guided_step_kernel(drill_rig_sim::guided_step_kernel(model.kernel())),
      guided_nodes(rate.size()),
      guided_elements(model.mesh().elements.size()),
      inner_nodes(rate.size())
{
  ColumnSizes::resize(*this, rate.size());
  prepare_guides(model, *this);
}

void begin_step(const Model& model, const State& state, double step, const Setpoints& setpoints, Stage& stage) noexcept
{
  stage.structural_damping = model.scene().numerics.structural_damping;
  stage.setpoints = setpoints;
  take_start(model, state, stage);
  find_pads(model, state, setpoints, stage);
  move_stage(model, state, step, stage);
}

void move_stage(const Model& model, const State& state, double time, Stage& stage) noexcept
{
  stage.time = time;
  stage.hoist = time > 0.0 ? advance_hoist(model, state, stage.setpoints, time) : state.hoist;
  stage.lean = lean_after(model, state, stage.setpoints, time);
  const double motor = state.bit.motor_speed;
  const double mean = state.bit.mean_speed;
  stage.bit = {motor, time * motor, mean, drilling_speed(mean, state.nodes[0].rate.spin + motor), time, false, Vector3d::Zero()};
}

void begin_static(const Model& model, const State& state, const SlidingMotion& sliding, double coefficient, Stage& stage) noexcept
{
  stage.time = 0.0;
  stage.dv_du = coefficient;
  stage.da_du = coefficient * coefficient;
  stage.structural_damping = 0.0;
  stage.pads = Pads();
  stage.lean = lean_after(model, state, Setpoints(), 0.0);
  stage.sliding = sliding;
  std::fill(stage.rate.begin(), stage.rate.end(), Vector6d::Zero());
  std::fill(stage.acceleration.begin(), stage.acceleration.end(), Vector6d::Zero());
  take_start(model, state, stage);
}

}  // namespace drill_rig_sim
