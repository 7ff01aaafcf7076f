// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/solve/vector_operations.h"

#include <Eigen/Core>
#include <cmath>

#include "sundials.h"

namespace drill_rig_sim
{
namespace
{
Eigen::Map<Eigen::ArrayXd> numbers(N_Vector v)
{
  return {N_VGetArrayPointer(v), size_of(v)};
}

/// z = sum of c[k] x[k]; z may be x[0].
int combine(int count, double* c, N_Vector* x, N_Vector z)
{
  auto sum = numbers(z);
  sum = c[0] * numbers(x[0]);
  for (int k = 1; k < count; ++k) sum += c[k] * numbers(x[k]);
  return 0;
}
}  // namespace

void vectorise_operations(N_Vector vector)
{
  N_Vector_Ops operations = vector->ops;
  operations->nvlinearsum = [](double a, N_Vector x, double b, N_Vector y, N_Vector z)
  { numbers(z) = a * numbers(x) + b * numbers(y); };
  operations->nvlinearcombination = combine;
  operations->nvscale = [](double a, N_Vector x, N_Vector z) { numbers(z) = a * numbers(x); };
  operations->nvconst = [](double a, N_Vector z) { numbers(z) = a; };
  operations->nvwrmsnorm = [](N_Vector x, N_Vector weight) { return std::sqrt((numbers(x) * numbers(weight)).square().mean()); };
  operations->nvwrmsnormmask = [](N_Vector x, N_Vector weight, N_Vector mask)
  { return std::sqrt((numbers(mask) > 0.0).select(numbers(x) * numbers(weight), 0.0).square().mean()); };
}

}  // namespace drill_rig_sim
