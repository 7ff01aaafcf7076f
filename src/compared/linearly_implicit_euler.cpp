// SPDX-License-Identifier: BSD-3-Clause
// Linearly implicit Euler: implicit Euler with its forces linearised about the start of the step, which is one Newton iteration
// from u = 0. Hairer and Wanner, Solving ODEs II, IV.9.
#include <algorithm>

#include "drill_rig_sim/solve/methods/method.h"

namespace drill_rig_sim
{
namespace
{
bool step_linearly_implicit_euler(StepContext& context) noexcept
{
  prepare_implicit_euler(context.state, context.step, context.stage);
  std::fill(context.u, context.u + 6 * context.model.nodes(), 0.0);
  ++context.iterations;
  if (!context.newton.improve(context.at_stage(), context.u)) return false;
  update(context.model, context.state, context.stage, context.u, context.work);
  return true;
}
}  // namespace

const Method linearly_implicit_euler = {IntegratorKind::linearly_implicit_euler,
                                        "linearly_implicit_euler",
                                        "linearly implicit Euler, first order, one solve without iteration",
                                        step_linearly_implicit_euler,
                                        nullptr,
                                        0,
                                        false,
                                        nullptr,
                                        nullptr};

}  // namespace drill_rig_sim
