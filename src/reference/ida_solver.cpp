// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/reference/ida_solver.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "drill_rig_sim/solve/vector_operations.h"
#include "../solve/sundials.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kEqualSteps = 8.0;
constexpr double kArrival = 100.0 * std::numeric_limits<double>::epsilon();  // so near the stop time IDA says that it is there

struct FreeIda
{
  void operator()(void* memory) const { IDAFree(&memory); }
};

bool finite(N_Vector v)
{
  const double* values = N_VGetArrayPointer(v);
  return std::all_of(values, values + size_of(v), [](double x) { return std::isfinite(x); });
}
}  // namespace

struct IdaSolver::Session
{
  DaeProblem& problem;
  IdaOptions options;
  SparseJacobian jacobian;
  // destroyed in the opposite order
  OwnedContext context;
  OwnedVector y, rate, id;
  OwnedMatrix matrix;
  OwnedLinearSolver linear;
  std::unique_ptr<void, FreeIda> memory;
  IdaStatistics before;  // of the runs before the last start(), IDA forgets them
  double smallest_step = HUGE_VAL;
  int flag = 0;

  Session(DaeProblem& p, const IdaOptions& o) : problem(p), options(o), jacobian(p.size()) {}
  bool create(double t);
  void set_options();
  bool set_linear_solver(double t);
  void write_matrix(SUNMatrix target) const;
  long attempts() const;
  bool go_to(double t, const Watcher& after_step);
  IdaStatistics current() const;

  static int residual_callback(double t, N_Vector y, N_Vector rate, N_Vector f, void* data);
  static int jacobian_callback(double t, double c, N_Vector y, N_Vector rate, N_Vector f, SUNMatrix matrix, void* data, N_Vector,
                               N_Vector, N_Vector);
  static int weight_callback(N_Vector y, N_Vector weight, void* data);
};

int IdaSolver::Session::residual_callback(double t, N_Vector y, N_Vector rate, N_Vector f, void* data)
{
  auto* session = static_cast<Session*>(data);
  session->problem.residual(t, N_VGetArrayPointer(y), N_VGetArrayPointer(rate), N_VGetArrayPointer(f));
  return finite(f) ? 0 : 1;  // 1: try a smaller step
}

int IdaSolver::Session::jacobian_callback(double t, double c, N_Vector y, N_Vector rate, N_Vector, SUNMatrix matrix, void* data,
                                          N_Vector, N_Vector, N_Vector)
{
  auto* session = static_cast<Session*>(data);
  session->jacobian.begin();
  session->problem.jacobian(t, N_VGetArrayPointer(y), N_VGetArrayPointer(rate), c, session->jacobian);
  if (session->jacobian.finish())
  {
    const auto nonzeros = static_cast<sunindextype>(session->jacobian.values().size());
    if (SUNSparseMatrix_Reallocate(matrix, nonzeros) != 0) return -1;
    if (SUNLinSol_KLUReInit(session->linear.get(), matrix, nonzeros, SUNKLU_REINIT_PARTIAL) != 0) return -1;
  }
  session->write_matrix(matrix);
  return 0;
}

int IdaSolver::Session::weight_callback(N_Vector y, N_Vector weight, void* data)
{
  auto* session = static_cast<Session*>(data);
  double* w = N_VGetArrayPointer(weight);
  session->problem.tolerances(N_VGetArrayPointer(y), w);
  for (sunindextype k = 0; k < size_of(weight); ++k) w[k] = 1.0 / w[k];
  return 0;
}

void IdaSolver::Session::write_matrix(SUNMatrix target) const
{
  std::copy(jacobian.column_starts().begin(), jacobian.column_starts().end(), SUNSparseMatrix_IndexPointers(target));
  std::copy(jacobian.rows().begin(), jacobian.rows().end(), SUNSparseMatrix_IndexValues(target));
  std::copy(jacobian.values().begin(), jacobian.values().end(), SUNSparseMatrix_Data(target));
}

bool IdaSolver::Session::set_linear_solver(double t)
{
  jacobian.begin();
  problem.jacobian(t, N_VGetArrayPointer(y.get()), N_VGetArrayPointer(rate.get()), 1.0, jacobian);
  jacobian.finish();
  const auto n = static_cast<sunindextype>(problem.size());
  matrix = new_sparse_matrix(n, static_cast<sunindextype>(jacobian.values().size()), context.get());
  write_matrix(matrix.get());
  linear = new_klu(y.get(), matrix.get(), context.get());
  return linear && IDASetLinearSolver(memory.get(), linear.get(), matrix.get()) == IDA_SUCCESS &&
         IDASetJacFn(memory.get(), jacobian_callback) == IDA_SUCCESS;
}

void IdaSolver::Session::set_options()
{
  void* ida = memory.get();
  silence_ida(ida);
  IDASetUserData(ida, this);
  IDAWFtolerances(ida, weight_callback);
  IDASetId(ida, id.get());
  IDASetSuppressAlg(ida, options.suppress_algebraic ? SUNTRUE : SUNFALSE);
  IDASetMaxOrd(ida, options.max_order);
  IDASetMaxNumSteps(ida, options.max_steps);
  IDASetNonlinConvCoef(ida, options.newton_share);
  if (options.fixed_step <= 0.0) return;
  IDASetInitStep(ida, options.fixed_step);
  set_smallest_step(ida, options.fixed_step);
  IDASetMaxStep(ida, options.fixed_step);
}

bool IdaSolver::Session::create(double t)
{
  memory.reset(new_ida(context.get()));
  if (!memory || IDAInit(memory.get(), residual_callback, t, y.get(), rate.get()) != IDA_SUCCESS) return false;
  set_options();
  return set_linear_solver(t);
}

/// Steps tried since the last start: those taken and those that failed and were repeated.
long IdaSolver::Session::attempts() const
{
  long steps = 0, error_test_failures = 0, newton_failures = 0;
  IDAGetNumSteps(memory.get(), &steps);
  IDAGetNumErrTestFails(memory.get(), &error_test_failures);
  IDAGetNumNonlinSolvConvFails(memory.get(), &newton_failures);
  return steps + error_test_failures + newton_failures;
}

/// The last steps to `t` are of equal length: a stump would have to grow again by doubling, with a new Jacobian each time.
bool IdaSolver::Session::go_to(double t, const Watcher& after_step)
{
  void* const ida = memory.get();
  const long before = attempts();
  while (attempts() - before < options.max_steps)
  {
    double now = 0.0, next = 0.0, reached = 0.0;
    IDAGetCurrentTime(ida, &now);
    IDAGetCurrentStep(ida, &next);  // 0: not chosen yet
    const double left = t - now;
    const double round_off = 0.5 * kArrival * (std::abs(t) + next);
    const double parts = next > 0.0 ? std::ceil((left - round_off) / next) : 1.0;
    const bool last = parts <= 1.0 || parts > kEqualSteps;
    IDASetStopTime(ida, last ? t : now + std::min(left / parts, next));
    flag = IDASolve(ida, t, &reached, y.get(), rate.get(), IDA_ONE_STEP);
    if (flag < 0) return false;
    if (after_step) after_step(reached, N_VGetArrayPointer(y.get()), N_VGetArrayPointer(rate.get()));
    if (last && flag == IDA_TSTOP_RETURN) return true;
  }
  flag = IDA_TOO_MUCH_WORK;
  return false;
}

IdaStatistics IdaSolver::Session::current() const
{
  IdaStatistics s;
  void* ida = memory.get();
  if (!ida) return s;
  long steps = 0, residuals = 0, setups = 0, failures = 0, iterations = 0, newton_failures = 0;
  int order = 0, next_order = 0;
  double first = 0.0, last = 0.0, next = 0.0, time = 0.0;
  IDAGetIntegratorStats(ida, &steps, &residuals, &setups, &failures, &order, &next_order, &first, &last, &next, &time);
  IDAGetNonlinSolvStats(ida, &iterations, &newton_failures);
  s.steps = static_cast<std::uint64_t>(steps);
  s.residuals = static_cast<std::uint64_t>(residuals);
  s.jacobians = static_cast<std::uint64_t>(setups);
  s.newton_iterations = static_cast<std::uint64_t>(iterations);
  s.error_test_failures = static_cast<std::uint64_t>(failures);
  s.newton_failures = static_cast<std::uint64_t>(newton_failures);
  s.last_order = order;
  s.last_step = last;
  return s;
}

IdaSolver::IdaSolver(DaeProblem& problem, const IdaOptions& options) : session_(std::make_unique<Session>(problem, options))
{
  session_->context = new_context();
  SUNContext const context = session_->context.get();
  if (!context) throw std::runtime_error("IDA: SUNDIALS could not create a context");
  const auto n = static_cast<sunindextype>(problem.size());
  session_->y = new_vector(n, context);
  vectorise_operations(session_->y.get());
  session_->rate.reset(N_VClone(session_->y.get()));
  session_->id.reset(N_VClone(session_->y.get()));
  const std::vector<bool> differential = problem.differential();
  for (std::size_t k = 0; k < differential.size(); ++k) N_VGetArrayPointer(session_->id.get())[k] = differential[k] ? 1.0 : 0.0;
}

IdaSolver::~IdaSolver() = default;

bool IdaSolver::start(double t, const std::vector<double>& y, const std::vector<double>& rate)
{
  Session& s = *session_;
  s.before = statistics();
  ++s.before.starts;
  std::copy(y.begin(), y.end(), N_VGetArrayPointer(s.y.get()));
  std::copy(rate.begin(), rate.end(), N_VGetArrayPointer(s.rate.get()));
  if (!s.memory) return s.create(t);
  return IDAReInit(s.memory.get(), t, s.y.get(), s.rate.get()) == IDA_SUCCESS;
}

bool IdaSolver::advance(double t, std::vector<double>& y, std::vector<double>& rate, const Watcher& after_step)
{
  Session& s = *session_;
  if (!s.memory) return false;
  if (!s.go_to(t, after_step) || !finite(s.y.get()) || !finite(s.rate.get())) return false;
  std::copy_n(N_VGetArrayPointer(s.y.get()), y.size(), y.begin());
  std::copy_n(N_VGetArrayPointer(s.rate.get()), rate.size(), rate.begin());
  double last = 0.0;
  IDAGetLastStep(s.memory.get(), &last);
  if (last > 0.0) s.smallest_step = std::min(s.smallest_step, last);
  return true;
}

bool IdaSolver::too_much_work() const
{
  return session_->flag == IDA_TOO_MUCH_WORK;
}

std::string IdaSolver::flag_name() const
{
  char* text = IDAGetReturnFlagName(session_->flag);
  std::string name = text ? text : "";
  std::free(text);
  return name;
}

IdaStatistics IdaSolver::statistics() const
{
  IdaStatistics s = session_->current();
  s.add(session_->before);
  s.smallest_step = std::isfinite(session_->smallest_step) ? session_->smallest_step : 0.0;
  s.flag = session_->flag;
  return s;
}

}  // namespace drill_rig_sim
