// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/finer_pair.h"

#include <stdexcept>
#include <string>

#include "drill_rig_sim/accuracy/measured_error.h"
#include "drill_rig_sim/accuracy/refined.h"

namespace drill_rig_sim
{
namespace
{
static_assert(least_refinement == 1.2 && most_refinement == 8.0, "the text has these numbers");

double checked(double times)
{
  if (!(times >= least_refinement && times <= most_refinement))
    throw std::runtime_error("times must be between 1.2 and 8 (got " + std::to_string(times) + ")");
  return times;
}

/// The number of the finer model: of the run's own companion where that is as fine.
int finer_of(Simulator& simulator, double times)
{
  const bool is_there = simulator.companions() > 0 && simulator.scene().numerics.companion == CompanionKind::finer &&
                        times == traits_of(CompanionKind::finer).refinement;
  return is_there ? 0 : simulator.add_companion(refined(with_free_nodes(simulator.scene().numerics), times));
}

Outputs errors_of(const Simulator& simulator) noexcept
{
  Outputs errors;
  for (std::size_t i = 0; i < output_count; ++i) errors[i] = simulator.measured_error(static_cast<Output>(i));
  return errors;
}
}  // namespace

FinerPair::FinerPair(Simulator& simulator, double times)
    : times_(checked(times)),
      finer_(finer_of(simulator, times)),
      finest_(simulator.add_companion(refined(with_free_nodes(simulator.scene().numerics), times * times))),
      findings_(simulator.scene().numerics.tolerance, simulator.scene().needs)
{
}

void FinerPair::add(const Simulator& simulator, double duration)
{
  for (const int i : {finer_, finest_})
    if (const char* why = simulator.companion_failure(i); *why)
      throw std::runtime_error("a finer model failed: " + std::string(why));
  const Truth& m = simulator.truth();
  findings_.add(outputs_of(m), outputs_of(simulator.companion_truth(finer_)), outputs_of(simulator.companion_truth(finest_)),
                m.accuracy_warning, errors_of(simulator), m.time, duration);
}

const char* word_of(Verification::Verdict verdict) noexcept
{
  constexpr const char* words[] = {"right", "warned", "missed", "unknown"};
  return words[static_cast<std::size_t>(verdict)];
}

}  // namespace drill_rig_sim
