// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_VECTOR_OPERATIONS_H
#define DRILL_RIG_SIM_SOLVE_VECTOR_OPERATIONS_H

struct _generic_N_Vector;  // NOLINT(bugprone-reserved-identifier): what SUNDIALS calls it

namespace drill_rig_sim
{
/// Replaces sums, scaling, constants and norms of a serial SUNDIALS vector by vectorised ones, also for its clones. Debian's
/// library needs some twenty instructions per number. Vector sums would take half of an ARKODE step, and a comparison of methods
/// would compare builds.
void vectorise_operations(_generic_N_Vector* vector);

}  // namespace drill_rig_sim

#endif
