// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SOLVE_SUNDIALS_H
#define DRILL_RIG_SIM_SRC_SOLVE_SUNDIALS_H

#include <arkode/arkode_arkstep.h>
#include <ida/ida.h>
#include <kinsol/kinsol.h>
#include <sundials/sundials_config.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_nvector.h>

#include <memory>
#include <type_traits>

/// What differs between SUNDIALS 6 (Debian 12) and 7 (Debian 13), and who frees what SUNDIALS hands out.
namespace drill_rig_sim
{
/// SUNLS_SUCCESS and SUN_NLS_SUCCESS of SUNDIALS 6, SUN_SUCCESS of 7.
constexpr int kSundialsSuccess = 0;

/// The context is freed last.
struct FreeSundials
{
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
  void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
};

using OwnedContext = std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeSundials>;
using OwnedVector = std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeSundials>;
using OwnedMatrix = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, FreeSundials>;
using OwnedLinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, FreeSundials>;
using OwnedNonlinearSolver = std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, FreeSundials>;

/// A context without MPI. Empty if SUNDIALS could not create one. The solvers' flags are checked, so they print no errors: with
/// SUNDIALS 7 by the context, with 6 by silence_...() of each solver.
inline OwnedContext new_context()
{
  SUNContext context = nullptr;
#if SUNDIALS_VERSION_MAJOR >= 7
  if (SUNContext_Create(SUN_COMM_NULL, &context) != 0) return {};
  SUNContext_ClearErrHandlers(context);
#else
  if (SUNContext_Create(nullptr, &context) != 0) return {};
#endif
  return OwnedContext(context);
}

#if SUNDIALS_VERSION_MAJOR >= 7
inline void silence_kinsol(void*)
{
}
inline void silence_ida(void*)
{
}
inline void silence_arkode(void*)
{
}
#else
inline void ignore_error(int, const char*, const char*, char*, void*)
{
}
inline void silence_kinsol(void* memory)
{
  KINSetErrHandlerFn(memory, ignore_error, nullptr);
}
inline void silence_ida(void* memory)
{
  IDASetErrHandlerFn(memory, ignore_error, nullptr);
}
inline void silence_arkode(void* memory)
{
  ARKStepSetErrHandlerFn(memory, ignore_error, nullptr);
}
#endif

/// The `free` of a linear solver of ours, whose content is not its own.
inline int free_without_content(SUNLinearSolver solver)
{
  solver->content = nullptr;
  SUNLinSolFreeEmpty(solver);
  return kSundialsSuccess;
}

}  // namespace drill_rig_sim

#endif
