// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REFERENCE_IDA_SOLVER_H
#define DRILL_RIG_SIM_REFERENCE_IDA_SOLVER_H

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drill_rig_sim/reference/dae_problem.h"
#include "drill_rig_sim/solve/reference_report.h"

namespace drill_rig_sim
{
struct IdaOptions
{
  int max_order = 5;               ///< of the BDF formulas, 1 .. 5; beyond 2 they excite fast oscillations that are hardly damped
  double fixed_step = 0.0;         ///< > 0: smallest and largest step alike, to show what a given step does [s]
  bool suppress_algebraic = true;  ///< multipliers out of the error test
  long max_steps = 2000000;        ///< of one advance(), those repeated with a shorter step among them
  double newton_share = 0.1;       ///< of the tolerance, that Newton's method may leave; at IDA's 0.33 the rest fails error tests
};

/// SUNDIALS IDA: variable-order, variable-step BDF in fixed-leading-coefficient form, modified Newton with our sparse Jacobian
/// and KLU (Hindmarsh et al., SUNDIALS, ACM Trans. Math. Software 31 (2005), 363-396). A reference: it allocates and takes the
/// time it needs.
class IdaSolver
{
public:
  /// `problem` must outlive it.
  IdaSolver(DaeProblem& problem, const IdaOptions& options);
  ~IdaSolver();
  IdaSolver(const IdaSolver&) = delete;
  IdaSolver& operator=(const IdaSolver&) = delete;

  /// (Re)starts at order one from consistent values. False: refused.
  bool start(double t, const std::vector<double>& y, const std::vector<double>& rate);
  /// Sees the solution after each of IDA's steps.
  using Watcher = std::function<void(double t, const double* y, const double* rate)>;

  /// Integrates up to `t` exactly, the last steps before it of equal length; order and step go on from call to call. y, rate:
  /// solution at t. `after_step` may be empty.
  /// False: it could not; statistics().flag is the reason, y and rate are unchanged.
  bool advance(double t, std::vector<double>& y, std::vector<double>& rate, const Watcher& after_step = {});
  /// The last advance() ended because max_steps were not enough.
  bool too_much_work() const;
  /// IDA's name for statistics().flag.
  std::string flag_name() const;
  IdaStatistics statistics() const;

private:
  struct Session;
  std::unique_ptr<Session> session_;
};

}  // namespace drill_rig_sim

#endif
