// From frame to frame: steps of one length, or steps as their errors allow (numerics.step 0), in strides of several frames.
#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/interpolate.h"
#include "drill_rig_sim/solve/step_control.h"
#include "simulator_impl.h"

namespace drill_rig_sim
{
bool Simulator::Impl::advance_frame(double duration, const Setpoints& setpoints) noexcept
{
  if (variable) return advance_in_strides(duration, setpoints);
  levels.look(*model, state.forces, duration, mechanics(), state.levels);
  const int steps = std::max(1, static_cast<int>(std::lround(duration * scene.numerics.refinement / scene.numerics.step)));
  return take_steps(duration / steps, steps, setpoints);
}

/// Whole, from the state on.
bool Simulator::Impl::take_steps(double step, int steps, const Setpoints& setpoints) noexcept
{
  for (int k = 0; k < steps; ++k)
  {
    if (!variable) advance_mud(*model, setpoints.pump.flow, step, mechanics());
    if (!integrator->advance(mechanics(), step, setpoints)) return false;
  }
  state.forces = integrator->find_forces(mechanics());
  return true;
}

bool Simulator::Impl::advance_in_strides(double duration, const Setpoints& setpoints) noexcept
{
  Stride& stride = state.stride;
  const bool commanded = !(setpoints == stride.setpoints);
  const bool fits = std::abs(std::remainder(stride.length - stride.played, duration)) < time_rounding;
  if ((commanded || !fits) && !settle()) return false;
  stride.steady = commanded ? 0 : stride.steady + 1;
  stride.setpoints = setpoints;
  if (stride.length == 0.0)
  {
    levels.look(*model, state.forces, duration, mechanics(), state.levels);
    if (!begin_stride(duration)) return take_steps(duration, 1, setpoints);
  }
  stride.played += duration;
  if (stride.played < stride.length - time_rounding)
  {
    show_stride();
    return true;
  }
  mechanics() = stride_end;
  state.forces = end_forces;
  stride.length = stride.played = 0.0;
  return true;
}

/// False: there is no step as long as two frames.
bool Simulator::Impl::begin_stride(double duration) noexcept
{
  Stride& stride = state.stride;
  const double longest = std::min(mechanics().step.wanted, longest_step - may_be_longer * duration);
  const double frames = std::min(std::floor(longest / duration + may_be_longer), static_cast<double>(stride.steady));
  if (frames < 2.0) return false;
  if (balance) *balance_before = *balance;
  stride.length = frames * duration;
  if (solve_stride()) return true;
  stride.length = 0.0;
  if (balance) *balance = *balance_before;
  return false;
}

/// The stride's end, from its start, length and set points alone. False: it is too long for one step, and the start wants a shorter one.
bool Simulator::Impl::solve_stride() noexcept
{
  const Stride& stride = state.stride;
  stride_end = mechanics();
  if (!integrator->take_one_step(stride_end, stride.length, stride.setpoints))
  {
    mechanics().step.wanted = stride_end.step.wanted;
    return false;
  }
  end_forces = integrator->find_forces(stride_end);
  between = stride_end;
  return true;
}

void Simulator::Impl::show_stride() noexcept
{
  const double share = state.stride.played / state.stride.length;
  interpolate(mechanics(), stride_end, share, between);
  between.time = now();
  interpolate(state.forces, end_forces, share, forces_between);
}

/// The state is at the last frame's end.
bool Simulator::Impl::settle() noexcept
{
  Stride& stride = state.stride;
  if (stride.length == 0.0) return true;
  const double played = stride.played;
  stride.length = stride.played = 0.0;
  if (balance) *balance = *balance_before;
  return take_steps(played, 1, stride.setpoints);
}

double Simulator::Impl::hole_depth() const noexcept
{
  const double start = state.mechanics.well.hole_depth();
  const Stride& stride = state.stride;
  return stride.length > 0.0 ? start + stride.played / stride.length * (stride_end.well.hole_depth() - start) : start;
}

}  // namespace drill_rig_sim
