#ifndef DRILL_RIG_SIM_SRC_SOLVE_SUNDIALS_OWNERS_H
#define DRILL_RIG_SIM_SRC_SOLVE_SUNDIALS_OWNERS_H

#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_nvector.h>

#include <memory>

namespace drill_rig_sim
{
/// What SUNDIALS hands out is freed by these; the context last.
struct FreeSundials
{
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
  void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
};

using OwnedContext = std::unique_ptr<_SUNContext, FreeSundials>;
using OwnedVector = std::unique_ptr<_generic_N_Vector, FreeSundials>;
using OwnedMatrix = std::unique_ptr<_generic_SUNMatrix, FreeSundials>;
using OwnedLinearSolver = std::unique_ptr<_generic_SUNLinearSolver, FreeSundials>;
using OwnedNonlinearSolver = std::unique_ptr<_generic_SUNNonlinearSolver, FreeSundials>;

/// The `free` of a linear solver of ours, whose content is not its own.
inline int free_without_content(SUNLinearSolver solver)
{
  solver->content = nullptr;
  SUNLinSolFreeEmpty(solver);
  return SUNLS_SUCCESS;
}

/// For a solver's error handler: its flag is enough, standard error stays clean.
inline void silent(int, const char*, const char*, char*, void*)
{
}

}  // namespace drill_rig_sim

#endif
