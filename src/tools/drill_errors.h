// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_ERRORS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_ERRORS_H

#include <array>

#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// The largest errors that a run measured beside its companion (numerics.companion), by output.
class LargestErrors
{
public:
  struct Entry
  {
    double error = 0.0;  ///< over 3 s [-]
    double until = 0.0;  ///< end of these [s]
  };

  /// After each frame. Nothing is kept where nothing is measured.
  void add(const Simulator& simulator)
  {
    const SimulatorStatistics& now = simulator.statistics();
    if (!now.error_is_measured) return;
    measured_ = true;
    for (std::size_t i = 0; i < output_count; ++i)
      if (now.errors[i] > entries_[i].error) entries_[i] = {now.errors[i], simulator.truth().time};
  }

  bool measured() const noexcept { return measured_; }
  const Entry& of(Output output) const noexcept { return entries_[static_cast<std::size_t>(output)]; }

private:
  bool measured_ = false;
  std::array<Entry, output_count> entries_;
};

}  // namespace drill_rig_sim

#endif
