// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_ONE_STEP_H
#define DRILL_RIG_SIM_TEST_ONE_STEP_H

#include <vector>

#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/solve/methods/method.h"
#include "drill_rig_sim/solve/start.h"

namespace drill_rig_sim
{
/// What an implicit Euler step of `step` [s] comes to that moves the first nodes of `rig` by the increments `u` (6 per node, the
/// others stay): into `work`.
inline void evaluate_one_step(const RigAtRest& rig, double step, std::vector<double> u, Workspace& work)
{
  Stage stage(*rig.model);
  begin_step(*rig.model, rig.state, step, Setpoints(), stage);
  prepare_implicit_euler(rig.state, step, stage);
  u.resize(6 * static_cast<std::size_t>(rig.model->nodes()), 0.0);
  std::vector<double> residual(u);
  evaluate(*rig.model, rig.state, stage, u.data(), work, residual.data(), nullptr);
}

}  // namespace drill_rig_sim

#endif
