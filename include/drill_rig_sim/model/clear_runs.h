// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_CLEAR_RUNS_H
#define DRILL_RIG_SIM_MODEL_CLEAR_RUNS_H

#include "drill_rig_sim/model/guides.h"

namespace drill_rig_sim
{
/// Calls batch(run) for the longest runs within these that hold no node i of which set(i) is true.
template <class Set, class Batch>
void each_clear_run(const Runs& runs, const Set& set, const Batch& batch)
{
  for (const Runs::Run& run : runs)
    for (int i = run.first, first = i; i < run.last; first = ++i)
    {
      while (i < run.last && !set(i)) ++i;
      if (i > first) batch(Runs::Run{first, i});
    }
}

}  // namespace drill_rig_sim

#endif
