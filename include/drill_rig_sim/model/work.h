// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_WORK_H
#define DRILL_RIG_SIM_MODEL_WORK_H

#include <cstdint>

namespace drill_rig_sim
{
/// Work since the start, the measure of cost that does not depend on the machine.
struct Work
{
  std::uint64_t residuals = 0;      ///< all forces at one state
  std::uint64_t tangents = 0;       ///< with a residual each, counted there too
  std::uint64_t solves = 0;         ///< factorisation and solution of the block-tridiagonal system
  std::uint64_t substitutions = 0;  ///< solutions with factors that were there already
};

}  // namespace drill_rig_sim

#endif
