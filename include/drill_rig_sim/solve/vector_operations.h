#ifndef DRILL_RIG_SIM_SOLVE_VECTOR_OPERATIONS_H
#define DRILL_RIG_SIM_SOLVE_VECTOR_OPERATIONS_H

struct _generic_N_Vector;  // NOLINT(bugprone-reserved-identifier): what SUNDIALS calls it

namespace drill_rig_sim
{
/// Puts vectorised sums, scaling, constants and norms in the place of a serial SUNDIALS vector's own, for it and its clones.
/// Debian's library takes some twenty instructions a number: with it, vector sums would be half of what an ARKODE step costs, and
/// a comparison of methods would be one of builds.
void vectorise_operations(_generic_N_Vector* vector);

}  // namespace drill_rig_sim

#endif
