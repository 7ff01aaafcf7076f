// SPDX-License-Identifier: BSD-3-Clause
#include "rig_actions.h"

#include "drill_rig_sim/crew/refusals.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/faults.h"

namespace drill_rig_sim
{
const char* RigActions::set_slips(int joint) noexcept
{
  if (const char* refused = rig_.pipe.why_not_set(joint)) return refused;
  rig_.pipe.set_slips(joint);
  const double from_bit = rig_.pipe.place_of(joint);
  companions_.lead([from_bit](SimulatedRig& companion) { companion.pipe.set_slips(companion.pipe.joint_at(from_bit)); });
  return nullptr;
}

const char* RigActions::pull_slips() noexcept
{
  if (const char* refused = rig_.pipe.why_not_pulled()) return refused;
  do_to_all([](SimulatedRig& rig) { rig.pipe.pull_slips(); });
  return nullptr;
}

const char* RigActions::make_connection(int joints, bool remove) noexcept
{
  if (const char* refused = rig_.pipe.why_no_connection(joints, remove)) return refused;
  const double length = rig_.pipe.length_of(joints, remove);
  if (const char* refused = rig_.pipe.begin_connection(length)) return refused;
  companions_.lead(
      [length](SimulatedRig& companion)
      {
        if (const char* refused = companion.pipe.begin_connection(length)) companion.fail(refused);
      });
  return nullptr;
}

void RigActions::finish_connection()
{
  if (!rig_.pipe.is_made_up()) return;
  companions_.lead([](SimulatedRig& companion) { companion.end_connection(); });
  rig_.end_connection();
}

bool RigActions::tare() noexcept
{
  if (rig_.state.truth.on_bottom || rig_.state.truth.in_slips) return false;
  do_to_all([](SimulatedRig& rig) { rig.measurement.tare(); });
  return true;
}

bool RigActions::tare_over(double duration, Zero& zero) noexcept
{
  if (rig_.state.truth.on_bottom || rig_.state.truth.in_slips) return false;
  if (!(rig_.measurement.zero_held() >= duration - time_rounding)) return false;
  zero = rig_.measurement.tare_over(duration);
  companions_.lead([duration](SimulatedRig& companion) { companion.measurement.tare_over(duration); });
  return true;
}

const char* RigActions::inject(const Fault& fault) noexcept
{
  const Truth& truth = rig_.state.truth;
  if (const char* wrong = what_is_wrong(rig_.motion.model()->scene(), truth.bit_depth, truth.hole_depth, fault)) return wrong;
  if (is_of_gauge(fault.kind))
    do_to_all([&fault](SimulatedRig& rig) { begin(fault, rig.measurement.fault_of(fault.gauge)); });
  else
    do_to_all(
        [&fault](SimulatedRig& rig)
        {
          const Model& model = *rig.motion.model();
          const double bit_depth = rig.state.truth.bit_depth;
          rig.motion.change([&](State& state) { begin(model, bit_depth, fault, state); });
        });
  return nullptr;
}

void RigActions::clear(FaultKind kind, Gauge gauge) noexcept
{
  if (is_of_gauge(kind))
    do_to_all([=](SimulatedRig& rig) { end(kind, rig.measurement.fault_of(gauge)); });
  else if (kind != FaultKind::stuck_pipe || rig_.state.mechanics.stuck_point.node >= 0)
    do_to_all([kind](SimulatedRig& rig) { rig.motion.change([kind](State& state) { end(kind, state); }); });
}

}  // namespace drill_rig_sim
