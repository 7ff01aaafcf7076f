// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REFERENCE_DAE_PROBLEM_H
#define DRILL_RIG_SIM_REFERENCE_DAE_PROBLEM_H

#include <vector>

#include "drill_rig_sim/reference/sparse_jacobian.h"

namespace drill_rig_sim
{
/// A differential-algebraic system F(t, y, y') = 0.
class DaeProblem
{
public:
  virtual ~DaeProblem() = default;
  virtual int size() const = 0;
  /// True for the components whose derivative appears in F. The others (multipliers) stay out of the error test.
  virtual std::vector<bool> differential() const = 0;
  virtual void residual(double t, const double* y, const double* rate, double* f) = 0;
  /// dF/dy + c dF/dy', added to a matrix that is empty and finished by the caller.
  virtual void jacobian(double t, const double* y, const double* rate, double c, SparseJacobian& j) = 0;
  /// The error of y[k] that counts as 1 (tolerance), > 0.
  virtual void tolerances(const double* y, double* tolerance) const = 0;
};

}  // namespace drill_rig_sim

#endif
