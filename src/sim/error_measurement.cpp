// SPDX-License-Identifier: BSD-3-Clause
#include "error_measurement.h"

namespace drill_rig_sim
{
ErrorMeasurement::ErrorMeasurement(SimulatedRig& rig, Companions& companions) noexcept
    : rig_(rig), companions_(companions), measured_(rig.state.measured), statistics_(rig.statistics)
{
}

void ErrorMeasurement::begin(double error_over_difference) noexcept
{
  measured_ = MeasuredError(error_over_difference);
}

bool ErrorMeasurement::has_companion() const noexcept
{
  return rig_.scene.numerics.companion != CompanionKind::none && companions_.count() > 0;
}

void ErrorMeasurement::make_room() noexcept
{
  while (companions_.is_full())
  {
    companions_.wait_for_one();
    collect();
  }
}

/// Takes what the companion has computed.
void ErrorMeasurement::collect() noexcept
{
  while (const FrameOrder* order = companions_.result())
  {
    if (is_under_way())
    {
      measured_.add_companion(order->outputs);
      statistics_.companion = order->companion;
    }
    companions_.take();
  }
}

void ErrorMeasurement::collect_all() noexcept
{
  companions_.wait_for_all();
  collect();
}

void ErrorMeasurement::judge(double duration) noexcept
{
  const NumericsSpec& numerics = rig_.scene.numerics;
  if (is_under_way()) measured_.add_run(rig_.measurement.judged(), rig_.state.truth.top_drive_speed, duration);
  collect();
  compare_frames();
  statistics_.error_is_measured = is_under_way();
  if (!statistics_.error_is_measured) return;
  statistics_.errors = measured_.errors();
  const OutputError largest = largest_of(measured_.lasting(statistics_.errors, numerics.tolerance, duration), rig_.scene.needs);
  if (largest.error > 0.0)
    rig_.measurement.warn_of_error({AccuracyDoubt::measured, largest.error, 0.0, 0.0, numerics.tolerance, largest.output,
                                    measured_.statistics(largest.output)});
}

void ErrorMeasurement::compare_frames() noexcept
{
  while (is_under_way() && measured_.due())
  {
    if (!measured_.ready() && companions_.pace() == CompanionPace::own_thread_unwaited)
    {
      if (measured_.is_full()) end("the companion was too slow for real time: no processor core was free for it");
      return;
    }
    while (!measured_.ready())
    {
      companions_.wait_for_one();
      collect();
    }
    if (!measured_.compare()) end(companions_.first_failure());
  }
}

void ErrorMeasurement::end(const char* reason) noexcept
{
  companions_.end();
  statistics_.not_measured = reason;
}

void ErrorMeasurement::restore(const SimulatorState& saved)
{
  companions_.restore(saved);
  if (!has_companion()) return;
  if (saved.companion_ended) companions_.fail_first("the companion had ended when the state was saved");
  if (*companions_.first_failure()) companions_.end();
  statistics_.not_measured = companions_.first_failure();
}

}  // namespace drill_rig_sim
