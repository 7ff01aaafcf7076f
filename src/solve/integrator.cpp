// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/solve/integrator.h"

#include <utility>

#include "drill_rig_sim/model/evaluate.h"

namespace drill_rig_sim
{
Integrator::Integrator(std::shared_ptr<const Model> model) : model_(std::move(model)), stage_(*model_), work_(*model_)
{
}

const RigForces& Integrator::find_forces(const State& state) noexcept
{
  find_string_forces(*model_, state, stage_, work_);
  return work_.result.forces;
}

}  // namespace drill_rig_sim
