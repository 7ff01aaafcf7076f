// Zeros of the weight on bit and of the differential pressure.
#include "drill_rig_sim/math/units.h"
#include "simulator_impl.h"

namespace drill_rig_sim
{
/// How the string as it is built rings: of zeros of the weight.
void Simulator::Impl::note_ring()
{
  const HoistingSpec& hoisting = scene.rig.hoisting;
  const double period = HungString(model->mesh(), hoisting, scene.start.block_height).ring_period(hoisting.block_mass);
  state.zero_mean.rings_with(period);
  state.instruments.rings_with(period);
}

bool Simulator::Impl::tare() noexcept
{
  if (state.truth.on_bottom || state.truth.in_slips) return false;
  const auto zero = [](Impl& rig)
  {
    rig.take_zero(rig.state.zero_mean.mean());
    rig.state.instruments.tare(rig.state.readings);
  };
  zero(*this);
  lead(zero);
  return true;
}

bool Simulator::Impl::tare_over(double duration, Zero& zero) noexcept
{
  if (state.truth.on_bottom || state.truth.in_slips || !(state.instruments.zero_held() >= duration - time_rounding)) return false;
  const auto zeroed = [duration](Impl& rig)
  {
    rig.take_zero(rig.state.zero_mean.window().over(duration).hook_load);
    return rig.state.instruments.tare_over(duration, rig.state.readings);
  };
  zero = zeroed(*this);
  lead(zeroed);
  return true;
}

void Simulator::Impl::take_zero(double hook_load) noexcept
{
  state.tared = true;
  state.tare_hook_load = hook_load;
  state.tare_pressure += state.truth.differential_pressure;
  measure_rig();
}

bool Simulator::tare() noexcept
{
  return impl_->tare();
}

bool Simulator::tare_over(double duration, Zero& zero) noexcept
{
  return impl_->tare_over(duration, zero);
}

double Simulator::zero_held() const noexcept
{
  return impl_->state.instruments.zero_held();
}

}  // namespace drill_rig_sim
