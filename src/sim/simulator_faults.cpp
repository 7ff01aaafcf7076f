// What goes wrong while a simulator runs, between its frames.
#include "drill_rig_sim/crew/refusals.h"
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
  if (const char* wrong = what_is_wrong(impl_->model->scene(), truth.bit_depth, truth.hole_depth, fault)) return wrong;
  if (is_of_gauge(fault.kind))
  {
    begin(fault, impl_->state.instruments.fault_of(fault.gauge));
    impl_->lead([&fault](Impl& companion) { begin(fault, companion.state.instruments.fault_of(fault.gauge)); });
    return nullptr;
  }
  impl_->begin_fault(fault);
  impl_->lead([&fault](Impl& companion) { companion.begin_fault(fault); });
  return nullptr;
}

void Simulator::clear(FaultKind kind, Gauge gauge) noexcept
{
  if (is_of_gauge(kind))
  {
    end(kind, impl_->state.instruments.fault_of(gauge));
    impl_->lead([=](Impl& companion) { end(kind, companion.state.instruments.fault_of(gauge)); });
    return;
  }
  if (kind == FaultKind::stuck_pipe && impl_->mechanics().stuck_point.node < 0) return;
  impl_->end_fault(kind);
  impl_->lead([kind](Impl& companion) { companion.end_fault(kind); });
}

ActiveFaults Simulator::active_faults() const noexcept
{
  ActiveFaults faults;
  faults.of_rig = drill_rig_sim::active_faults(impl_->mechanics());
  for (int g = 0; g < gauge_count; ++g)
    faults.of_gauges[static_cast<std::size_t>(g)] = drill_rig_sim::active_faults(impl_->state.instruments.fault_of(static_cast<Gauge>(g)));
  return faults;
}

/// Of the rig, not of a gauge.
void Simulator::Impl::begin_fault(const Fault& fault) noexcept
{
  settle();
  begin(*model, state.truth.bit_depth, fault, mechanics());
}

void Simulator::Impl::end_fault(FaultKind kind) noexcept
{
  settle();
  end(kind, mechanics());
}

}  // namespace drill_rig_sim
