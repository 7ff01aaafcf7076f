// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/solve/kinsol_equilibrium.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "sundials.h"

namespace drill_rig_sim
{
namespace
{
/// What KINSOL's callbacks reach through its user data.
struct Session
{
  const NonlinearProblem* problem;
  std::vector<double> last_u;  // the line search evaluates its accepted point last, so this is where the tangent is wanted
};

int residual_callback(N_Vector u, N_Vector f, void* data)
{
  auto* session = static_cast<Session*>(data);
  const double* values = N_VGetArrayPointer(u);
  session->last_u.assign(values, values + session->last_u.size());
  session->problem->residual(values, N_VGetArrayPointer(f));
  return 0;
}

int solve_callback(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, double)
{
  auto* session = static_cast<Session*>(solver->content);
  N_VScale(1.0, b, x);
  return session->problem->solve_tangent(session->last_u.data(), N_VGetArrayPointer(x)) ? kSundialsSuccess
                                                                                        : SUNLS_PACKAGE_FAIL_REC;
}

SUNLinearSolver_Type type_callback(SUNLinearSolver)
{
  return SUNLINEARSOLVER_ITERATIVE;  // KINSOL then asks for no SUNMatrix
}

int products_callback(SUNLinearSolver, void*, SUNATimesFn)
{
  return kSundialsSuccess;  // products with the matrix are not needed
}

int initialize_callback(SUNLinearSolver)
{
  return kSundialsSuccess;
}

int setup_callback(SUNLinearSolver, SUNMatrix)
{
  return kSundialsSuccess;
}

int iterations_callback(SUNLinearSolver)
{
  return 1;
}

double norm_callback(SUNLinearSolver)
{
  return 0.0;
}

/// Solves with the tangent of the problem.
OwnedLinearSolver solver_of(Session& session, SUNContext context)
{
  OwnedLinearSolver linear = new_linear_solver(context);
  linear->content = &session;
  linear->ops->gettype = type_callback;
  linear->ops->setatimes = products_callback;
  linear->ops->numiters = iterations_callback;
  linear->ops->resnorm = norm_callback;
  linear->ops->initialize = initialize_callback;
  linear->ops->setup = setup_callback;
  linear->ops->solve = solve_callback;
  linear->ops->free = free_without_content;
  return linear;
}

/// The largest absolute residual at `u`; not finite where one is not.
double largest_residual(const NonlinearProblem& problem, const std::vector<double>& u)
{
  std::vector<double> residual(u.size());
  problem.residual(u.data(), residual.data());
  double largest = 0.0;
  for (double r : residual)
  {
    if (!(std::abs(r) <= largest)) largest = std::abs(r);
    if (!std::isfinite(r)) break;  // and stays
  }
  return largest;
}

struct FreeKinsol
{
  void operator()(void* memory) const { KINFree(&memory); }
};
}  // namespace

KinsolOutcome kinsol_solve(const NonlinearProblem& problem, double tolerance, int most_iterations, std::vector<double>& u)
{
  KinsolOutcome out;
  const auto n = static_cast<sunindextype>(u.size());
  const OwnedContext context = new_context();
  if (!context) return out;
  const OwnedVector x = vector_of(n, u.data(), context.get());
  const OwnedVector ones = new_vector(n, context.get());
  N_VConst(1.0, ones.get());
  Session session{&problem, u};
  const OwnedLinearSolver linear = solver_of(session, context.get());

  const std::unique_ptr<void, FreeKinsol> memory(new_kinsol(context.get()));
  void* kinsol = memory.get();
  silence_kinsol(kinsol);
  KINSetUserData(kinsol, &session);
  KINInit(kinsol, residual_callback, x.get());
  if (KINSetLinearSolver(kinsol, linear.get(), nullptr) != KINLS_SUCCESS) return out;
  KINSetFuncNormTol(kinsol, tolerance);
  KINSetScaledStepTol(kinsol, 1e-14);
  KINSetMaxNewtonStep(kinsol, 1e3);
  KINSetNumMaxIters(kinsol, std::max(1, most_iterations));  // 0 would mean its own default
  const int flag = KINSol(kinsol, x.get(), KIN_LINESEARCH, ones.get(), ones.get());
  long iterations = 0;
  KINGetNumNonlinSolvIters(kinsol, &iterations);
  out.iterations = static_cast<int>(iterations);
  out.residual = largest_residual(problem, u);
  // at round-off the line search finds nothing better and says that it failed: the residual judges
  out.converged = out.residual <= (flag >= 0 ? 10.0 : 1.0) * tolerance;
  return out;
}

}  // namespace drill_rig_sim
