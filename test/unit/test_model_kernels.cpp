// The batch kernels against node by node and element by element, and their tangents against finite differences.
#include <gtest/gtest.h>

#include <functional>

#include "tangent_check.h"

using namespace drill_rig_sim;

namespace
{
constexpr double rounding = 1e-12;  // of the terms summed, which are of the order of a row's stiffness times 1 m or 1 rad

std::vector<Kernel> wide_kernels()
{
  std::vector<Kernel> out;
  for (const Kernel kernel : all_kernels)
    if (kernel != Kernel::scalar && has_kernel(kernel)) out.push_back(kernel);
  return out;
}

/// A rig of the same scene and state whose model has that kernel.
struct Twin
{
  RigAtRest rest;
  Problem problem;

  Twin(const Scene& scene, Kernel kernel, const Rig& rig) : rest(of(scene, kernel, rig)), problem(rest, evaluate)
  {
    begin_step(problem.model, problem.start, tangent_step, rig.setpoints, problem.stage);
    prepare_bdf2(problem.start, tangent_step, problem.stage);
  }
  static RigAtRest of(Scene scene, Kernel kernel, const Rig& rig)
  {
    scene.numerics.kernel = kernel;
    return {std::make_shared<const Model>(scene, rig.rest.model->mesh()), rig.rest.state};
  }
};

struct System
{
  VectorXd residual;
  MatrixXd tangent;
};

System system_of(Problem& problem, const VectorXd& u)
{
  System out{VectorXd(u.size()), dense_tangent(problem, u)};
  VectorXd residual(u.size());
  problem.at(u, residual, nullptr);
  out.residual = by_coordinates(coordinates(problem), residual);
  return out;
}

/// In every kernel, at the next step's increments.
void expect_same(const Scene& scene, const Rig& rig)
{
  VectorXd u(6 * rig.rest.model->nodes());
  predict(rig.rest.state, tangent_step, u.data());
  Twin scalar(scene, Kernel::scalar, rig);
  const System expected = system_of(scalar.problem, u);
  for (const Kernel kernel : wide_kernels())
  {
    Twin twin(scene, kernel, rig);
    const System system = system_of(twin.problem, u);
    double worst_force = 0.0, worst_stiffness = 0.0;
    for (int row = 0; row < expected.residual.size(); ++row)
    {
      const double scale = expected.tangent.row(row).cwiseAbs().maxCoeff();
      worst_force = std::max(worst_force, std::abs(system.residual[row] - expected.residual[row]) / scale);
      worst_stiffness = std::max(worst_stiffness, (system.tangent.row(row) - expected.tangent.row(row)).cwiseAbs().maxCoeff() / scale);
    }
    EXPECT_LT(worst_force, rounding) << name_of(kernel);
    EXPECT_LT(worst_stiffness, rounding) << name_of(kernel);
    EXPECT_LT(worst_column(twin.problem, increments_without_tilt(rig), tangent_difference), 1e-6) << name_of(kernel);
  }
}

/// Lowered and turned a while by the scalar kernel.
Rig turned(Scene scene, double seconds)
{
  scene.numerics.kernel = Kernel::scalar;
  Rig rig(scene);
  rig.setpoints.winch = {-0.1, false};
  rig.setpoints.top_drive.speed = 60.0 * rpm;
  rig.run(seconds);
  return rig;
}
}  // namespace

// Strings of lengths that leave every number of elements over for the last batch.
TEST(ModelKernels, stringsOfAnyLength)
{
  for (double depth = 30.0; depth < 115.0; depth += 9.5)
  {
    const Scene scene = slanted_scene(depth, 0.3);
    SCOPED_TRACE(depth);
    expect_same(scene, turned(scene, 1.0));
  }
}

TEST(ModelKernels, bentAndWithGaugeInACurvedHole)
{
  const Scene scene = scene_in(build_and_hold(0.0, 0.1 * degree, 40.0 * degree, 2.0, 400.0), 400.0, 300.0, 0.3);
  expect_same(scene, turned(scene, 1.0));
}
