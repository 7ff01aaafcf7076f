// What goes wrong while a simulator runs, between its frames.
#include "drill_rig_sim/sim/faults.h"
#include "simulator_impl.h"

namespace drill_rig_sim
{
bool Simulator::stick_pipe(double md) noexcept
{
  return !inject({FaultKind::stuck_pipe, md, 0.0, Gauge::hook_load});
}

void Simulator::free_pipe() noexcept
{
  clear(FaultKind::stuck_pipe, Gauge::hook_load);
}

const char* Simulator::inject(const Fault& fault) noexcept
{
  const Truth& truth = impl_->state.truth;
  if (const char* wrong = what_is_wrong(*impl_->model, truth.bit_depth, truth.hole_depth, fault)) return wrong;
  if (is_of_gauge(fault.kind))
  {
    begin(fault, impl_->state.instruments.fault_of(fault.gauge));
    return nullptr;
  }
  impl_->settle();
  begin(*impl_->model, truth.bit_depth, fault, impl_->mechanics());
  return nullptr;
}

void Simulator::clear(FaultKind kind, Gauge gauge) noexcept
{
  if (is_of_gauge(kind)) return end(kind, impl_->state.instruments.fault_of(gauge));
  if (kind == FaultKind::stuck_pipe && impl_->mechanics().stuck_point.node < 0) return;
  impl_->settle();
  end(kind, impl_->mechanics());
}

}  // namespace drill_rig_sim
