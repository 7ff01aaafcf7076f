// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SOLVE_SUNDIALS_H
#define DRILL_RIG_SIM_SRC_SOLVE_SUNDIALS_H

#include <ida/ida.h>
#include <kinsol/kinsol.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_nvector.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>
#if SUNDIALS_VERSION_MAJOR >= 6
#include <arkode/arkode_arkstep.h>
#include <sundials/sundials_context.h>
#endif

#include <memory>
#include <type_traits>

/// What differs between SUNDIALS 4 (Debian 11), 6 (Debian 12) and 7 (Debian 13), and who frees what SUNDIALS hands out.
#if SUNDIALS_VERSION_MAJOR < 6
// nothing is made by a context, which came with 6
using SUNContext = struct NoSundialsContext
{
}*;
using SUNATimesFn = ATimesFn;
#endif

namespace drill_rig_sim
{
/// SUNLS_SUCCESS and SUN_NLS_SUCCESS of SUNDIALS 4 and 6, SUN_SUCCESS of 7.
constexpr int kSundialsSuccess = 0;

/// The context is freed last.
struct FreeSundials
{
#if SUNDIALS_VERSION_MAJOR >= 6
  void operator()(SUNContext context) const
  {
    SUNContext_Free(&context);
  }
#else
  void operator()(SUNContext context) const
  {
    delete context;
  }
#endif
  void operator()(N_Vector vector) const
  {
    N_VDestroy(vector);
  }
  void operator()(SUNMatrix matrix) const
  {
    SUNMatDestroy(matrix);
  }
  void operator()(SUNLinearSolver solver) const
  {
    SUNLinSolFree(solver);
  }
  void operator()(SUNNonlinearSolver solver) const
  {
    SUNNonlinSolFree(solver);
  }
};

using OwnedContext = std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeSundials>;
using OwnedVector = std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeSundials>;
using OwnedMatrix = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, FreeSundials>;
using OwnedLinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, FreeSundials>;
using OwnedNonlinearSolver = std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, FreeSundials>;

/// A context without MPI. Empty if SUNDIALS could not create one. The solvers' flags are checked, so they print no errors: with
/// SUNDIALS 7 by the context, with 4 and 6 by silence_...() of each solver.
inline OwnedContext new_context()
{
#if SUNDIALS_VERSION_MAJOR >= 6
  SUNContext context = nullptr;
#if SUNDIALS_VERSION_MAJOR >= 7
  if (SUNContext_Create(SUN_COMM_NULL, &context) != 0) return {};
  SUNContext_ClearErrHandlers(context);
#else
  if (SUNContext_Create(nullptr, &context) != 0) return {};
#endif
  return OwnedContext(context);
#else
  return OwnedContext(new NoSundialsContext());
#endif
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
#if SUNDIALS_VERSION_MAJOR >= 6
inline void silence_arkode(void* memory)
{
  ARKStepSetErrHandlerFn(memory, ignore_error, nullptr);
}
#endif
#endif

#if SUNDIALS_VERSION_MAJOR >= 6
inline OwnedVector new_vector(sunindextype size, SUNContext context)
{
  return OwnedVector(N_VNew_Serial(size, context));
}
/// A vector of the numbers from `first` on, which it does not own.
inline OwnedVector vector_of(sunindextype size, double* first, SUNContext context)
{
  return OwnedVector(N_VMake_Serial(size, first, context));
}
inline OwnedMatrix new_sparse_matrix(sunindextype size, sunindextype nonzeros, SUNContext context)
{
  return OwnedMatrix(SUNSparseMatrix(size, size, nonzeros, CSC_MAT, context));
}
inline OwnedLinearSolver new_klu(N_Vector vector, SUNMatrix matrix, SUNContext context)
{
  return OwnedLinearSolver(SUNLinSol_KLU(vector, matrix, context));
}
inline OwnedLinearSolver new_linear_solver(SUNContext context)
{
  return OwnedLinearSolver(SUNLinSolNewEmpty(context));
}
inline void* new_kinsol(SUNContext context)
{
  return KINCreate(context);
}
inline void* new_ida(SUNContext context)
{
  return IDACreate(context);
}
inline sunindextype size_of(N_Vector vector)
{
  return N_VGetLength(vector);
}
/// No step is shorter.
inline void set_smallest_step(void* ida, double step)
{
  IDASetMinStep(ida, step);
}
#else
inline OwnedVector new_vector(sunindextype size, SUNContext)
{
  return OwnedVector(N_VNew_Serial(size));
}
inline OwnedVector vector_of(sunindextype size, double* first, SUNContext)
{
  return OwnedVector(N_VMake_Serial(size, first));
}
inline OwnedMatrix new_sparse_matrix(sunindextype size, sunindextype nonzeros, SUNContext)
{
  return OwnedMatrix(SUNSparseMatrix(size, size, nonzeros, CSC_MAT));
}
inline OwnedLinearSolver new_klu(N_Vector vector, SUNMatrix matrix, SUNContext)
{
  return OwnedLinearSolver(SUNLinSol_KLU(vector, matrix));
}
/// SUNLinSolNewEmpty() and SUNLinSolFreeEmpty() came with 5.
inline OwnedLinearSolver new_linear_solver(SUNContext)
{
  auto* solver = new _generic_SUNLinearSolver();
  solver->ops = new _generic_SUNLinearSolver_Ops();
  return OwnedLinearSolver(solver);
}
inline void* new_kinsol(SUNContext)
{
  return KINCreate();
}
inline void* new_ida(SUNContext)
{
  return IDACreate();
}
inline sunindextype size_of(N_Vector vector)
{
  return N_VGetLength_Serial(vector);
}
/// IDASetMinStep() came with 6: an error test that fails still shortens a step.
inline void set_smallest_step(void*, double)
{
}
#endif

/// The `free` of a linear solver of ours, whose content is not its own.
inline int free_without_content(SUNLinearSolver solver)
{
#if SUNDIALS_VERSION_MAJOR >= 6
  solver->content = nullptr;
  SUNLinSolFreeEmpty(solver);
#else
  delete solver->ops;
  delete solver;
#endif
  return kSundialsSuccess;
}

}  // namespace drill_rig_sim

#endif
